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
            let expected = wide - down * by;
            assert_eq!(
                number!(a = a, b = b => result).to_bits() as i32,
                expected as i32,
                "{a} and {b}"
            );
        }
    }
}
