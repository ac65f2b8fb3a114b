//! Positions of a pixel's samples.

use super::hash::child_path;

/// Where sample `sample` of `samples` lies in its pixel, each coordinate in 0..1: the first two
/// dimensions of Sobol's sequence, digits flipped by a key of the pixel, which keeps every power of
/// two of samples stratified. A single sample lies in the middle.
pub fn pixel_position(seed: u64, x: u32, y: u32, sample: u32, samples: u32) -> [f32; 2] {
    if samples == 1 {
        return [0.5; 2];
    }
    let scramble = child_path(seed ^ 0x5069_7865_6c73, u64::from(x) << 32 | u64::from(y));
    let first = sample.reverse_bits() ^ scramble as u32;
    let second = second_dimension(sample) ^ (scramble >> 32) as u32;
    // 24 bits, so that the largest stays below 1.
    [first, second].map(|bits| (bits >> 8) as f32 / (1 << 24) as f32)
}

/// Sobol's second dimension, by its generator matrix.
pub(super) fn second_dimension(mut index: u32) -> u32 {
    let (mut column, mut bits) = (1 << 31, 0);
    while index != 0 {
        if index & 1 != 0 {
            bits ^= column;
        }
        index >>= 1;
        column ^= column >> 1;
    }
    bits
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sixteen_samples_fill_every_shape_of_sixteen_strata() {
        for (columns, rows) in [(16, 1), (8, 2), (4, 4), (2, 8), (1, 16)] {
            let mut strata = [0; 16];
            for sample in 0..16 {
                let [x, y] = pixel_position(3, 5, 7, sample, 16);
                let column = (x * columns as f32) as usize;
                let row = (y * rows as f32) as usize;
                strata[row * columns + column] += 1;
            }
            assert_eq!(strata, [1; 16], "{columns} x {rows}");
        }
    }

    #[test]
    fn positions_lie_in_the_pixel_and_differ_between_pixels() {
        let mut seen = std::collections::HashSet::new();
        for x in 0..50 {
            let [u, v] = pixel_position(0, x, 1, 3, 4);
            assert!((0.0..1.0).contains(&u) && (0.0..1.0).contains(&v));
            seen.insert((u.to_bits(), v.to_bits()));
        }
        assert_eq!(seen.len(), 50);
    }
}
