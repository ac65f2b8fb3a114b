use crate::nodes::BLACK;

node! {
    /// A colour, given once and used in many places.
    constant_color in constants,
    source "",
    inputs {
        /// The value.
        value: color = BLACK;
    }
    outputs {
        /// The same value.
        value: color;
    }
    body |e, i| Outputs { value: i.value }
}

#[cfg(test)]
mod tests {
    #[test]
    fn passes_its_value() {
        assert_eq!(numbers!(value = [0.1, 2.0, -3.0, 0.5] => value), [0.1, 2.0, -3.0, 0.5]);
        assert_eq!(numbers!(=> value), [0.0, 0.0, 0.0, 1.0]);
    }
}
