use crate::emit::functions::conventions::clamp_finite;
use crate::emit::{Components, Emit};

node! {
    /// Quotient `a / b`, per component. Division by zero gives 0, and a quotient that overflows the
    /// largest finite number. A colour keeps the alpha of `a`.
    divide in arithmetic generic,
    source "",
    inputs {
        /// What is divided.
        a: generic = 1.0;
        /// What it is divided by.
        b: generic = 1.0, avoid zero;
    }
    outputs {
        /// The quotient.
        result: generic;
    }
}

#[inline(always)]
fn body<E: Emit, T: Components<E::Real>>(_: E, i: &Inputs<E, T>) -> Outputs<T> {
    let mut quotient = i.a.divide_or_zero(i.b).to_words();
    for component in &mut quotient[..3] {
        *component = clamp_finite(*component);
    }
    Outputs { result: T::from_words(quotient) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn zero_divides_to_zero() {
        for b in [0.0, -0.0] {
            assert_eq!(number!(a = 3.0, b = b => result), 0.0);
            assert_eq!(number!(a = 0.0, b = b => result), 0.0);
        }
    }

    #[test]
    fn overflow_is_held() {
        assert_eq!(number!(a = 1e30, b = 1e-30 => result), f32::MAX);
        assert_eq!(number!(a = -1e30, b = 1e-45 => result), f32::MIN);
        assert_eq!(number!(a = f32::MAX, b = f32::MIN => result), -1.0);
    }

    #[test]
    fn a_colour_keeps_its_alpha() {
        assert_eq!(
            numbers!(a = [1.0, 2.0, 3.0, 0.25], b = [4.0, 0.0, -2.0, 8.0] => result),
            [0.25, 0.0, -1.5, 0.25]
        );
    }
}
