use crate::emit::Real;
use crate::emit::functions::conventions::clamp_finite;

node! {
    /// Quotient `a / b`, per component. Division by zero gives 0, and a quotient that overflows the
    /// largest finite number. A colour keeps the alpha of `a`.
    divide in arithmetic per component,
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
    body |e, i| clamp_finite(i.a.divide_or_zero(i.b))
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
    fn divides_each_component() {
        assert_eq!(
            numbers!(a = [1.0, 2.0, 3.0], b = [4.0, 0.0, -2.0] => result),
            [0.25, 0.0, -1.5]
        );
    }
}
