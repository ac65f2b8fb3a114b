use crate::emit::functions::facets::{Facets, lit};
use crate::emit::functions::reflected::reflected;
use crate::nodes::brdf::phong_brdf::lobe;
use crate::nodes::finite::INTENSITY;
use crate::nodes::{NOT_NEGATIVE, WHITE, node, state};
use crate::state::Field;

node! {
    /// Phong's highlight for one light sample: `color light c^exponent`, c being the cosine between viewer and
    /// mirrored light, not multiplied by `n·l`, as mental ray's shaders have it. `schlick` is
    /// `c / (exponent - exponent c + c)` in place of the power; `normalized` is `phong_brdf` times `n·l`, which reflects at
    /// most all light.
    /// Black where light or viewer is behind the surface, and there no light is asked for: no shadow ray is
    /// cast. Alpha is 1. Belongs into the body of a light loop.
    phong in shading,
    source "Phong 1975; mental ray base shaders, mib_illum_phong; see `phong_brdf`",
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
        /// How narrow the highlight is.
        exponent: scalar = 20.0, in 0.0..=1e8, soft 1.0..=1000.0;
        /// Which of the three.
        kind: choice = 0, of ["phong", "schlick", "normalized"];
    }
    outputs {
        /// The light reflected.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let lobe = lobe(&facets, i.exponent, i.kind);
        let factor = if i.kind == 2 { lobe * facets.cosine_in } else { lobe };
        Outputs { color: reflected(facets.above(), i.color, i.light, factor) }
    }
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    #[test]
    fn the_peak_is_the_light() {
        let light = [2.0, 1.0, 0.5, 1.0];
        let shaded = numbers!(normal = UP, direction = [0.6, 0.0, 0.8], ray = [0.6, 0.0, -0.8], light = light => color);
        assert_eq!(shaded, light);
    }
}
