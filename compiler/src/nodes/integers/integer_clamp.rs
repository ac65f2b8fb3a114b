use crate::emit::{Int, Mask};

node! {
    /// An integer kept between two others: not below `low`, then not above `high`. Where `low` is above
    /// `high` the result is `high`.
    integer_clamp in integers,
    source "",
    inputs {
        /// What is kept.
        input: integer = 0;
        /// The least.
        low: integer = 0;
        /// The most.
        high: integer = 1;
    }
    outputs {
        /// The integer within.
        result: integer;
    }
    body |e, i| {
        let raised = i.input.less(i.low).select(i.low, i.input);
        Outputs { result: i.high.less(raised).select(i.high, raised) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn keeps_within() {
        for (input, low, high, expected) in [
            (5, 0, 3, 3),
            (-5, 0, 3, 0),
            (2, 0, 3, 2),
            (2, 3, 0, 0),
            (i32::MIN, i32::MIN, i32::MAX, i32::MIN),
            (16_777_217, 0, 16_777_216, 16_777_216),
        ] {
            let kept = number!(input = input, low = low, high = high => result).to_bits() as i32;
            assert_eq!(kept, expected, "{input} in {low}..{high}");
        }
    }
}
