node! {
    /// The three components of a vector.
    split_vector in vector,
    source "",
    inputs {
        /// The vector.
        vector: vector = [0.0; 3];
    }
    outputs {
        /// First component.
        x: scalar;
        /// Second component.
        y: scalar;
        /// Third component.
        z: scalar;
    }
    body |e, i| Outputs { x: i.vector.x, y: i.vector.y, z: i.vector.z }
}

#[cfg(test)]
mod tests {
    #[test]
    fn keeps_the_order() {
        assert_eq!(number!(vector = [1.0, -2.0, 3.0] => x), 1.0);
        assert_eq!(number!(vector = [1.0, -2.0, 3.0] => y), -2.0);
        assert_eq!(number!(vector = [1.0, -2.0, 3.0] => z), 3.0);
    }
}
