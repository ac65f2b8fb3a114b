node! {
    /// A truth value, given once and used in many places.
    constant_boolean in constants,
    source "",
    inputs {
        /// The value.
        value: boolean = false;
    }
    outputs {
        /// The same value.
        value: boolean;
    }
    body |e, i| Outputs { value: i.value }
}

#[cfg(test)]
mod tests {
    #[test]
    fn passes_its_value() {
        assert!(truth!(value = true => value));
        assert!(!truth!(value = false => value));
        assert!(!truth!(=> value));
    }
}
