use crate::emit::{Transform, Vector};
use crate::values::Literal;

node! {
    /// Rows and columns exchanged of X, Y and Z; for a rotation it is the inverse. The
    /// translation is dropped, as there is no room for it in an affine transform.
    transpose in transforms,
    source "",
    inputs {
        /// The transform.
        transform: transform = Literal::IDENTITY;
    }
    outputs {
        /// Its transpose.
        result: transform;
    }
    body |e, i| {
        let (x, y, z) = (i.transform.x, i.transform.y, i.transform.z);
        let zero = e.real(0.0);
        let result = Transform {
            x: Vector { x: x.x, y: y.x, z: z.x },
            y: Vector { x: x.y, y: y.y, z: z.y },
            z: Vector { x: x.z, y: y.z, z: z.z },
            translation: Vector { x: zero, y: zero, z: zero },
        };
        Outputs { result }
    }
}

#[cfg(test)]
mod tests {
    use crate::values::Literal;

    #[test]
    fn rows_become_columns() {
        let rows = [1.0, 2.0, 3.0, 0.0, 4.0, 5.0, 6.0, 0.0, 7.0, 8.0, 9.0, 0.0, 1.0, 1.0, 1.0, 1.0];
        let columns = numbers!(transform = Literal::Transform(rows) => result);
        let expected =
            [1.0, 4.0, 7.0, 0.0, 2.0, 5.0, 8.0, 0.0, 3.0, 6.0, 9.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        assert_eq!(columns, expected);
    }
}
