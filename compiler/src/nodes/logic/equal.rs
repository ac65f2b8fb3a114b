node! {
    /// Whether `a == b`, to the last bit; false where either is NaN. -0 equals 0. Integers are compared as
    /// integers, exactly; an integer and a scalar as scalars.
    equal in logic comparing,
    source "",
    inputs {
        /// Left number.
        a: generic = 0.0;
        /// Right number.
        b: generic = 0.0;
    }
    outputs {
        /// Whether it holds.
        result: boolean;
    }
    body |e, i| Outputs { result: i.a.equal(i.b) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn orders_hard_numbers() {
        for (a, b, holds) in [
            (1.0, 1.0_f32.next_down(), false),
            (1.0, 1.0, true),
            (0.0, -0.0, true),
            (1e-45, 0.0, false),
            (f32::NAN, f32::NAN, false),
            (f32::INFINITY, f32::INFINITY, true),
        ] {
            assert_eq!(truth!(a = a, b = b => result), holds, "{a:e} and {b:e}");
        }
    }

    #[test]
    fn integers_keep_all_their_digits() {
        for (a, b) in [(16_777_216, 16_777_217), (i32::MIN, i32::MAX), (-1, 0), (7, 7)] {
            for (a, b) in [(a, b), (b, a)] {
                assert_eq!(truth!(a = a, b = b => result), a == b, "{a} and {b}");
            }
        }
    }
}
