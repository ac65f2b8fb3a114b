use crate::emit::Color;

node! {
    /// A colour with the components of a vector.
    vector_to_color in vector,
    source "",
    inputs {
        /// Red, green and blue.
        vector: vector = [0.0; 3];
        /// Alpha: 1 is opaque.
        alpha: scalar = 1.0;
    }
    outputs {
        /// The colour.
        color: color;
    }
    body |e, i| Outputs { color: Color { r: i.vector.x, g: i.vector.y, b: i.vector.z, a: i.alpha } }
}

#[cfg(test)]
mod tests {
    #[test]
    fn keeps_the_components() {
        assert_eq!(numbers!(vector = [1.0, -2.0, 3.0] => color), [1.0, -2.0, 3.0, 1.0]);
    }
}
