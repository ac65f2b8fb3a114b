//! Straight and associated colours.
//!
//! Inside, colours are *associated* with their alpha, which means multiplied by it: they are what is seen over
//! black. It is the only form in which colours can be averaged or blended between pixels, for what is
//! not there then has no colour. Porter and Duff, "Compositing Digital Images", SIGGRAPH 1984.

/// An associated colour from a straight one. Opaque colours keep their bits.
pub(super) fn associated(color: [f32; 3], alpha: f32) -> [f32; 4] {
    let [red, green, blue] = color.map(|value| value * alpha);
    [red, green, blue, alpha]
}

/// The straight colour of an associated one. Where alpha is 0, or no share at all, the colour shines and
/// covers nothing: it has no straight form and is left as it is.
pub(super) fn straight([red, green, blue, alpha]: [f32; 4]) -> [f32; 3] {
    let color = [red, green, blue];
    match alpha > 0.0 && alpha < 1.0 {
        true => color.map(|value| value / alpha),
        false => color,
    }
}

/// An associated colour whose straight form is changed.
pub(super) fn mapped(pixel: [f32; 4], change: impl Fn(f32) -> f32) -> [f32; 4] {
    let color = straight(pixel).map(change);
    let alpha = pixel[3];
    match alpha > 0.0 && alpha < 1.0 {
        true => associated(color, alpha),
        false => [color[0], color[1], color[2], alpha],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn opaque_and_shining_colors_keep_their_bits() {
        for color in [[0.1, 0.7, 3e38], [f32::from_bits(1), 0.0, 1.0]] {
            assert_eq!(associated(color, 1.0), [color[0], color[1], color[2], 1.0]);
            for alpha in [1.0, 0.0, -1.0, 7.0, f32::NAN] {
                assert_eq!(straight([color[0], color[1], color[2], alpha]), color);
            }
        }
        assert_eq!(associated([1.0, 0.5, 0.0], 0.0), [0.0; 4]);
    }

    #[test]
    fn colors_are_changed_in_their_straight_form() {
        assert_eq!(mapped([0.25, 0.0, 0.5, 0.5], |x| x * x), [0.125, 0.0, 0.5, 0.5]);
        assert_eq!(mapped([0.25, 0.0, 0.5, 0.0], |x| x * x), [0.0625, 0.0, 0.25, 0.0]);
    }
}
