use crate::emit::functions::conventions::int_divide_or_zero;

node! {
    /// Quotient `a / b` of integers, rounded down: it goes with `integer_modulo`, so that
    /// `a = b integer_divide(a, b) + integer_modulo(a, b)`. Exact; a division by 0 gives 0. C, OSL and GLSL
    /// round toward zero, which differs where one of the two is negative.
    integer_divide in integers,
    source "",
    inputs {
        /// What is divided.
        a: integer = 0;
        /// What it is divided by.
        b: integer = 1, avoid zero;
    }
    outputs {
        /// The quotient.
        result: integer;
    }
    body |e, i| Outputs { result: int_divide_or_zero(i.a, i.b) }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::{Division, floored_divisions};

    #[test]
    fn rounds_down() {
        for (a, b, expected) in [
            (7, 2, 3),
            (-7, 2, -4),
            (7, -2, -4),
            (-7, -2, 3),
            (7, 0, 0),
            (i32::MIN, -1, i32::MIN),
            (i32::MAX, 1, i32::MAX),
        ] {
            assert_eq!(number!(a = a, b = b => result).to_bits() as i32, expected, "{a} and {b}");
        }
    }

    #[test]
    fn agrees_with_64_bits() {
        for Division { a, b, quotient, .. } in floored_divisions() {
            let result = number!(a = a, b = b => result).to_bits() as i32;
            assert_eq!(result, quotient, "{a} and {b}");
        }
    }
}
