use crate::emit::Real;

node! {
    /// Smallest integer not below, per component; -0 from -1 to 0. A colour keeps its alpha.
    ceiling in arithmetic per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The integer.
        result: generic;
    }
    body |e, i| i.input.ceil()
}

#[cfg(test)]
mod tests {
    #[test]
    fn goes_up() {
        for (x, up) in [(1.2, 2.0), (-1.2, -1.0), (3.0, 3.0), (-0.5, 0.0), (1e30, 1e30)] {
            assert_eq!(number!(input = x => result), up);
        }
    }
}
