node! {
    /// Whether a number lies in a range, its ends included; false for NaN, and where `low` is
    /// above `high`. Integers are compared as integers, exactly, where all three are; else as scalars.
    between in logic comparing,
    source "",
    inputs {
        /// The number.
        input: generic = 0.0;
        /// Lower end.
        low: generic = 0.0;
        /// Upper end.
        high: generic = 1.0;
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

    #[test]
    fn integers_keep_all_their_digits() {
        let holds =
            |x: i32, low: i32, high: i32| truth!(input = x, low = low, high = high => result);
        assert!(holds(16_777_217, 16_777_217, 16_777_217));
        assert!(!holds(16_777_216, 16_777_217, i32::MAX) && !holds(i32::MIN, -1, 1));
    }
}
