node! {
    /// Difference `a - b` of integers; beyond 32 bits it wraps.
    integer_subtract in integers,
    source "",
    inputs {
        /// What is subtracted from.
        a: integer = 0;
        /// What is subtracted.
        b: integer = 0;
    }
    outputs {
        /// The difference.
        result: integer;
    }
    body |e, i| Outputs { result: i.a - i.b }
}

#[cfg(test)]
mod tests {
    #[test]
    fn wraps() {
        for (a, b, expected) in [
            (2, 3, -1),
            (i32::MIN, 1, i32::MAX),
            (0, i32::MIN, i32::MIN),
            (16_777_217, 1, 16_777_216),
        ] {
            assert_eq!(number!(a = a, b = b => result).to_bits() as i32, expected, "{a} and {b}");
        }
    }
}
