use crate::emit::Real;

node! {
    /// A whole number made of a scalar, rounded as it is told. NaN gives 0, and what lies outside
    /// -2147483648..2147483647 the nearer end. An integer becomes a scalar by itself, where one is due.
    /// OSL's `(int)` and GLSL's `int()` round toward zero; MaterialX has a node for each rounding.
    to_integer in integers,
    source "",
    inputs {
        /// What is rounded.
        input: scalar = 0.0;
        /// To which whole number; `nearest` takes the even one of two as near.
        rounding: choice = 0, of ["floor", "nearest", "ceiling", "toward_zero"];
    }
    outputs {
        /// The whole number.
        result: integer;
    }
    body |e, i| {
        let rounded = match i.rounding {
            0 => i.input.floor(),
            1 => i.input.round_even(),
            2 => i.input.ceil(),
            _ => i.input,
        };
        Outputs { result: rounded.to_int() }
    }
}

#[cfg(test)]
mod tests {
    fn rounded(input: f32) -> [i32; 4] {
        [0, 1, 2, 3].map(|way| number!(input = input, rounding = way => result).to_bits() as i32)
    }

    #[test]
    fn rounds_in_four_ways() {
        for (input, expected) in [
            (2.5, [2, 2, 3, 2]),
            (3.5, [3, 4, 4, 3]),
            (-2.5, [-3, -2, -2, -2]),
            (1.0_f32.next_down(), [0, 1, 1, 0]),
            (-1e-45, [-1, 0, 0, 0]),
            (-0.0, [0; 4]),
            (16_777_216.0, [16_777_216; 4]),
        ] {
            assert_eq!(rounded(input), expected, "{input:e}");
        }
    }

    #[test]
    fn what_is_no_integer_is_the_nearest() {
        assert_eq!(rounded(f32::NAN), [0; 4]);
        for (input, expected) in [(3e9, i32::MAX), (f32::INFINITY, i32::MAX), (-1e30, i32::MIN)] {
            assert_eq!(rounded(input), [expected; 4], "{input:e}");
        }
    }
}
