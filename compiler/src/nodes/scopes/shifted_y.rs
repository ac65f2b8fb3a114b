use crate::emit::Real;
use crate::nodes::{required, state};
use crate::state::Field;

node! {
    /// Evaluates `input` a step across what the pixel covers, along the shorter axis of its footprint: the point
    /// and the surface coordinates go there together. Differences to the value here, divided by the step, are how it
    /// changes from pixel to pixel; `texture_lookup` takes its footprint so where its coordinates are computed.
    shifted_y in scopes scope [Point, U, V],
    source "OSL 1.13, Dx and Dy",
    inputs {
        /// Length of the step, as a part of the axis: short ones keep the jumps of coordinates, as at the back of
        /// a sphere, from blurring more than a part of a pixel.
        step: scalar = 0.125, in -1.0..=1.0;
        /// How the point moves along the axis, in scene units.
        dp_dy: vector = state(Field::DpDy);
        /// How u changes along the axis.
        du_dy: scalar = state(Field::DuDy);
        /// How v changes along the axis.
        dv_dy: scalar = state(Field::DvDy);
        /// The point.
        point: vector = state(Field::Point);
        /// First coordinate.
        u: scalar = state(Field::U);
        /// Second coordinate.
        v: scalar = state(Field::V);
    }
    scoped {
        /// What is evaluated there.
        input: generic = required();
    }
    changes { point: vector; u: scalar; v: scalar; }
    outputs {
        /// Its value there.
        result: generic;
    }
    body |e, i| Changes {
        point: i.point + i.dp_dy * i.step,
        u: i.du_dy.mul_add(i.step, i.u),
        v: i.dv_dy.mul_add(i.step, i.v),
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::changed;
    use crate::values::Literal;

    #[test]
    fn point_and_coordinates_go_together() {
        let given = [
            ("step", Literal::Scalar(0.5)),
            ("dp_dy", Literal::Vector([2.0, 0.0, -4.0])),
            ("du_dy", Literal::Scalar(0.25)),
            ("dv_dy", Literal::Scalar(-8.0)),
            ("u", Literal::Scalar(1.0)),
            ("v", Literal::Scalar(2.0)),
            ("point", Literal::Vector([0.0, 1.0, 0.0])),
        ];
        assert_eq!(changed(&super::definition(), &given), [1.0, 1.0, -2.0, 1.125, -2.0]);
    }
}
