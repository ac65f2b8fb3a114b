use crate::emit::Real;

node! {
    /// Whether `a > b`; false where either is NaN. -0 equals 0.
    greater in logic,
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
    body |e, i| Outputs { result: i.a.greater(i.b) }
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
}
