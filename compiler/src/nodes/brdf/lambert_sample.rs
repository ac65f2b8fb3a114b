use crate::emit::functions::lobes::{cosine_density, cosine_direction};
use crate::nodes::finite::UNIT;
use crate::nodes::{NOT_NEGATIVE, state};
use crate::state::Field;

node! {
    /// A direction about the normal, as dense as the cosine from it: what suits `lambert_brdf`, `oren_nayar_brdf`,
    /// `sheen_brdf` and the ground of `ashikhmin_shirley_brdf`.
    lambert_sample in brdf,
    source "Malley's method; Pharr, Jakob and Humphreys, Physically Based Rendering, 13.6",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// First number the direction is drawn by, 0 to below 1; by default that of the sample.
        first: scalar = state(Field::SampleU), in UNIT;
        /// Second number the direction is drawn by, 0 to below 1; by default that of the sample.
        second: scalar = state(Field::SampleV), in UNIT;
    }
    outputs {
        /// Unit direction towards where the light comes from.
        direction: vector, in -1.0..=1.0;
        /// Density of that direction, per steradian.
        density: scalar, in NOT_NEGATIVE;
    }
    body |e, i| {
        let direction = cosine_direction(i.normal, i.first, i.second);
        Outputs { direction, density: cosine_density(i.normal, direction) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_first_number_is_the_squared_sine() {
        let direction = numbers!(first = 0.36, second = 0.0 => direction);
        crate::nodes::harness::assert_close(&direction, &[0.6, 0.0, 0.8], 1e-6, 1e-7);
        crate::nodes::harness::assert_close(
            &numbers!(first = 0.36, second = 0.25 => density),
            &[0.8 / std::f64::consts::PI],
            1e-6,
            0.0,
        );
    }
}
