//! Hashes that key all random numbers.

/// Spreads every bit of `x` over all bits of the result: a bijection (the finaliser of SplitMix64
/// with Stafford's constants, variant 13).
#[inline]
pub fn mixed(x: u64) -> u64 {
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

/// Key of what happens at request site `site` on the path with key `parent`.
#[inline]
pub fn child_path(parent: u64, site: u64) -> u64 {
    mixed(mixed(parent ^ 0x9e37_79b9_7f4a_7c15).wrapping_add(site))
}

/// Key of a camera path: of sample `sample` of the pixel at column `x` and row `y`.
#[inline]
pub fn path_key(seed: u64, x: u32, y: u32, sample: u32) -> u64 {
    let pixel = child_path(seed, u64::from(x) << 32 | u64::from(y));
    child_path(pixel, u64::from(sample))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn keys_of_neighbours_differ() {
        let mut keys = HashSet::new();
        for seed in 0..3 {
            for x in 0..16 {
                for y in 0..16 {
                    for sample in 0..16 {
                        assert!(keys.insert(path_key(seed, x, y, sample)));
                    }
                }
            }
        }
        assert_ne!(child_path(1, 2), child_path(2, 1));
    }

    #[test]
    fn one_bit_in_changes_about_half_of_the_bits_out() {
        let flips: u32 = (0..64).map(|bit| (mixed(77) ^ mixed(77 ^ (1 << bit))).count_ones()).sum();
        assert!((28 * 64..36 * 64).contains(&flips), "{flips}");
    }
}
