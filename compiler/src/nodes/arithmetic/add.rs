use crate::emit::{Components, Emit};
use crate::nodes::finite::SUMMAND;

node! {
    /// Sum `a + b`, per component. A colour keeps the alpha of `a`.
    add in arithmetic generic,
    source "",
    inputs {
        /// First summand.
        a: generic = 0.0, in SUMMAND;
        /// Second summand.
        b: generic = 0.0, in SUMMAND;
    }
    outputs {
        /// The sum.
        result: generic;
    }
}

#[inline(always)]
fn body<E: Emit, T: Components<E::Real>>(_: E, i: &Inputs<E, T>) -> Outputs<T> {
    Outputs { result: i.a + i.b }
}

#[cfg(test)]
mod tests {
    #[test]
    fn adds_and_keeps_alpha() {
        assert_eq!(number!(a = 0.1, b = 0.2 => result), 0.1_f32 + 0.2);
        assert_eq!(numbers!(a = [1.0, 2.0, -3.0], b = [0.5, 0.5, 3.0] => result), [1.5, 2.5, 0.0]);
        let sum = numbers!(a = [0.1, 0.2, 0.3, 0.25], b = [1.0, 1.0, 1.0, 1.0] => result);
        assert_eq!(sum, [0.1_f32 + 1.0, 0.2 + 1.0, 0.3 + 1.0, 0.25]);
    }

    #[test]
    fn keeps_the_sign_of_zero() {
        assert_eq!(number!(a = -0.0, b = -0.0 => result).to_bits(), (-0.0_f32).to_bits());
        assert_eq!(number!(a = -0.0, b = 0.0 => result).to_bits(), 0.0_f32.to_bits());
    }
}
