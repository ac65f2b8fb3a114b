use crate::emit::functions::colors::luminance;
use crate::emit::{Color, Real};
use crate::nodes::BLACK;
use crate::nodes::finite::FACTOR;

node! {
    /// A colour between its grey and beyond: `luminance + (color - luminance) amount`, per
    /// component. 0 is grey, 1 changes nothing, more is purer, and components may become
    /// negative. MaterialX calls it saturate, with the luminance weights of ACEScg; ours are
    /// Rec. 709's. A colour keeps its alpha.
    saturation in color,
    source "Haeberli 1993, Matrix Operations for Image Processing",
    inputs {
        /// The colour.
        color: color = BLACK, in FACTOR;
        /// How pure it is to be.
        amount: scalar = 1.0, in FACTOR, soft 0.0..=2.0;
    }
    outputs {
        /// The colour.
        color: color;
    }
    body |e, i| {
        let grey = luminance(i.color);
        let color = Color {
            r: (i.color.r - grey).mul_add(i.amount, grey),
            g: (i.color.g - grey).mul_add(i.amount, grey),
            b: (i.color.b - grey).mul_add(i.amount, grey),
            a: i.color.a,
        };
        Outputs { color }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn keeps_the_luminance() {
        let close = crate::nodes::harness::assert_close;
        let color = [1.0, 0.5, 0.25, 0.75];
        let grey = 0.2126 + 0.3576 + 0.01805;
        close(
            &numbers!(color = color, amount = 0.0 => color),
            &[grey, grey, grey, 0.75],
            3e-7,
            0.0,
        );
        close(&numbers!(color = color => color), &[1.0, 0.5, 0.25, 0.75], 3e-7, 0.0);
        let pure = numbers!(color = color, amount = 2.0 => color);
        close(&pure, &[2.0 - grey, 1.0 - grey, 0.5 - grey, 0.75], 1e-6, 0.0);
    }
}
