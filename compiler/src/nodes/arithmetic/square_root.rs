use crate::emit::functions::conventions::sqrt_or_zero;
use crate::emit::{Components, Emit};
use crate::nodes::NOT_NEGATIVE;

node! {
    /// Square root, correctly rounded, per component; of a negative value 0. A colour keeps its
    /// alpha.
    square_root in arithmetic generic,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The root.
        result: generic, in NOT_NEGATIVE;
    }
}

#[inline(always)]
fn body<E: Emit, T: Components<E::Real>>(_: E, i: &Inputs<E, T>) -> Outputs<T> {
    let mut root = i.input.to_words();
    for component in &mut root[..3] {
        *component = sqrt_or_zero(*component);
    }
    Outputs { result: T::from_words(root) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn negative_values_have_root_zero() {
        assert_eq!(numbers!(input = [4.0, -1.5, 0.25] => result), [2.0, 0.0, 0.5]);
        assert_eq!(number!(input = -0.0 => result).to_bits(), 0);
        assert_eq!(number!(input = 1e-45 => result), 1e-45_f32.sqrt());
        assert_eq!(numbers!(input = [4.0, 9.0, 16.0, 0.25] => result), [2.0, 3.0, 4.0, 0.25]);
    }
}
