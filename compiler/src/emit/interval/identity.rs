//! What a value is known by.

/// The number of an operation, from its name.
pub const fn tag(name: &str) -> u64 {
    let (bytes, mut hash, mut at) = (name.as_bytes(), 0xcbf2_9ce4_8422_2325_u64, 0);
    while at < bytes.len() {
        hash = (hash ^ bytes[at] as u64).wrapping_mul(0x0000_0100_0000_01b3);
        at += 1;
    }
    hash
}

/// The identity of what an operation makes of operands; 0, that of nothing known, where one of them
/// has that. Hashes of 64 bits: that two values are taken for one by chance is left out of account.
pub fn derived(operation: u64, operands: &[u64]) -> u64 {
    const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;
    let mut hash = operation;
    for &operand in operands {
        if operand == 0 {
            return 0;
        }
        let mixed = (hash.rotate_left(23) ^ operand).wrapping_mul(FACTOR);
        hash = mixed ^ (mixed >> 29);
    }
    hash
}
