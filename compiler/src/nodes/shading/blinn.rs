use crate::emit::functions::distributions::{CAVITY, ELLIPSOID, roughness, spread, visibility};
use crate::emit::functions::facets::{Facets, lit};
use crate::emit::functions::reflected::reflected;
use crate::nodes::finite::{INTENSITY, UNIT};
use crate::nodes::fresnel::fresnel_dielectric::{index, reflectance};
use crate::nodes::{NOT_NEGATIVE, WHITE, node, state};
use crate::state::Field;

node! {
    /// Blinn's highlight for one light sample: `color light D G F / (n·v)`, D being that of ellipsoids, 1 at its peak, G
    /// Torrance and Sparrow's for grooves, and F Fresnel's reflectance of a dielectric. It is an intensity, not a
    /// reflectance: `n·l` is in it, and it is neither reciprocal nor bounded. For a reflectance take
    /// `torrance_sparrow`, whose `ellipsoid` distribution it is. mental ray's `mi_blinn_specular` is of this kind.
    /// Black where light or viewer is behind the surface, and there no light is asked for: no shadow ray is
    /// cast. Alpha is 1. Belongs into the body of a light loop.
    blinn in shading,
    source "Blinn 1977, Models of Light Reflection for Computer Synthesized Pictures",
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
        /// Eccentricity of the ellipsoids: 0 a mirror, 1 diffuse.
        eccentricity: scalar = 0.35, in UNIT;
        /// Index of refraction of the surface.
        ior: scalar = 1.5, in 0.0..=100.0, soft 1.0..=2.5;
        /// Index of refraction of what surrounds it.
        ior_in: scalar = 1.0, in 0.0..=100.0, soft 1.0..=2.5;
    }
    outputs {
        /// The light reflected.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let c = roughness(i.eccentricity);
        let fresnel = reflectance(e, index(e, i.ior_in), index(e, i.ior), facets.cosine_half());
        let facing = spread(ELLIPSOID, facets.slope_squared(), c) * fresnel;
        let factor = facing * visibility(CAVITY, &facets, c) * facets.cosine_in * 4.0;
        Outputs { color: reflected(facets.above(), i.color, i.light, factor) }
    }
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn head_on_it_is_fresnels_share() {
        let shaded = numbers!(normal = UP, direction = UP, ray = DOWN, light = [1.0; 4] => color);
        crate::nodes::harness::assert_close(&shaded, &[0.04, 0.04, 0.04, 1.0], 1e-6, 0.0);
    }
}
