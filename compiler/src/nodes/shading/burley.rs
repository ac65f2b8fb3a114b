use crate::emit::functions::facets::{Facets, lit};
use crate::emit::functions::reflected::reflected;
use crate::nodes::brdf::burley_brdf::value;
use crate::nodes::finite::{INTENSITY, UNIT};
use crate::nodes::{NOT_NEGATIVE, WHITE, node, state};
use crate::state::Field;

node! {
    /// Light of one sample on a diffuse surface as measured ones are near grazing: `pi light (n·l)` times
    /// `burley_brdf`, so that head on it is `lambert`.
    /// Black where light or viewer is behind the surface, and there no light is asked for: no shadow ray is
    /// cast. Alpha is 1. Belongs into the body of a light loop.
    burley in shading,
    source "Burley 2012; see `burley_brdf`",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Colour of the light that arrives.
        light: color = node("light_color"), in INTENSITY, when lit(i.normal, i.direction, i.ray);
        /// Share of light that is reflected head on.
        color: color = WHITE, in UNIT, when lit(i.normal, i.direction, i.ray);
        /// How rough the surface is.
        roughness: scalar = 0.5, in UNIT;
    }
    outputs {
        /// The light reflected.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let diffuse = value(&facets, i.roughness, i.color);
        let factor = facets.cosine_in * std::f64::consts::PI;
        Outputs { color: reflected(facets.above(), diffuse, i.light, factor) }
    }
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn edges_are_dark_where_it_is_smooth_and_bright_where_it_is_rough() {
        let shaded = |direction: [f32; 3], ray: [f32; 3], roughness: f32| {
            numbers!(normal = UP, direction = direction, ray = ray, light = [1.0; 4], roughness = roughness => color)
                [0]
        };
        assert!((shaded(UP, DOWN, 0.5) - 1.0).abs() < 1e-6);
        // Seen edgewise from the side of the light, and from across.
        let (light, beside, across) = ([0.8, 0.0, 0.6], [-0.995, 0.0, -0.1], [0.995, 0.0, -0.1]);
        for (ray, least, most) in [(beside, 1.0, 1.2), (across, 0.45, 0.6)] {
            let [smooth, rough] = [0.0, 1.0].map(|roughness| shaded(light, ray, roughness));
            assert!(smooth < 0.45 && (least..most).contains(&rough), "{smooth} {rough}");
        }
    }

    #[test]
    fn light_from_behind_is_not_asked_for() {
        for (direction, ray, asks) in [
            (UP, DOWN, true),
            ([1.0, 0.0, 1e-45], DOWN, true),
            (DOWN, DOWN, false),
            ([1.0, 0.0, 0.0], DOWN, false),
            (UP, [1.0, 0.0, 0.0], false),
        ] {
            assert_eq!(demanded!(normal = UP, direction = direction, ray = ray => light), asks);
        }
        let garbage = [f32::NAN; 4];
        let shaded = numbers!(normal = UP, direction = DOWN, ray = DOWN, light = garbage => color);
        assert_eq!(shaded, [0.0, 0.0, 0.0, 1.0]);
    }
}
