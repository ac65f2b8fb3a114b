use crate::nodes::finite::CUBED;
use crate::values::Literal;

node! {
    /// Determinant of a transform's rows X, Y and Z: the volume of what it makes of the unit
    /// cube, negative where it mirrors. That of the whole matrix is the same.
    determinant in transforms,
    source "",
    inputs {
        /// The transform.
        transform: transform = Literal::IDENTITY, in CUBED;
    }
    outputs {
        /// The determinant.
        result: scalar;
    }
    body |e, i| Outputs { result: i.transform.x.dot(i.transform.y.cross(i.transform.z)) }
}

#[cfg(test)]
mod tests {
    use crate::values::Literal;

    #[test]
    fn is_the_volume() {
        let rows = Literal::Transform([
            2.0, 1.0, 0.0, 0.0, 0.0, 3.0, 5.0, 0.0, 0.0, 0.0, -4.0, 0.0, 7.0, 8.0, 9.0, 1.0,
        ]);
        assert_eq!(number!(transform = rows => result), -24.0);
        assert_eq!(number!( => result), 1.0);
    }
}
