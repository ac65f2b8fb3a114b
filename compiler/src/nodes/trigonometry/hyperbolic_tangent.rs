use crate::emit::Real;

node! {
    /// Hyperbolic tangent, per component: from -1 to 1, like a soft clamp. A colour keeps its
    /// alpha.
    hyperbolic_tangent in trigonometry per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The value.
        result: generic, in -1.0..=1.0;
    }
    body |e, i| i.input.tanh()
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_that_of_the_definition() {
        let close = crate::nodes::harness::assert_close;
        for x in [-80.0_f32, -1.0, -1e-20, 0.0, 0.5, 3.0, 88.0] {
            close(&[number!(input = x => result)], &[f64::from(x).tanh()], 3e-7, 0.0);
        }
        assert_eq!(number!(input = -1e9 => result), -1.0);
    }
}
