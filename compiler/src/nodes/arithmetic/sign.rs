use crate::emit::{Mask, Real};

node! {
    /// 1 for values above zero, -1 below, and 0 for 0, -0 and NaN, per component. A colour
    /// keeps its alpha.
    sign in arithmetic per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The sign.
        result: generic, in -1.0..=1.0;
    }
    body |e, i| {
        let (zero, one) = (e.real(0.0), e.real(1.0));
        let not_above = i.input.less(zero).select(-one, zero);
        i.input.greater(zero).select(one, not_above)
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn tells_the_side_of_zero() {
        for (x, sign) in [(3.0, 1.0), (-1e-45, -1.0), (0.0, 0.0), (-0.0, 0.0), (f32::NAN, 0.0)] {
            assert_eq!(number!(input = x => result).to_bits(), f32::to_bits(sign), "{x}");
        }
    }
}
