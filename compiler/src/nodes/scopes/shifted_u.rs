use crate::emit::Real;
use crate::emit::functions::bent_normal::along_surface;
use crate::nodes::{required, state};
use crate::state::Field;

node! {
    /// Evaluates `input` a step along the surface, the way of u: the point and the coordinate `u` go there
    /// together, so that patterns in space and textures are seen alike. Differences to the value here are slopes;
    /// `bump` takes them so. Where coordinates do not span the surface, the point goes along any tangent, and
    /// the coordinates stay.
    shifted_u in scopes scope [Point, U, V],
    source "Blinn 1978, Simulation of Wrinkled Surfaces; mental ray base shaders, mib_bump_map",
    inputs {
        /// Length of the step.
        step: scalar = 0.001, in -1e6..=1e6, unit "scene units", soft 0.0001..=0.1;
        /// How the point moves with u, of any length.
        derivative_u: vector = state(Field::DerivativeU);
        /// How the point moves with v, of any length.
        derivative_v: vector = state(Field::DerivativeV);
        /// The normal.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
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
    body |e, i| {
        let along = along_surface(i.derivative_u, i.derivative_v, i.normal);
        Changes {
            point: i.point + along.across * i.step,
            u: along.du.mul_add(i.step, i.u),
            v: i.v,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::{assert_close, changed};
    use crate::values::Literal;

    #[test]
    fn the_point_and_its_coordinate_go_together() {
        let given = [
            ("step", Literal::Scalar(0.5)),
            ("derivative_u", Literal::Vector([0.0, 4.0, 0.0])),
            ("derivative_v", Literal::Vector([2.0, 0.0, 0.0])),
            ("point", Literal::Vector([1.0, 2.0, 3.0])),
        ];
        let expected = [1.0, 2.5, 3.0, 0.125, 0.0];
        assert_close(&changed(&super::definition(), &given), &expected, 1e-6, 0.0);
    }

    #[test]
    fn without_coordinates_the_point_goes_alone() {
        let given = [("step", Literal::Scalar(0.5)), ("derivative_u", Literal::Vector([0.0; 3]))];
        let at = changed(&super::definition(), &given);
        let length = at[..3].iter().map(|x| x * x).sum::<f32>().sqrt();
        assert!((length - 0.5).abs() < 1e-6 && at[2] == 0.0 && at[3..] == [0.0; 2], "{at:?}");
    }
}
