use crate::emit::functions::conventions::ln_or_zero;

node! {
    /// Natural logarithm, per component; 0 for what has none: zero and negative values. A colour
    /// keeps its alpha.
    logarithm in arithmetic per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| ln_or_zero(i.input)
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn known_values() {
        for input in [0.5_f32, 2.0, 10.0, 1.0_f32.next_up(), 1.0_f32.next_down(), 1e-45, f32::MAX] {
            let exact = f64::from(input).ln();
            assert_close(&numbers!(input = input => result), &[exact], 3e-7, 0.0);
        }
        assert_eq!(number!(input = 1.0 => result), 0.0);
    }

    #[test]
    fn what_has_no_logarithm_is_zero() {
        for input in [0.0, -0.0, -1.0, -1e-45, f32::MIN, f32::NAN] {
            assert_eq!(number!(input = input => result), 0.0, "{input}");
        }
    }
}
