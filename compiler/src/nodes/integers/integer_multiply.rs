node! {
    /// Product `a b` of integers; beyond 32 bits it wraps.
    integer_multiply in integers,
    source "",
    inputs {
        /// First factor.
        a: integer = 1;
        /// Second factor.
        b: integer = 1;
    }
    outputs {
        /// The product.
        result: integer;
    }
    body |e, i| Outputs { result: i.a * i.b }
}

#[cfg(test)]
mod tests {
    #[test]
    fn wraps() {
        for (a, b, expected) in
            [(-2, 3, -6), (65_536, 65_536, 0), (i32::MIN, -1, i32::MIN), (4097, 4097, 16_785_409)]
        {
            assert_eq!(number!(a = a, b = b => result).to_bits() as i32, expected, "{a} and {b}");
        }
    }
}
