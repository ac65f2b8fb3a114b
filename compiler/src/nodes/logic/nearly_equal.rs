use crate::emit::Real;
use crate::nodes::NOT_NEGATIVE;

node! {
    /// Whether `a` and `b` differ by at most a tolerance; false where either is NaN. Blender's
    /// Compare has a tolerance of at least 1e-5; here 0 asks for equality.
    nearly_equal in logic,
    source "",
    inputs {
        /// Left number.
        a: scalar = 0.0;
        /// Right number.
        b: scalar = 0.0;
        /// The largest difference that does not count.
        tolerance: scalar = 0.00001, in NOT_NEGATIVE;
    }
    outputs {
        /// Whether it holds.
        result: boolean;
    }
    body |e, i| Outputs { result: (i.a - i.b).absolute().less_equal(i.tolerance) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_tolerance_belongs_to_it() {
        assert!(truth!(a = 1.0, b = 1.25, tolerance = 0.25 => result));
        assert!(!truth!(a = 1.0, b = 1.5, tolerance = 0.25 => result));
        assert!(truth!(a = 2.0, b = 2.0, tolerance = 0.0 => result));
        assert!(!truth!(a = f32::NAN, b = 2.0, tolerance = 1e9 => result));
    }
}
