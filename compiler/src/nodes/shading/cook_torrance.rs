use crate::emit::functions::facets::{Facets, lit};
use crate::emit::functions::reflected::reflected;
use crate::nodes::brdf::cook_torrance_brdf::value;
use crate::nodes::finite::{INTENSITY, UNIT};
use crate::nodes::{NOT_NEGATIVE, node, state};
use crate::state::Field;

node! {
    /// Light of one sample on a rough metal: `light (n·l)` times `cook_torrance_brdf`.
    /// Black where light or viewer is behind the surface, and there no light is asked for: no shadow ray is
    /// cast. Alpha is 1. Belongs into the body of a light loop.
    cook_torrance in shading,
    source "Cook and Torrance 1982; see `cook_torrance_brdf`",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Colour of the light that arrives.
        light: color = node("light_color"), in INTENSITY, when lit(i.normal, i.direction, i.ray);
        /// Root mean square slope of the facets.
        roughness: scalar = 0.3, in UNIT;
        /// Index of refraction for each colour; that of gold unless given.
        ior: color = [0.18, 0.42, 1.37, 1.0], in 0.0..=100.0, soft 0.1..=5.0;
        /// Extinction coefficient for each colour; that of gold unless given.
        extinction: color = [3.42, 2.35, 1.77, 1.0], in 0.0..=100.0, soft 0.0..=10.0;
    }
    outputs {
        /// The light reflected.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let metal = value(&facets, i.roughness, i.ior, i.extinction);
        Outputs { color: reflected(facets.above(), metal, i.light, facets.cosine_in) }
    }
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn gold_is_yellow() {
        let shaded = numbers!(normal = UP, direction = UP, ray = DOWN, light = [1.0; 4] => color);
        assert!(shaded[0] > shaded[1] && shaded[1] > shaded[2], "{shaded:?}");
    }
}
