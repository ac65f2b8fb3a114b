use crate::emit::functions::rotation::rotated;
use crate::nodes::finite::CUBED;

node! {
    /// A vector, or a point about `center`, turned round an axis by an angle in radians,
    /// counterclockwise seen against the axis (Rodrigues): `v cos + (axis x v) sin + axis (axis
    /// . v) (1 - cos)`. A zero axis turns nothing. MaterialX's rotate3d turns the other way, by
    /// degrees.
    rotate in vector,
    source "Rodrigues 1840",
    inputs {
        /// What is turned.
        vector: vector = [0.0; 3], in CUBED;
        /// What it is turned round, of any length.
        axis: vector = [0.0, 0.0, 1.0];
        /// The angle.
        angle: scalar = 0.0, unit "radians", soft -3.2..=3.2;
        /// A point the axis goes through.
        center: vector = [0.0; 3], in CUBED;
    }
    outputs {
        /// The turned vector.
        result: vector;
    }
    body |e, i| Outputs { result: rotated(i.vector - i.center, i.axis, i.angle) + i.center }
}

#[cfg(test)]
mod tests {
    use std::f32::consts::{FRAC_PI_2, PI};

    #[test]
    fn a_quarter_turn_about_z_takes_x_to_y() {
        let close = crate::nodes::harness::assert_close;
        let turned =
            numbers!(vector = [2.0, 0.0, 5.0], axis = [0.0, 0.0, 3.0], angle = FRAC_PI_2 => result);
        close(&turned, &[0.0, 2.0, 5.0], 1e-7, 1e-6);
        let about =
            numbers!(vector = [2.0, 0.0, 0.0], angle = PI, center = [1.0, 1.0, 0.0] => result);
        close(&about, &[0.0, 2.0, 0.0], 1e-6, 1e-6);
    }

    #[test]
    fn a_zero_axis_and_a_zero_angle_turn_nothing() {
        let vector = [1.0, -2.0, 3.0];
        assert_eq!(numbers!(vector = vector, axis = [0.0; 3], angle = 1.0 => result), vector);
        assert_eq!(numbers!(vector = vector, axis = [3.0, 1.0, 2.0] => result), vector);
    }

    #[test]
    fn tiny_angles_are_not_lost() {
        let turned = numbers!(vector = [1.0, 0.0, 0.0], angle = 1e-6 => result);
        assert_eq!(turned[1], 1e-6);
    }
}
