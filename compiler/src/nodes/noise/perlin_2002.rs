use crate::emit::functions::permutation_noise::permutation_noise;
use crate::nodes::finite::FACTOR;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Perlin's improved noise as published: one octave in three dimensions, by the permutation of the
    /// paper. It is 0 where all coordinates are whole, and repeats every 256 units. `perlin_noise` is
    /// its sum over octaves; `gradient_noise`, with a hash in place of the permutation, never repeats.
    perlin_2002 in noise,
    source "Perlin 2002, Improving Noise",
    inputs {
        /// Where to look.
        position: vector = state(Field::Point), in FACTOR;
    }
    outputs {
        /// The noise.
        result: scalar, in -1.04..=1.04;
    }
    body |e, i| Outputs { result: permutation_noise(e, i.position) }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    /// Positions are the nearest numbers of 32 bits; the slope of the noise is at most 3, so a value
    /// of 64 bits is met to 3 half units of the largest coordinate.
    #[test]
    #[expect(clippy::approx_constant, reason = "the point others try the published program at")]
    fn known_values() {
        for (position, exact, bound) in [
            ([3.14, 42.0, 7.0], 0.13691995878400012, 4e-7),
            ([-4.2, 10.0, 6.0], 0.14208000000000004, 8e-7),
            ([1e-9, 0.3, 0.7], 0.19151396476616006, 2e-7),
            ([256.25, 0.25, 0.25], 0.2402900755405426, 2e-7),
            ([0.25, 0.25, 0.25], 0.2402900755405426, 2e-7),
            ([0.5, 0.5, 0.5], -0.25, 0.0),
        ] {
            assert_close(&numbers!(position = position => result), &[exact], 0.0, bound);
        }
    }

    #[test]
    fn it_is_nothing_at_whole_numbers_and_repeats() {
        for position in [[0.0; 3], [-1.0, 2.0, 3.0], [1e9, -1e6, 16_777_217.0], [-1e19; 3]] {
            assert_eq!(number!(position = position => result), 0.0);
        }
        let here = number!(position = [0.5, 1.25, -2.75] => result);
        assert_eq!(number!(position = [256.5, -254.75, 253.25] => result), here);
    }
}
