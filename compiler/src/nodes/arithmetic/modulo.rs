use crate::emit::functions::conventions::modulo_or_zero;

node! {
    /// Floored remainder `a - b floor(a / b)`, per component: it lies between 0 and `b` and has the
    /// sign of `b`. A remainder by zero is 0, and so is one of a quotient beyond what numbers
    /// resolve. A colour keeps the alpha of `a`.
    modulo in arithmetic per component,
    source "",
    inputs {
        /// What is divided.
        a: generic = 0.0;
        /// The period.
        b: generic = 1.0, avoid zero;
    }
    outputs {
        /// The remainder.
        result: generic;
    }
    body |e, i| modulo_or_zero(i.a, i.b)
}

#[cfg(test)]
mod tests {
    #[test]
    fn has_the_sign_of_the_period() {
        assert_eq!(number!(a = -5.5, b = 2.0 => result), 0.5);
        assert_eq!(number!(a = 5.5, b = -2.0 => result), -0.5);
        assert_eq!(number!(a = 5.5, b = 2.0 => result), 1.5);
        assert_eq!(
            numbers!(a = [7.0, -7.0, 6.0, 0.5], b = [3.0, 3.0, 3.0, 1.0] => result),
            [1.0, 2.0, 0.0, 0.5]
        );
    }

    #[test]
    fn a_zero_period_gives_zero() {
        assert_eq!(number!(a = 5.5, b = 0.0 => result), 0.0);
        assert_eq!(number!(a = 5.5, b = -0.0 => result), 0.0);
    }

    #[test]
    fn agrees_with_an_exact_remainder() {
        for k in 1..2000_i32 {
            let (a, b) = (k as f32 * 0.37 - 300.0, (k % 17) as f32 * 0.1 + 0.3);
            let exact = f64::from(a).rem_euclid(f64::from(b)) as f32;
            assert_eq!(number!(a = a, b = b => result), exact, "{a} mod {b}");
        }
    }

    #[test]
    fn huge_quotients_stay_inside() {
        for (a, b) in [(1e30, 0.7), (-1e30, 0.7), (f32::MAX, 1e-45), (-f32::MAX, 1e-45)] {
            let rest = number!(a = a, b = b => result);
            assert!((0.0..b).contains(&rest), "{a} mod {b} = {rest}");
        }
    }
}
