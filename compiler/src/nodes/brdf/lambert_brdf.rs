use crate::emit::functions::facets::lit;
use crate::emit::functions::reflected::shown;
use crate::nodes::finite::UNIT;
use crate::nodes::{NOT_NEGATIVE, WHITE, state};
use crate::state::Field;

node! {
    /// Ideal diffuse reflectance, `color / pi`. Draw directions by `lambert_sample`. Reciprocal; it reflects
    /// the share `color` of all light.
    lambert_brdf in brdf,
    source "Lambert 1760, Photometria",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Share of light reflected.
        color: color = WHITE, in UNIT;
    }
    outputs {
        /// The reflectance, per steradian; alpha is 1.
        value: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let shows = lit(i.normal, i.direction, i.ray);
        Outputs { value: shown(shows, i.color * e.real(1.0 / std::f64::consts::PI)) }
    }
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn is_the_same_from_everywhere_above() {
        let value = numbers!(normal = UP, direction = [0.6, 0.0, 0.8], ray = DOWN, color = [0.5, 0.25, 0.0, 0.3] => value);
        crate::nodes::harness::assert_close(
            &value,
            &[0.15915494309189535, 0.07957747154594767, 0.0, 1.0],
            1e-7,
            0.0,
        );
    }
}
