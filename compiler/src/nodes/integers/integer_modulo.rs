use crate::emit::functions::conventions::int_modulo_or_zero;

node! {
    /// Floored remainder `a - b floor(a / b)` of integers: between 0 and `b`, of the sign of `b`. Exact; a
    /// remainder by 0 is 0. C, OSL and GLSL give it the sign of `a`.
    integer_modulo in integers,
    source "",
    inputs {
        /// What is divided.
        a: integer = 0;
        /// The period.
        b: integer = 1, avoid zero;
    }
    outputs {
        /// The remainder.
        result: integer;
    }
    body |e, i| Outputs { result: int_modulo_or_zero(i.a, i.b) }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::{Division, floored_divisions};

    #[test]
    fn has_the_sign_of_the_period() {
        for (a, b, expected) in [
            (7, 3, 1),
            (-7, 3, 2),
            (7, -3, -2),
            (-7, -3, -1),
            (6, 3, 0),
            (7, 0, 0),
            (i32::MIN, -1, 0),
            (i32::MIN, 10, 2),
        ] {
            assert_eq!(number!(a = a, b = b => result).to_bits() as i32, expected, "{a} and {b}");
        }
    }

    #[test]
    fn agrees_with_64_bits() {
        for Division { a, b, remainder, .. } in floored_divisions() {
            let result = number!(a = a, b = b => result).to_bits() as i32;
            assert_eq!(result, remainder, "{a} and {b}");
        }
    }
}
