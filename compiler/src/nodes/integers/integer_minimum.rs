use crate::emit::{Int, Mask};

node! {
    /// The lesser of two integers.
    integer_minimum in integers,
    source "",
    inputs {
        /// One.
        a: integer = 0;
        /// The other.
        b: integer = 0;
    }
    outputs {
        /// The lesser.
        result: integer;
    }
    body |e, i| Outputs { result: i.a.less(i.b).select(i.a, i.b) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn takes_the_lesser() {
        for (a, b, expected) in
            [(2, 3, 2), (i32::MAX, i32::MIN, i32::MIN), (16_777_217, 16_777_216, 16_777_216)]
        {
            assert_eq!(number!(a = a, b = b => result).to_bits() as i32, expected, "{a} and {b}");
        }
    }
}
