use crate::emit::functions::lobes::cosine_density;
use crate::nodes::{NOT_NEGATIVE, state};
use crate::state::Field;

node! {
    /// Density of a direction among those of `lambert_sample`: `max(0, n·l) / pi`.
    lambert_density in brdf,
    source "",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
    }
    outputs {
        /// The density, per steradian.
        density: scalar, in NOT_NEGATIVE;
    }
    body |e, i| Outputs { density: cosine_density(i.normal, i.direction) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_none_below() {
        let up = [0.0, 0.0, 1.0];
        assert_eq!(number!(normal = up, direction = up => density), std::f32::consts::FRAC_1_PI);
        assert_eq!(number!(normal = up, direction = [0.0, 0.0, -1.0] => density), 0.0);
    }
}
