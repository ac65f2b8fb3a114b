use crate::nodes::BLACK;

node! {
    /// The components of a colour.
    split_color in color,
    source "",
    inputs {
        /// The colour.
        color: color = BLACK;
    }
    outputs {
        /// Red.
        r: scalar;
        /// Green.
        g: scalar;
        /// Blue.
        b: scalar;
        /// Alpha.
        a: scalar;
    }
    body |e, i| Outputs { r: i.color.r, g: i.color.g, b: i.color.b, a: i.color.a }
}

#[cfg(test)]
mod tests {
    #[test]
    fn keeps_the_order() {
        assert_eq!(number!(color = [1.0, -2.0, 3.0, 0.5] => r), 1.0);
        assert_eq!(number!(color = [1.0, -2.0, 3.0, 0.5] => g), -2.0);
        assert_eq!(number!(color = [1.0, -2.0, 3.0, 0.5] => b), 3.0);
        assert_eq!(number!(color = [1.0, -2.0, 3.0, 0.5] => a), 0.5);
    }
}
