use crate::emit::{Int, Mask};

node! {
    /// An integer without its sign; -2147483648 stays, for its opposite wraps.
    integer_absolute in integers,
    source "",
    inputs {
        /// The integer.
        input: integer = 0;
    }
    outputs {
        /// Its size.
        result: integer;
    }
    body |e, i| Outputs { result: i.input.less(e.int(0)).select(e.int(0) - i.input, i.input) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn drops_the_sign() {
        for (input, expected) in
            [(-3, 3), (3, 3), (0, 0), (i32::MAX, i32::MAX), (i32::MIN, i32::MIN)]
        {
            assert_eq!(number!(input = input => result).to_bits() as i32, expected, "{input}");
        }
    }
}
