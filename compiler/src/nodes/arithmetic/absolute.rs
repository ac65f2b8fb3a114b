use crate::emit::{Components, Emit};
use crate::nodes::NOT_NEGATIVE;

node! {
    /// The value without its sign, per component. A colour keeps its alpha.
    absolute in arithmetic generic,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// Its magnitude.
        result: generic, in NOT_NEGATIVE;
    }
}

#[inline(always)]
fn body<E: Emit, T: Components<E::Real>>(_: E, i: &Inputs<E, T>) -> Outputs<T> {
    Outputs { result: i.input.absolute() }
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
