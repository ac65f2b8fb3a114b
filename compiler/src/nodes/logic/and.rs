node! {
    /// Whether both hold. `b` is evaluated only where `a` holds.
    and in logic,
    source "",
    inputs {
        /// First condition.
        a: boolean = true;
        /// Second condition; evaluated only where the first does not decide.
        b: boolean = true, when i.a;
    }
    outputs {
        /// Whether it holds.
        result: boolean;
    }
    body |e, i| Outputs { result: i.a & i.b }
}

#[cfg(test)]
mod tests {
    #[test]
    fn truth_table() {
        for (a, b) in [(false, false), (false, true), (true, false), (true, true)] {
            assert_eq!(truth!(a = a, b = b => result), a && b);
            assert_eq!(demanded!(a = a, b = b => b), a);
        }
    }
}
