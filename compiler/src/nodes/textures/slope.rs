use crate::emit::Real;
use crate::emit::functions::conventions::clamp_finite;
use crate::nodes::finite::SUMMAND;

node! {
    /// How steeply a value rises from here to there: `(there - here) / step`. A step of 0 has none, and gives 0.
    /// With `shifted_u` and `shifted_v`, `shifted_x` and `shifted_y` the other place is a step away.
    slope in textures,
    source "Newton's difference quotient",
    inputs {
        /// The value here.
        here: scalar = 0.0, in SUMMAND;
        /// The value a step away.
        there: scalar = 0.0, in SUMMAND;
        /// Length of the step.
        step: scalar = 0.125, in SUMMAND, avoid zero;
    }
    outputs {
        /// The slope.
        result: scalar;
    }
    body |e, i| Outputs { result: clamp_finite((i.there - i.here).divide_or_zero(i.step)) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_a_quotient_of_differences_and_finite() {
        assert_eq!(number!(here = 1.0, there = 3.0, step = 0.5 => result), 4.0);
        assert_eq!(number!(here = 1.0, there = 3.0, step = 0.0 => result), 0.0);
        assert_eq!(number!(there = 1e30, step = 1e-30 => result), f32::MAX);
    }
}
