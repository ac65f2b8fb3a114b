use crate::emit::Real;
use crate::emit::functions::conventions::sqrt_or_zero;
use crate::nodes::NOT_NEGATIVE;

node! {
    /// 1 over the square root, per component; 0 of what has none, and of zero. A colour keeps
    /// its alpha.
    inverse_square_root in arithmetic per component,
    source "",
    inputs {
        /// Any value above zero.
        input: generic = 0.0, avoid negative;
    }
    outputs {
        /// The value.
        result: generic, in NOT_NEGATIVE;
    }
    body |e, i| e.real(1.0).divide_or_zero(sqrt_or_zero(i.input))
}

#[cfg(test)]
mod tests {
    #[test]
    fn of_zero_and_below_it_is_zero() {
        assert_eq!(number!(input = 4.0 => result), 0.5);
        for x in [0.0, -0.0, -4.0, f32::NAN] {
            assert_eq!(number!(input = x => result), 0.0);
        }
        assert!(number!(input = 1e-45 => result) > 1e22);
    }
}
