//! Keys of random numbers: a contract with the renderer, the same in every build and on every
//! platform. Of a path of names, of a request's site below it, and of what a loop over samples draws.

/// The key of an empty path.
pub(super) const PATH_KEY: u64 = 0xcbf2_9ce4_8422_2325;

/// The key of a path with `text` appended: FNV-1a, stable across builds and platforms.
pub(super) const fn path_key(mut key: u64, text: &str) -> u64 {
    let (bytes, mut at) = (text.as_bytes(), 0);
    // No iterator, for constants are made of it.
    while at < bytes.len() {
        key = (key ^ bytes[at] as u64).wrapping_mul(0x0000_0100_0000_01b3);
        at += 1;
    }
    key
}

/// The site of a node: of a request, or of a loop over samples. A path is the names of the scopes and loops
/// the node belongs to, outermost first, and its own, joined by `/`; those of an inner phenomenon's nodes
/// begin with the name of its node and `/`. A node belongs to the loop only if its value may differ there
/// from turn to turn.
pub const fn site(path: &str) -> u64 {
    mix_key(path_key(PATH_KEY, path))
}

/// The key of a site in one turn of a loop round it; of several loops, the outermost comes first.
pub fn iteration_key(key: u64, iteration: usize) -> u64 {
    mix_key(key ^ mix_key(iteration as u64 + 1))
}

/// The two numbers, from 0 to below 1, that are drawn on a path for a turn of a loop over samples, whose
/// key is the [`iteration_key`] of the loop's site.
pub fn drawn(path: u64, key: u64) -> [f32; 2] {
    numbers(mix_key(path ^ key))
}

/// Two numbers of 24 bits each.
fn numbers(key: u64) -> [f32; 2] {
    [key >> 40, key >> 16 & 0xff_ffff].map(|bits| bits as f32 / 16_777_216.0)
}

/// A bijective mix of 64 bits in which every input bit moves half of the output's.
pub const fn mix_key(mut key: u64) -> u64 {
    key ^= key >> 32;
    key = key.wrapping_mul(0xe9846af9b1a615d);
    key ^= key >> 32;
    key = key.wrapping_mul(0xe9846af9b1a615d);
    key ^ (key >> 28)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_drawn_below_one() {
        assert_eq!(numbers(u64::MAX), [1.0 - 2.0_f32.powi(-24); 2]);
        assert_eq!(numbers(0xffff), [0.0, 0.0]);
        assert_eq!(numbers(1 << 63 | 1 << 39), [0.5, 0.5]);
    }

    #[test]
    fn a_path_is_hashed_name_by_name_or_at_once() {
        let loops = path_key(path_key(PATH_KEY, "around"), "/");
        assert_eq!(site("around/mirror"), mix_key(path_key(loops, "mirror")));
    }
}
