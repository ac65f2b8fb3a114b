use crate::emit::Real;
use crate::emit::functions::conventions::clamp_finite;

node! {
    /// Hyperbolic sine `(e^x - e^-x) / 2`, per component, accurate near 0 too; the largest
    /// number where it overflows. A colour keeps its alpha.
    hyperbolic_sine in trigonometry per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| clamp_finite(i.input.sinh())
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_that_of_the_definition() {
        let close = crate::nodes::harness::assert_close;
        for x in [-80.0_f32, -1.0, -1e-20, 0.0, 0.5, 3.0, 88.0] {
            close(&[number!(input = x => result)], &[f64::from(x).sinh()], 3e-7, 0.0);
        }
        assert_eq!(number!(input = -1e9 => result), f32::MIN);
    }
}
