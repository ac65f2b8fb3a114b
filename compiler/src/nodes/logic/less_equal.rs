use crate::emit::Real;

node! {
    /// Whether `a <= b`; false where either is NaN. -0 equals 0.
    less_equal in logic,
    source "",
    inputs {
        /// Left number.
        a: scalar = 0.0;
        /// Right number.
        b: scalar = 0.0;
    }
    outputs {
        /// Whether it holds.
        result: boolean;
    }
    body |e, i| Outputs { result: i.a.less_equal(i.b) }
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
}
