node! {
    /// Whether the condition does not hold.
    not in logic,
    source "",
    inputs {
        /// The condition.
        input: boolean = false;
    }
    outputs {
        /// Its opposite.
        result: boolean;
    }
    body |e, i| Outputs { result: !i.input }
}

#[cfg(test)]
mod tests {
    #[test]
    fn truth_table() {
        assert!(truth!(input = false => result));
        assert!(!truth!(input = true => result));
    }
}
