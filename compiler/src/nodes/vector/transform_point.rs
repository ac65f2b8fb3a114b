use crate::nodes::finite::FACTOR;
use crate::values::Literal;

node! {
    /// Where a transform takes a point: `p.x X + p.y Y + p.z Z + T` for the rows X, Y, Z and T.
    transform_point in vector,
    source "mental ray manual, mi_point_transform",
    inputs {
        /// The point.
        point: vector = [0.0; 3], in FACTOR;
        /// The transform.
        transform: transform = Literal::IDENTITY, in FACTOR;
    }
    outputs {
        /// The point there.
        result: vector;
    }
    body |e, i| Outputs { result: i.transform.point(i.point) }
}

#[cfg(test)]
mod tests {
    use crate::values::Literal;

    #[test]
    fn rows_are_where_the_axes_go_and_the_last_is_the_translation() {
        let rows = Literal::Transform([
            0.0, 2.0, 0.0, 0.0, //
            -1.0, 0.0, 0.0, 0.0, //
            0.0, 0.0, 1.0, 0.0, //
            10.0, 20.0, 30.0, 1.0,
        ]);
        assert_eq!(
            numbers!(point = [1.0, 2.0, 3.0], transform = rows => result),
            [8.0, 22.0, 33.0]
        );
    }

    #[test]
    fn the_identity_keeps_every_point() {
        for x in [0.0, 1e-45, -1.5, 1e19] {
            assert_eq!(numbers!(point = [x, -x, 0.5] => result), [x, -x, 0.5]);
        }
    }
}
