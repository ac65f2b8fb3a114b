use crate::emit::Emit;

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
}

#[inline(always)]
fn body<E: Emit>(_: E, i: &Inputs<E>) -> Outputs<E> {
    Outputs { value: i.value }
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
