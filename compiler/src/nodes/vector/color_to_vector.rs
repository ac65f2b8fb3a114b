use crate::emit::Vector;
use crate::nodes::BLACK;

node! {
    /// A vector with the components of a colour, without its alpha.
    color_to_vector in vector,
    source "",
    inputs {
        /// The colour.
        color: color = BLACK;
    }
    outputs {
        /// Red, green and blue.
        vector: vector;
    }
    body |e, i| Outputs { vector: Vector { x: i.color.r, y: i.color.g, z: i.color.b } }
}

#[cfg(test)]
mod tests {
    #[test]
    fn keeps_the_components() {
        assert_eq!(numbers!(color = [1.0, -2.0, 3.0, 0.5] => vector), [1.0, -2.0, 3.0]);
    }
}
