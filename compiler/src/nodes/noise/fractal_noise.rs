use crate::emit::functions::gradient_noise::{Octaves, fractal};
use crate::emit::{Color, Mask, Real, Vector};
use crate::nodes::finite::{FACTOR, SUMMAND, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// `gradient_noise` summed over octaves: each has the position of the one before times `lacunarity`,
    /// and counts `gain` times as much. The sum is scaled by `amplitude`, and `pivot` is added.
    /// Turbulence sums magnitudes.
    ///
    /// The sum is that of MaterialX's `fractal2d` and `fractal3d` (`gain` is their `diminish`), which is not
    /// divided by the sum of shares: three octaves reach 1.75. `normalize` divides by it, as Blender does.
    fractal_noise in noise,
    source "Perlin 1985, An Image Synthesizer; Musgrave 1989, fractal sums; see gradient_noise",
    inputs {
        /// Where to look; the first `dimensions` coordinates count.
        position: vector = state(Field::Point), in FACTOR;
        /// How many coordinates count: 2 for uv; the fourth is `w`.
        dimensions: count = 3, in 1.0..=4.0;
        /// The fourth coordinate, often the time.
        w: scalar = 0.0, in FACTOR, when e.mask(i.dimensions == 4);
        /// How many octaves are summed.
        octaves: count = 3, in 1.0..=8.0;
        /// Factor on the position from one octave to the next.
        lacunarity: scalar = 2.0, in -16.0..=16.0, soft 1.5..=3.0;
        /// Factor on the share from one octave to the next.
        gain: scalar = 0.5, in -16.0..=16.0, soft UNIT;
        /// What is summed.
        kind: choice = 0, of ["noise", "turbulence"];
        /// Whether the sum is divided by that of the shares' magnitudes.
        normalize: boolean = false;
        /// Factor on the sum.
        amplitude: scalar = 1.0, in FACTOR;
        /// What is added.
        pivot: scalar = 0.0, in SUMMAND;
    }
    outputs {
        /// The sum.
        result: scalar;
        /// Three sums.
        vector: vector;
        /// The same three as a colour.
        color: color;
    }
    body |e, i| {
        let Vector { x, y, z } = i.position;
        let octaves = Octaves {
            count: i.octaves,
            lacunarity: i.lacunarity,
            gain: i.gain,
            turbulent: i.kind == 1,
        };
        let sums = match i.dimensions {
            1 => fractal(e, [x], octaves),
            2 => fractal(e, [x, y], octaves),
            3 => fractal(e, [x, y, z], octaves),
            _ => fractal(e, [x, y, z, i.w], octaves),
        };
        let mut shares = e.real(1.0);
        for _ in 1..i.octaves {
            shares = shares.mul_add(i.gain.absolute(), e.real(1.0));
        }
        let amplitude = i.normalize.select(i.amplitude / shares, i.amplitude);
        let x = sums[0].mul_add(amplitude, i.pivot);
        let y = sums[1].mul_add(amplitude, i.pivot);
        let z = sums[2].mul_add(amplitude, i.pivot);
        let vector = Vector { x, y, z };
        Outputs { result: x, vector, color: Color { r: x, g: y, b: z, a: e.real(1.0) } }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn a_value_of_materialx_and_cycles() {
        let sum = numbers!(position = [0.25, 0.5, 0.75] => result);
        assert_close(&sum, &[0.270071], 0.0, 1e-6);
    }

    #[test]
    fn octaves_are_noises_of_their_own() {
        let one = |at: [f32; 3]| number!(position = at, octaves = 1 => result);
        let (first, second) = (one([0.3, 1.7, -2.6]), one([0.9, 5.1, -7.8]));
        let sum = numbers!(position = [0.3, 1.7, -2.6], octaves = 2, lacunarity = 3.0, gain = -0.25 => result);
        assert_close(&sum, &[f64::from(first - 0.25 * second)], 1e-6, 1e-6);
        let turbulence = numbers!(position = [0.3, 1.7, -2.6], octaves = 2, lacunarity = 3.0, kind = 1 => result);
        assert_close(&turbulence, &[f64::from(first.abs() + 0.5 * second.abs())], 1e-6, 1e-6);
    }

    #[test]
    fn normalized_sums_are_shares_of_all() {
        let position = [4.2, -0.7, 1.3];
        let sum = number!(position = position, octaves = 4 => result);
        let normalized = numbers!(position = position, octaves = 4, normalize = true => result);
        assert_close(&normalized, &[f64::from(sum) / 1.875], 1e-6, 0.0);
    }

    #[test]
    fn octaves_beyond_all_numbers_add_nothing() {
        let far =
            numbers!(position = [1e19, -1e19, 1e19], octaves = 8, lacunarity = 16.0 => vector);
        assert_eq!(far, [0.0; 3]);
    }
}
