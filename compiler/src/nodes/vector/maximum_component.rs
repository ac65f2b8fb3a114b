use crate::emit::Real;

node! {
    /// Largest component of a vector, or of the red, green and blue of a colour.
    maximum_component in vector generic [vector, color],
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The component.
        result: scalar;
    }
    body |e, i| {
        let [x, y, z, _] = i.input.to_words();
        Outputs { result: x.maximum(y).maximum(z) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn alpha_does_not_count() {
        assert_eq!(number!(input = [1.0, -2.0, 3.0] => result), 3.0);
        assert_eq!(number!(input = [0.5, 0.25, 0.75, 9.0] => result), 0.75);
    }
}
