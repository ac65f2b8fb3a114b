node! {
    /// An integer, given once and used in many places.
    constant_integer in constants,
    source "",
    inputs {
        /// The value.
        value: integer = 0;
    }
    outputs {
        /// The same value.
        value: integer;
    }
    body |e, i| Outputs { value: i.value }
}

#[cfg(test)]
mod tests {
    #[test]
    fn passes_its_value() {
        for value in [0, -1, i32::MIN, i32::MAX] {
            assert_eq!(number!(value = value => value).to_bits(), value as u32);
        }
    }
}
