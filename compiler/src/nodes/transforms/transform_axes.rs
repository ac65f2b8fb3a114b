use crate::emit::Transform;
use crate::values::Literal;

node! {
    /// Where a transform takes the axes and the origin: its rows.
    transform_axes in transforms,
    source "",
    inputs {
        /// The transform.
        transform: transform = Literal::IDENTITY;
    }
    outputs {
        /// Where the x axis goes.
        x: vector;
        /// Where the y axis goes.
        y: vector;
        /// Where the z axis goes.
        z: vector;
        /// Where the origin goes.
        translation: vector;
    }
    body |e, i| {
        let Transform { x, y, z, translation } = i.transform;
        Outputs { x, y, z, translation }
    }
}

#[cfg(test)]
mod tests {
    use crate::values::Literal;

    #[test]
    fn the_rows_are_the_axes() {
        let rows = Literal::Transform([
            1.0, 2.0, 3.0, 0.0, 4.0, 5.0, 6.0, 0.0, 7.0, 8.0, 9.0, 0.0, -1.0, -2.0, -3.0, 1.0,
        ]);
        assert_eq!(numbers!(transform = rows.clone() => y), [4.0, 5.0, 6.0]);
        assert_eq!(numbers!(transform = rows => translation), [-1.0, -2.0, -3.0]);
    }
}
