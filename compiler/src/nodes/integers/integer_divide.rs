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
        let hard = [
            i32::MIN,
            i32::MIN + 1,
            -16_777_217,
            -3,
            -1,
            1,
            2,
            3,
            10,
            4097,
            16_777_217,
            i32::MAX - 1,
            i32::MAX,
        ];
        for (a, b) in hard.iter().flat_map(|&a| hard.map(|b| (a, b))) {
            let (wide, by) = (i64::from(a), i64::from(b));
            let down = wide.div_euclid(by) - i64::from(by < 0 && wide.rem_euclid(by) != 0);
            let expected = down;
            assert_eq!(
                number!(a = a, b = b => result).to_bits() as i32,
                expected as i32,
                "{a} and {b}"
            );
        }
    }
}
