node! {
    /// The vector at length 1. The zero vector stays zero. Neither tiny nor huge vectors lose their
    /// direction: the largest component is divided out first.
    normalize in vector,
    source "",
    inputs {
        /// Any vector.
        input: vector = [0.0; 3];
    }
    outputs {
        /// The unit vector.
        result: vector, in -1.0..=1.0;
    }
    body |e, i| Outputs { result: i.input.normalized() }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn any_magnitude_has_a_direction() {
        for size in [1e-45, 1e-30, 1.0, 1e30] {
            let unit = numbers!(input = [0.0, size, 0.0] => result);
            assert_eq!(unit, [0.0, 1.0, 0.0], "{size}");
        }
        assert_close(
            &numbers!(input = [3e38, 0.0, -3e38] => result),
            &[0.5_f64.sqrt(), 0.0, -0.5_f64.sqrt()],
            2e-7,
            0.0,
        );
        assert_close(&numbers!(input = [3.0, 4.0, 0.0] => result), &[0.6, 0.8, 0.0], 2e-7, 0.0);
    }

    #[test]
    fn what_has_no_direction_is_zero() {
        assert_eq!(numbers!(input = [0.0, -0.0, 0.0] => result), [0.0; 3]);
        assert_eq!(numbers!(input = [f32::NAN, 1.0, 0.0] => result), [0.0; 3]);
    }
}
