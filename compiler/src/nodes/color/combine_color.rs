use crate::emit::Color;

node! {
    /// A colour from its components.
    combine_color in color,
    source "",
    inputs {
        /// Red.
        r: scalar = 0.0;
        /// Green.
        g: scalar = 0.0;
        /// Blue.
        b: scalar = 0.0;
        /// Alpha: 1 is opaque.
        a: scalar = 1.0;
    }
    outputs {
        /// The colour.
        color: color;
    }
    body |e, i| Outputs { color: Color { r: i.r, g: i.g, b: i.b, a: i.a } }
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_opaque_unasked() {
        assert_eq!(numbers!(r = 0.1, g = 0.2, b = 3.0 => color), [0.1, 0.2, 3.0, 1.0]);
        assert_eq!(numbers!(r = 0.1, g = 0.2, b = 3.0, a = 0.5 => color), [0.1, 0.2, 3.0, 0.5]);
    }
}
