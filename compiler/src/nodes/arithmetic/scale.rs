use crate::emit::{Components, Emit};
use crate::nodes::finite::FACTOR;

node! {
    /// Product of every component with one number. A colour keeps its alpha.
    scale in arithmetic generic,
    source "",
    inputs {
        /// What is scaled.
        input: generic = 1.0, in FACTOR;
        /// By how much.
        factor: scalar = 1.0, in FACTOR;
    }
    outputs {
        /// The product.
        result: generic;
    }
}

#[inline(always)]
fn body<E: Emit, T: Components<E::Real>>(_: E, i: &Inputs<E, T>) -> Outputs<T> {
    Outputs { result: i.input * i.factor }
}

#[cfg(test)]
mod tests {
    #[test]
    fn scales_all_but_alpha() {
        assert_eq!(number!(input = 3.0, factor = -0.5 => result), -1.5);
        assert_eq!(numbers!(input = [1.0, 2.0, 3.0], factor = 2.0 => result), [2.0, 4.0, 6.0]);
        assert_eq!(
            numbers!(input = [1.0, 2.0, 3.0, 0.75], factor = 0.0 => result),
            [0.0, 0.0, 0.0, 0.75]
        );
    }
}
