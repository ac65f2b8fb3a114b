use crate::emit::Int;

node! {
    /// Whether two strings are the same, character by character. Known before shading, so what it rules
    /// out costs nothing.
    string_equal in logic,
    source "",
    inputs {
        /// The first.
        a: string = "";
        /// The second.
        b: string = "";
    }
    outputs {
        /// Whether they are the same.
        result: boolean;
    }
    body |e, i| Outputs { result: i.a.equal(i.b) }
}

#[cfg(test)]
mod tests {
    use crate::values::Literal;

    #[test]
    fn compares_characters() {
        let text = |text: &str| Literal::String(text.into());
        assert!(truth!(a = text("matte"), b = text("matte") => result));
        assert!(truth!( => result), "both are empty");
        for other in ["Matte", "matte ", "mat", ""] {
            assert!(!truth!(a = text("matte"), b = text(other) => result), "{other:?}");
        }
    }
}
