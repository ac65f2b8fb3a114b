use crate::emit::{Mask, Real};
use crate::nodes::finite::UNIT;

node! {
    /// Schlick's gain, per component: steepens the middle of 0..1 for amounts below one half
    /// and flattens it above; 0, one half and 1 stay. The input is clamped to 0..1. A colour
    /// keeps its alpha. What VEX and mental ray call gain is a factor: `scale`.
    gain in ranges per component,
    source "Schlick 1994, Fast Alternatives to Perlin's Bias and Gain Functions",
    inputs {
        /// Where to look.
        input: generic = 0.0;
        /// One half changes nothing, 0 is a step.
        amount: scalar = 0.5, in UNIT;
    }
    outputs {
        /// The value.
        result: generic, in UNIT;
    }
    body |e, i| {
        let t = i.input.saturate();
        let one = e.real(1.0);
        let near = t.minimum(one - t);
        // near / ((1 / amount - 2) (1 - 2 near) + 1), times amount above and below.
        let below = (one - i.amount * 2.0).mul_add(one - near * 2.0, i.amount);
        let bent = (i.amount * near).divide_or_zero(below).saturate();
        t.less(e.real(0.5)).select(bent, one - bent)
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_ends_and_the_middle_stay() {
        for amount in [0.1, 0.5, 0.9] {
            let at = |x: f32| number!(input = x, amount = amount => result);
            assert_eq!([at(0.0), at(0.5), at(1.0)], [0.0, 0.5, 1.0]);
            assert!((at(0.2) + at(0.8) - 1.0).abs() < 1e-6);
        }
        assert_eq!(number!(input = 0.3, amount = 0.5 => result), 0.3);
        assert_eq!(number!(input = 0.7, amount = 0.0 => result), 1.0, "a step");
        assert!(number!(input = 0.25, amount = 0.9 => result) > 0.25);
    }
}
