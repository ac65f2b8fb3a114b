node! {
    /// The opposite of an integer; -2147483648 stays, for it wraps.
    integer_negate in integers,
    source "",
    inputs {
        /// The integer.
        input: integer = 0;
    }
    outputs {
        /// Its opposite.
        result: integer;
    }
    body |e, i| Outputs { result: e.int(0) - i.input }
}

#[cfg(test)]
mod tests {
    #[test]
    fn turns_the_sign() {
        for (input, expected) in
            [(-3, 3), (3, -3), (0, 0), (i32::MAX, -i32::MAX), (i32::MIN, i32::MIN)]
        {
            assert_eq!(number!(input = input => result).to_bits() as i32, expected, "{input}");
        }
    }
}
