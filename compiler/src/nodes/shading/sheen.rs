use crate::emit::functions::facets::{Facets, lit};
use crate::emit::functions::reflected::reflected;
use crate::nodes::brdf::sheen_brdf::value;
use crate::nodes::finite::{INTENSITY, UNIT};
use crate::nodes::{NOT_NEGATIVE, WHITE, node, state};
use crate::state::Field;

node! {
    /// Light of one sample on upright fibres of cloth: `color light (n·l)` times `sheen_brdf`.
    /// Black where light or viewer is behind the surface, and there no light is asked for: no shadow ray is
    /// cast. Alpha is 1. Belongs into the body of a light loop.
    sheen in shading,
    source "Estevez and Kulla 2017; see `sheen_brdf`",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Colour of the light that arrives.
        light: color = node("light_color"), in INTENSITY, when lit(i.normal, i.direction, i.ray);
        /// Colour of the surface.
        color: color = WHITE, in INTENSITY, when lit(i.normal, i.direction, i.ray);
        /// Roughness of the cloth.
        roughness: scalar = 0.3, in UNIT;
    }
    outputs {
        /// The light reflected.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let factor = value(&facets, i.roughness) * facets.cosine_in;
        Outputs { color: reflected(facets.above(), i.color, i.light, factor) }
    }
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    #[test]
    fn edgewise_it_shines() {
        let shine = |z: f32| {
            let x = (1.0 - z * z).sqrt();
            number!(normal = UP, direction = [0.0, 0.6, 0.8], ray = [x, 0.0, -z], light = [1.0; 4] => color)
        };
        assert!(shine(0.1) > 2.0 * shine(0.9));
    }
}
