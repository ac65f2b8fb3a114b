use crate::emit::Transform;

node! {
    /// The transform that takes the axes and the origin to given places: its rows.
    transform_from_axes in transforms,
    source "",
    inputs {
        /// Where the x axis goes.
        x: vector = [1.0, 0.0, 0.0];
        /// Where the y axis goes.
        y: vector = [0.0, 1.0, 0.0];
        /// Where the z axis goes.
        z: vector = [0.0, 0.0, 1.0];
        /// Where the origin goes.
        translation: vector = [0.0; 3];
    }
    outputs {
        /// The transform.
        transform: transform;
    }
    body |e, i| {
        let (x, y, z, translation) = (i.x, i.y, i.z, i.translation);
        Outputs { transform: Transform { x, y, z, translation } }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_axes_are_the_rows() {
        let rows = numbers!(y = [4.0, 5.0, 6.0], translation = [7.0, 8.0, 9.0] => transform);
        let expected =
            [1.0, 0.0, 0.0, 0.0, 4.0, 5.0, 6.0, 0.0, 0.0, 0.0, 1.0, 0.0, 7.0, 8.0, 9.0, 1.0];
        assert_eq!(rows, expected);
    }
}
