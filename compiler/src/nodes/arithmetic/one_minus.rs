node! {
    /// Complement `1 - input`, per component. A colour keeps its alpha.
    one_minus in arithmetic per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The complement.
        result: generic;
    }
    body |e, i| e.real(1.0) - i.input
}

#[cfg(test)]
mod tests {
    #[test]
    fn complements() {
        assert_eq!(number!(input = 0.25 => result), 0.75);
        assert_eq!(numbers!(input = [0.0, 1.0, 2.0] => result), [1.0, 0.0, -1.0]);
    }
}
