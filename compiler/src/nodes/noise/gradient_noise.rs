use crate::emit::functions::gradient_noise::gradient_noise;
use crate::emit::{Color, Real, Vector};
use crate::nodes::finite::{FACTOR, SUMMAND};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Perlin's noise with gradients by a hash: `noise amplitude + pivot`, signed, near -1 to 1, 0 (the
    /// pivot) where all coordinates are whole. It never repeats. MaterialX's `noise2d` and `noise3d`, OSL's
    /// `noise("perlin")` and Cycles' noise of one octave have the same values.
    ///
    /// `vector` and `color` are three noises; the first of each is `result`. The eight gradients of a
    /// cell are mixed by `t^3 (t (6 t - 15) + 10)`.
    ///
    /// Trap: numbers of 32 bits have no fractions from 2^24 on, where the noise is the pivot; 10^6 from
    /// the origin a cell has 16 steps. A value is known to 9 10^-6 of the amplitude.
    gradient_noise in noise,
    source "Perlin 2002, Improving Noise; Jenkins 2006, lookup3; Gritz et al. 2010, Open Shading Language",
    inputs {
        /// Where to look; the first `dimensions` coordinates count.
        position: vector = state(Field::Point), in FACTOR;
        /// How many coordinates count: 2 for uv; the fourth is `w`.
        dimensions: count = 3, in 1.0..=4.0;
        /// The fourth coordinate, often the time.
        w: scalar = 0.0, in FACTOR, when e.mask(i.dimensions == 4);
        /// Factor on the noise.
        amplitude: scalar = 1.0, in FACTOR;
        /// What is added: 0.5 with an amplitude of 0.5 gives 0 to 1.
        pivot: scalar = 0.0, in SUMMAND;
    }
    outputs {
        /// The noise.
        result: scalar;
        /// Three noises.
        vector: vector;
        /// The same three as a colour.
        color: color;
    }
    body |e, i| {
        let Vector { x, y, z } = i.position;
        let noises = match i.dimensions {
            1 => gradient_noise(e, [x]),
            2 => gradient_noise(e, [x, y]),
            3 => gradient_noise(e, [x, y, z]),
            _ => gradient_noise(e, [x, y, z, i.w]),
        };
        let x = noises[0].mul_add(i.amplitude, i.pivot);
        let y = noises[1].mul_add(i.amplitude, i.pivot);
        let z = noises[2].mul_add(i.amplitude, i.pivot);
        let vector = Vector { x, y, z };
        Outputs { result: x, vector, color: Color { r: x, g: y, b: z, a: e.real(1.0) } }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn values_that_materialx_and_cycles_agree_on() {
        for (position, value) in [
            ([0.25, 0.5, 0.75], 0.2086957),
            ([1.3, -2.7, 0.4], 0.397828),
            ([10.01, 0.33, 5.5], 0.3924864),
        ] {
            assert_close(&numbers!(position = position => result), &[value], 0.0, 2e-6);
        }
        let flat = numbers!(position = [0.25, 0.5, 9.9], dimensions = 2 => result);
        assert_close(&flat, &[0.2224178], 0.0, 1e-6);
    }

    #[test]
    fn it_is_nothing_at_whole_numbers_in_any_dimension() {
        for dimensions in 1..=4 {
            for position in [[0.0; 3], [-3.0, 2.0, 7.0], [1e6, -1e9, 1e19], [-16_777_217.0; 3]] {
                let value =
                    numbers!(position = position, dimensions = dimensions, w = -5.0 => vector);
                assert_eq!(value, [0.0; 3], "{position:?}");
            }
        }
    }

    #[test]
    fn it_is_continuous_where_cells_meet_and_beside_nothing() {
        for whole in [0.0_f32, -3.0, 4.0, 1e6, -1e6] {
            let at = |x: f32| number!(position = [x, 0.3, 0.6] => result);
            for beside in [whole.next_down(), whole.next_up()] {
                let apart = (at(beside) - at(whole)).abs();
                assert!(apart <= 4.0 * (beside - whole).abs() + 1e-6, "{whole}: {apart}");
            }
        }
        let beside = number!(position = [-1e-30, 0.3, 0.6] => result);
        let at = numbers!(position = [0.0, 0.3, 0.6] => result);
        assert_close(&at, &[f64::from(beside)], 0.0, 1e-6);
    }

    #[test]
    fn outputs_are_one_noise_scaled_and_lifted() {
        let position = [0.3, -7.1, 2.9];
        let [x, y, z] = numbers!(position = position => vector)[..] else { unreachable!() };
        assert_eq!(number!(position = position => result), x);
        assert_eq!(numbers!(position = position => color), [x, y, z, 1.0]);
        assert!(x != y && y != z);
        let lifted = number!(position = position, amplitude = 0.5, pivot = 0.5 => result);
        assert_eq!(lifted, x * 0.5 + 0.5);
    }

    #[test]
    fn a_fourth_coordinate_counts_in_four_dimensions_only() {
        assert!(!demanded!(dimensions = 3 => w) && demanded!(dimensions = 4 => w));
        let at = |w: f32| number!(position = [0.3, 0.6, 0.2], dimensions = 4, w = w => result);
        assert!(at(0.25) != at(0.5));
    }
}
