use crate::nodes::finite::CUBED;

node! {
    /// The part of a vector along another: `axis (vector . axis) / (axis . axis)`. Along the
    /// zero vector it is zero.
    project in vector,
    source "",
    inputs {
        /// What is projected.
        vector: vector = [0.0; 3], in CUBED;
        /// What it is projected onto, of any length.
        axis: vector = [0.0, 0.0, 1.0], in CUBED;
    }
    outputs {
        /// The part along the axis.
        result: vector;
    }
    body |e, i| {
        let axis = i.axis.normalized();
        Outputs { result: axis * i.vector.dot(axis) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_rest_is_at_right_angles() {
        assert_eq!(
            numbers!(vector = [3.0, 4.0, 5.0], axis = [0.0, 2.0, 0.0] => result),
            [0.0, 4.0, 0.0]
        );
        assert_eq!(numbers!(vector = [3.0, 4.0, 5.0], axis = [0.0; 3] => result), [0.0; 3]);
    }
}
