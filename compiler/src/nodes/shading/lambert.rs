use crate::emit::{Color, Mask, Real};
use crate::nodes::finite::{INTENSITY, UNIT};
use crate::nodes::{NOT_NEGATIVE, WHITE, node, state};
use crate::state::Field;

node! {
    /// Ideal diffuse reflection of one light sample: `color light max(0, n·l)`, without the `1 / pi`
    /// of a normalised reflectance, as mental ray's shaders have it. Black where the light is behind
    /// the surface, and there neither colour nor light is evaluated: no shadow ray is cast. Alpha
    /// is 1. Belongs into the body of a light loop.
    lambert in shading,
    source "Lambert 1760; mental ray base shaders, mib_illum_lambert",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Colour of the light that arrives.
        light: color = node("light_color"), in INTENSITY, when i.normal.dot(i.direction).greater(e.real(0.0));
        /// Colour of the surface.
        color: color = WHITE, in INTENSITY, soft UNIT, when i.normal.dot(i.direction).greater(e.real(0.0));
    }
    outputs {
        /// The light reflected.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let (zero, one) = (e.real(0.0), e.real(1.0));
        let cosine = i.normal.dot(i.direction);
        let reflected = i.color * i.light * cosine;
        let black = Color { r: zero, g: zero, b: zero, a: one };
        let color = Color { a: one, ..reflected };
        Outputs { color: cosine.greater(zero).select(color, black) }
    }
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];

    #[test]
    fn is_proportional_to_the_cosine() {
        let (color, light) = ([0.5, 0.25, 1.0, 0.3], [2.0, 4.0, 0.0, 0.6]);
        assert_eq!(
            numbers!(normal = UP, direction = UP, color = color, light = light => color),
            [1.0, 1.0, 0.0, 1.0]
        );
        let slanted = [0.8, 0.0, 0.5];
        assert_eq!(
            numbers!(normal = UP, direction = slanted, color = color, light = light => color),
            [0.5, 0.5, 0.0, 1.0]
        );
    }

    #[test]
    fn light_from_behind_is_neither_seen_nor_asked_for() {
        let garbage = [f32::NAN; 4];
        for direction in
            [[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0; 3], [1.0, 0.0, -0.0], [f32::NAN; 3]]
        {
            let shaded = numbers!(normal = UP, direction = direction, color = garbage, light = garbage => color);
            assert_eq!(shaded, [0.0, 0.0, 0.0, 1.0]);
            assert!(!demanded!(normal = UP, direction = direction => light));
            assert!(!demanded!(normal = UP, direction = direction => color));
        }
        assert!(demanded!(normal = UP, direction = [1.0, 0.0, 1e-45] => light));
    }
}
