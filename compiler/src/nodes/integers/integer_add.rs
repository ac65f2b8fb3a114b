node! {
    /// Sum `a + b` of integers; beyond 32 bits it wraps.
    integer_add in integers,
    source "",
    inputs {
        /// First summand.
        a: integer = 0;
        /// Second summand.
        b: integer = 0;
    }
    outputs {
        /// The sum.
        result: integer;
    }
    body |e, i| Outputs { result: i.a + i.b }
}

#[cfg(test)]
mod tests {
    #[test]
    fn wraps() {
        for (a, b, expected) in [
            (2, 3, 5),
            (i32::MAX, 1, i32::MIN),
            (i32::MIN, -1, i32::MAX),
            (16_777_216, 1, 16_777_217),
        ] {
            assert_eq!(number!(a = a, b = b => result).to_bits() as i32, expected, "{a} and {b}");
        }
    }
}
