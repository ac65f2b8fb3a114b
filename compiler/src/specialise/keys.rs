//! Keys of random numbers: a contract with the renderer, the same in every build and on every
//! platform. Of a path of names, and of a request's site below it.

/// The key of an empty path.
pub(super) const PATH_KEY: u64 = 0xcbf2_9ce4_8422_2325;

/// The key of a path with `text` appended: FNV-1a, stable across builds and platforms.
pub(super) fn path_key(key: u64, text: &str) -> u64 {
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    text.bytes().fold(key, step)
}

/// A bijective mix of 64 bits in which every input bit moves half of the output's.
pub fn mix_key(mut key: u64) -> u64 {
    key ^= key >> 32;
    key = key.wrapping_mul(0xe9846af9b1a615d);
    key ^= key >> 32;
    key = key.wrapping_mul(0xe9846af9b1a615d);
    key ^ (key >> 28)
}
