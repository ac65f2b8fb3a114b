use crate::emit::Real;

node! {
    /// Cosine of an angle in radians, per component. A colour keeps its alpha.
    cosine in arithmetic per component,
    source "",
    inputs {
        /// The angle in radians.
        input: generic = 0.0, unit "radians";
    }
    outputs {
        /// The value.
        result: generic, in -1.0..=1.0;
    }
    body |e, i| i.input.cos()
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn known_values() {
        for input in [0.5_f32, -0.5, 1.0, 3.0, 100.0, -1e3, 1e-20] {
            let exact = f64::from(input).cos();
            assert_close(&numbers!(input = input => result), &[exact], 3e-7, 0.0);
        }
        assert_eq!(number!(input = 0.0 => result), 1.0);
    }

    #[test]
    fn huge_angles_stay_on_the_circle() {
        for input in [1e6, 1e10, -1e30, f32::MAX, f32::MIN] {
            let value = number!(input = input => result);
            assert!((-1.0..=1.0).contains(&value), "{input}: {value}");
        }
    }
}
