node! {
    /// Whether exactly one of two holds.
    xor in logic,
    source "",
    inputs {
        /// First.
        a: boolean = false;
        /// Second.
        b: boolean = false;
    }
    outputs {
        /// Whether it holds.
        result: boolean;
    }
    body |e, i| Outputs { result: i.a ^ i.b }
}

#[cfg(test)]
mod tests {
    #[test]
    fn exactly_one_holds() {
        for (a, b) in [(false, false), (false, true), (true, false), (true, true)] {
            assert_eq!(truth!(a = a, b = b => result), a != b);
        }
    }
}
