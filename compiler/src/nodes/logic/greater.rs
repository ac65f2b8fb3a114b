node! {
    /// Whether `a > b`; false where either is NaN. -0 equals 0. Integers are compared as
    /// integers, exactly; an integer and a scalar as scalars.
    greater in logic comparing,
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
    body |e, i| Outputs { result: i.b.less(i.a) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        let holds = |a: f32, b: f32| truth!(a = a, b = b => result);
        assert_eq!(
            [holds(1.0, 2.0), holds(2.0, 2.0), holds(3.0, 2.0), holds(-0.0, 0.0)],
            [false, false, true, false]
        );
        assert_eq!([holds(f32::NAN, 0.0), holds(0.0, f32::NAN)], [false; 2]);
    }

    #[test]
    fn integers_keep_all_their_digits() {
        for (a, b) in [(16_777_216, 16_777_217), (i32::MIN, i32::MAX), (-1, 0), (7, 7)] {
            for (a, b) in [(a, b), (b, a)] {
                assert_eq!(truth!(a = a, b = b => result), a > b, "{a} and {b}");
            }
        }
    }
}
