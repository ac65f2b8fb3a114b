use crate::emit::Real;

node! {
    /// Integer part, towards zero, per component; -0 from -1 to 0. `floor` goes down below zero
    /// too. A colour keeps its alpha.
    truncate in arithmetic per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The integer.
        result: generic;
    }
    body |e, i| i.input.truncate()
}

#[cfg(test)]
mod tests {
    #[test]
    fn goes_towards_zero() {
        for (x, part) in [(1.8, 1.0), (-1.8, -1.0), (3.0, 3.0), (-0.5, 0.0), (-1e30, -1e30)] {
            assert_eq!(number!(input = x => result), part);
        }
    }
}
