use crate::emit::Real;
use crate::emit::functions::conventions::clamp_finite;

node! {
    /// Hyperbolic cosine `(e^x + e^-x) / 2`, per component; the largest number where it
    /// overflows. A colour keeps its alpha.
    hyperbolic_cosine in trigonometry per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The value.
        result: generic, in 1.0..=f64::from(f32::MAX);
    }
    body |e, i| clamp_finite(i.input.cosh()).maximum(e.real(1.0))
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_that_of_the_definition() {
        let close = crate::nodes::harness::assert_close;
        for x in [-80.0_f32, -1.0, -1e-20, 0.0, 0.5, 3.0, 88.0] {
            close(&[number!(input = x => result)], &[f64::from(x).cosh()], 3e-7, 0.0);
        }
        assert_eq!(number!(input = -1e9 => result), f32::MAX);
    }
}
