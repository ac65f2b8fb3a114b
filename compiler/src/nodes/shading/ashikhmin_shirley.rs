use crate::emit::functions::facets::{Facets, lit};
use crate::emit::functions::frames::Frame;
use crate::emit::functions::reflected::reflected;
use crate::nodes::brdf::ashikhmin_shirley_brdf::{coat, ground};
use crate::nodes::finite::{INTENSITY, UNIT};
use crate::nodes::{NOT_NEGATIVE, node, state};
use crate::state::Field;

node! {
    /// Light of one sample on a brushed, clear coat over a diffuse ground: `light (n·l)` times `ashikhmin_shirley_brdf`.
    /// Black where light or viewer is behind the surface, and there no light is asked for: no shadow ray is
    /// cast. Alpha is 1. Belongs into the body of a light loop.
    ashikhmin_shirley in shading,
    source "Ashikhmin and Shirley 2000; see `ashikhmin_shirley_brdf`",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Colour of the light that arrives.
        light: color = node("light_color"), in INTENSITY, when lit(i.normal, i.direction, i.ray);
        /// Direction along the surface that `exponent_u` goes by, by default that of u; put at right
        /// angles to the normal. Any is taken where this is zero or along the normal.
        tangent: vector = node("frame_from_derivatives"), in -1.0..=1.0;
        /// How narrow the lobe is along the tangent.
        exponent_u: scalar = 10.0, in 0.0..=1e8, soft 1.0..=1e4;
        /// How narrow it is across.
        exponent_v: scalar = 100.0, in 0.0..=1e8, soft 1.0..=1e4;
        /// Reflectance of the coat head on.
        specular: color = [0.04, 0.04, 0.04, 1.0], in UNIT;
        /// Share of light the ground reflects.
        diffuse: color = [0.5, 0.5, 0.5, 1.0], in UNIT;
    }
    outputs {
        /// The light reflected.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let frame = Frame::along(i.normal, i.tangent);
        let coat = coat(&facets, &frame, i.exponent_u, i.exponent_v, i.specular);
        let both = coat + ground(&facets, i.specular, i.diffuse);
        Outputs { color: reflected(facets.above(), both, i.light, facets.cosine_in) }
    }
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn head_on_it_is_the_coat_over_the_ground() {
        let (half, black) = ([0.5, 0.5, 0.5, 1.0], [0.0, 0.0, 0.0, 1.0]);
        let coat = 0.663_112_438_107_446_4;
        let shaded = numbers!(normal = UP, direction = UP, ray = DOWN, light = [1.0; 4], specular = half, diffuse = black => color);
        crate::nodes::harness::assert_close(&shaded, &[coat, coat, coat, 1.0], 1e-6, 0.0);
    }
}
