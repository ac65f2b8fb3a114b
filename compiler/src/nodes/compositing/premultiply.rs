use crate::emit::Color;
use crate::emit::functions::conventions::clamp_finite;
use crate::nodes::BLACK;

node! {
    /// A colour times its alpha, as the alpha compositing of `composite` expects it; what
    /// overflows is the largest number. Alpha is kept.
    premultiply in compositing,
    source "Porter and Duff 1984, Compositing Digital Images",
    inputs {
        /// The straight colour.
        color: color = BLACK;
    }
    outputs {
        /// The premultiplied colour.
        color: color;
    }
    body |e, i| {
        let (color, alpha) = (i.color, i.color.a);
        let color = Color {
            r: clamp_finite(color.r * alpha),
            g: clamp_finite(color.g * alpha),
            b: clamp_finite(color.b * alpha),
            a: alpha,
        };
        Outputs { color }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn alpha_multiplies() {
        assert_eq!(numbers!(color = [1.0, -2.0, 4.0, 0.5] => color), [0.5, -1.0, 2.0, 0.5]);
    }
}
