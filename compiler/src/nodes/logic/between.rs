use crate::emit::Real;

node! {
    /// Whether a number lies in a range, its ends included; false for NaN, and where `low` is
    /// above `high`.
    between in logic,
    source "",
    inputs {
        /// The number.
        input: scalar = 0.0;
        /// Lower end.
        low: scalar = 0.0;
        /// Upper end.
        high: scalar = 1.0;
    }
    outputs {
        /// Whether it holds.
        result: boolean;
    }
    body |e, i| Outputs { result: i.low.less_equal(i.input) & i.input.less_equal(i.high) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_ends_belong_to_it() {
        let holds = |x: f32| truth!(input = x, low = 1.0, high = 2.0 => result);
        assert!(holds(1.0) && holds(1.5) && holds(2.0));
        assert!(!holds(0.9) && !holds(2.1) && !holds(f32::NAN));
    }
}
