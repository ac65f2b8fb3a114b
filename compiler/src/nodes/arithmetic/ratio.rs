use crate::emit::{Mask, Real};
use crate::nodes::finite::UNIT;

node! {
    /// Share of a whole, clamped to 0..1: `value / whole`. Of a whole of zero, nothing is 0 and
    /// anything more is 1. Made for lengths along a ray: how much of a given depth they take.
    ratio in arithmetic,
    source "",
    inputs {
        /// The part.
        value: scalar = 0.0;
        /// The whole.
        whole: scalar = 1.0;
    }
    outputs {
        /// The share.
        result: scalar, in UNIT;
    }
    body |e, i| {
        let zero = e.real(0.0);
        let of_nothing = i.value.greater(zero).select(e.real(1.0), zero);
        let share = (i.value / i.whole).saturate();
        Outputs { result: i.whole.equal(zero).select(of_nothing, share) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_a_clamped_quotient() {
        for (value, whole, share) in [
            (1.0, 2.0, 0.5),
            (5.0, 2.0, 1.0),
            (-1.0, 2.0, 0.0),
            (0.0, 0.0, 0.0),
            (-0.0, 0.0, 0.0),
            (1e-45, 0.0, 1.0),
            (1.0, -0.0, 1.0),
            (f32::MAX, 1e-45, 1.0),
            (f32::NAN, 1.0, 0.0),
        ] {
            assert_eq!(number!(value = value, whole = whole => result), share, "{value} / {whole}");
        }
    }
}
