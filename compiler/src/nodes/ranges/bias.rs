use crate::emit::{Mask, Real};
use crate::nodes::finite::UNIT;

node! {
    /// Schlick's bias, per component: bends 0..1 so that one half becomes `amount`. An amount
    /// of one half changes nothing. The input is clamped to 0..1. A colour keeps its alpha.
    bias in ranges per component,
    source "Schlick 1994, Fast Alternatives to Perlin's Bias and Gain Functions",
    inputs {
        /// Where to look.
        input: generic = 0.0;
        /// What one half becomes.
        amount: scalar = 0.5, in UNIT;
    }
    outputs {
        /// The value.
        result: generic, in UNIT;
    }
    body |e, i| {
        let t = i.input.saturate();
        let one = e.real(1.0);
        // t / ((1 / amount - 2) (1 - t) + 1), times amount above and below.
        let below = (one - i.amount * 2.0).mul_add(one - t, i.amount);
        let bent = (i.amount * t).divide_or_zero(below).saturate();
        t.equal(one).select(one, bent)
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn one_half_becomes_the_amount() {
        for amount in [0.0, 0.1, 0.5, 0.9, 1.0] {
            assert_eq!(number!(input = 0.5, amount = amount => result), amount);
            assert_eq!(number!(input = 1.0, amount = amount => result), 1.0);
            assert_eq!(number!(input = 0.0, amount = amount => result), 0.0);
        }
        assert_eq!(number!(input = 0.3, amount = 0.5 => result), 0.3);
    }
}
