use crate::emit::{Int, Mask};

node! {
    /// The greater of two integers.
    integer_maximum in integers,
    source "",
    inputs {
        /// One.
        a: integer = 0;
        /// The other.
        b: integer = 0;
    }
    outputs {
        /// The greater.
        result: integer;
    }
    body |e, i| Outputs { result: i.a.less(i.b).select(i.b, i.a) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn takes_the_greater() {
        for (a, b, expected) in
            [(2, 3, 3), (i32::MAX, i32::MIN, i32::MAX), (16_777_217, 16_777_216, 16_777_217)]
        {
            assert_eq!(number!(a = a, b = b => result).to_bits() as i32, expected, "{a} and {b}");
        }
    }
}
