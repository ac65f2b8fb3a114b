use crate::emit::functions::conventions::clamp_finite;
use crate::emit::{Color, Real};
use crate::nodes::BLACK;

node! {
    /// A premultiplied colour divided by its alpha; black where that is 0. What overflows is
    /// the largest number. Alpha is kept.
    unpremultiply in compositing,
    source "Porter and Duff 1984, Compositing Digital Images",
    inputs {
        /// The premultiplied colour.
        color: color = BLACK;
    }
    outputs {
        /// The straight colour.
        color: color;
    }
    body |e, i| {
        let (color, alpha) = (i.color, i.color.a);
        let color = Color {
            r: clamp_finite(color.r.divide_or_zero(alpha)),
            g: clamp_finite(color.g.divide_or_zero(alpha)),
            b: clamp_finite(color.b.divide_or_zero(alpha)),
            a: alpha,
        };
        Outputs { color }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn alpha_divides() {
        assert_eq!(numbers!(color = [0.5, -1.0, 2.0, 0.5] => color), [1.0, -2.0, 4.0, 0.5]);
        assert_eq!(numbers!(color = [0.5, -1.0, 2.0, 0.0] => color), [0.0; 4]);
    }
}
