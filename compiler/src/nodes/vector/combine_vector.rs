use crate::emit::Vector;

node! {
    /// A vector from its three components.
    combine_vector in vector,
    source "",
    inputs {
        /// First component.
        x: scalar = 0.0;
        /// Second component.
        y: scalar = 0.0;
        /// Third component.
        z: scalar = 0.0;
    }
    outputs {
        /// The vector.
        vector: vector;
    }
    body |e, i| Outputs { vector: Vector { x: i.x, y: i.y, z: i.z } }
}

#[cfg(test)]
mod tests {
    #[test]
    fn keeps_the_order() {
        assert_eq!(numbers!(x = 1.0, y = -2.0, z = 3.0 => vector), [1.0, -2.0, 3.0]);
    }
}
