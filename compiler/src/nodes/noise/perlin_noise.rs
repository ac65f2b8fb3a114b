use crate::emit::Real;
use crate::emit::functions::permutation_noise::permutation_noise;
use crate::nodes::finite::{FACTOR, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Perlin's improved noise in three dimensions, summed over octaves: each has the position of the
    /// one before times `lacunarity`, and counts `gain` times as much. It is smooth, and 0 where all
    /// coordinates are whole. Where `lacunarity` is whole it repeats every 256 units, as far as no octave's
    /// coordinates reach 2^31. Turbulence sums magnitudes.
    ///
    /// The gradient of a corner of the unit cube is chosen by the published permutation, and the eight
    /// are mixed by `t^3 (t (6 t - 15) + 10)`, whose first two derivatives vanish at the corners.
    perlin_noise in noise,
    source "Perlin 2002, Improving Noise; Perlin 1985, An Image Synthesizer, for turbulence",
    inputs {
        /// Where to look.
        position: vector = state(Field::Point), in FACTOR;
        /// How many octaves are summed.
        octaves: count = 1, in 1.0..=8.0;
        /// Factor on the position from one octave to the next.
        lacunarity: scalar = 2.0, in 1.0..=4.0;
        /// Factor on the share from one octave to the next.
        gain: scalar = 0.5, in UNIT;
        /// What is summed.
        kind: choice = 0, of ["noise", "turbulence"];
    }
    outputs {
        /// The sum; one octave of noise lies between -1.04 and 1.04.
        result: scalar, in -9.0..=9.0;
    }
    body |e, i| {
        let (mut position, mut share) = (i.position, e.real(1.0));
        let mut sum = e.real(0.0);
        for octave in 0..i.octaves {
            if octave > 0 {
                position = position * i.lacunarity;
                share = share * i.gain;
            }
            let noise = permutation_noise(e, position);
            sum = share.mul_add(if i.kind == 0 { noise } else { noise.absolute() }, sum);
        }
        Outputs { result: sum }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    #[expect(clippy::approx_constant, reason = "the point others try the published program at")]
    fn known_values() {
        // Of the published program, in 64 bits.
        for (position, exact) in [
            ([3.14, 42.0, 7.0], 0.13692005499327092),
            ([0.5, 0.5, 0.5], -0.25),
            ([-1.25, 2.75, 0.125], -0.061031328077660874),
            ([255.5, 256.25, -0.75], -0.41210269927978516),
            ([10.3, -20.7, 30.1], -0.11302386689767453),
        ] {
            assert_close(&numbers!(position = position => result), &[exact], 1e-6, 1e-6);
        }
    }

    #[test]
    fn octaves_are_summed() {
        let position = [0.3, 1.7, -2.6];
        for (octaves, noise, turbulence) in [
            (1, -0.3315784406042471, 0.3315784406042471),
            (2, -0.5950465727712771, 0.5950465727712771),
            (4, -0.5273407574834752, 0.7241218493807617),
        ] {
            let sum = numbers!(position = position, octaves = octaves => result);
            assert_close(&sum, &[noise], 2e-6, 1e-6);
            let sum = numbers!(position = position, octaves = octaves, kind = 1 => result);
            assert_close(&sum, &[turbulence], 2e-6, 1e-6);
        }
        let same = numbers!(position = position, octaves = 2, gain = 0.0 => result);
        assert_eq!(same, numbers!(position = position => result));
    }

    #[test]
    fn it_is_nothing_at_whole_numbers_and_repeats() {
        for position in [[0.0; 3], [1.0, -2.0, 3.0], [300.0, 17.0, -513.0], [1e9, 1.0, 2.0]] {
            assert_eq!(number!(position = position, octaves = 3 => result), 0.0);
        }
        let here = number!(position = [0.5, 1.25, -2.75] => result);
        assert_eq!(number!(position = [256.5, 1.25, -258.75] => result), here);
    }
}
