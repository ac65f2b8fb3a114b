//! Positions of a light's samples.

use super::hash::child_path;
use super::pixel::second_dimension;

/// Where, in both directions across light number `light`, sample `sample` lies for the point with key `path`:
/// above 0 and below 1. Sobol's first two dimensions, digits flipped by a key of point and light, which keeps
/// every power of two of samples stratified.
pub fn light_position(path: u64, light: u32, sample: u32) -> [f64; 2] {
    let scramble = child_path(path ^ 0x4c69_6768_7473, u64::from(light));
    let first = sample.reverse_bits() ^ scramble as u32;
    let second = second_dimension(sample) ^ (scramble >> 32) as u32;
    [first, second].map(|bits| (f64::from(bits) + 0.5) / 4_294_967_296.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_of_a_point_fill_all_strata_and_points_differ() {
        let mut seen = std::collections::HashSet::new();
        for path in 0..40 {
            let mut strata = [0; 16];
            for sample in 0..16 {
                let [u, v] = light_position(path, 1, sample);
                strata[(v * 4.0) as usize * 4 + (u * 4.0) as usize] += 1;
            }
            assert_eq!(strata, [1; 16]);
            seen.insert(light_position(path, 1, 0).map(f64::to_bits));
            seen.insert(light_position(path, 2, 0).map(f64::to_bits));
        }
        assert_eq!(seen.len(), 80);
    }
}
