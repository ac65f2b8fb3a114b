use crate::emit::Real;
use crate::nodes::NOT_NEGATIVE;

node! {
    /// The value without its sign, per component. A colour keeps its alpha.
    absolute in arithmetic per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// Its magnitude.
        result: generic, in NOT_NEGATIVE;
    }
    body |e, i| i.input.absolute()
}

#[cfg(test)]
mod tests {
    #[test]
    fn drops_the_sign() {
        assert_eq!(number!(input = -0.0 => result).to_bits(), 0);
        assert_eq!(numbers!(input = [-1.5, 2.0, -1e-45] => result), [1.5, 2.0, 1e-45]);
        assert_eq!(numbers!(input = [-1.5, 2.0, -3.0, -1.0] => result), [1.5, 2.0, 3.0, -1.0]);
    }
}
