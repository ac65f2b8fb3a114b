use crate::emit::functions::facets::{Facets, lit};
use crate::emit::functions::reflected::reflected;
use crate::nodes::brdf::oren_nayar_brdf::value;
use crate::nodes::finite::{INTENSITY, UNIT};
use crate::nodes::{NOT_NEGATIVE, WHITE, node, state};
use crate::state::Field;

node! {
    /// Light of one sample on a rough diffuse surface: `pi light (n·l)` times `oren_nayar_brdf`, so that without
    /// slopes it is `lambert`.
    /// Black where light or viewer is behind the surface, and there no light is asked for: no shadow ray is
    /// cast. Alpha is 1. Belongs into the body of a light loop.
    oren_nayar in shading,
    source "Oren and Nayar 1994; see `oren_nayar_brdf`",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Colour of the light that arrives.
        light: color = node("light_color"), in INTENSITY, when lit(i.normal, i.direction, i.ray);
        /// Share of light each groove side reflects.
        color: color = WHITE, in UNIT, when lit(i.normal, i.direction, i.ray);
        /// Standard deviation of the slopes.
        sigma: scalar = 0.3, in 0.0..=1.5707964, unit "radians";
        /// Which of the two models.
        model: choice = 0, of ["full", "qualitative"];
    }
    outputs {
        /// The light reflected.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let rough = value(i.normal, i.direction, i.ray, i.sigma, i.color, i.model);
        let factor = facets.cosine_in * std::f64::consts::PI;
        Outputs { color: reflected(facets.above(), rough, i.light, factor) }
    }
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn without_slopes_it_is_lamberts() {
        let shaded = numbers!(normal = UP, direction = [0.6, 0.0, 0.8], ray = DOWN, light = [1.0; 4], sigma = 0.0 => color);
        crate::nodes::harness::assert_close(&shaded, &[0.8, 0.8, 0.8, 1.0], 2e-7, 0.0);
    }
}
