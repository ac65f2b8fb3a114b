use crate::emit::Transform;
use crate::emit::functions::rotation::{diagonal, rotated};

node! {
    /// The transform that turns round an axis through the origin by an angle in radians,
    /// counterclockwise seen against the axis. A zero axis turns nothing.
    rotation in transforms,
    source "Rodrigues 1840",
    inputs {
        /// What it turns round, of any length.
        axis: vector = [0.0, 0.0, 1.0];
        /// The angle.
        angle: scalar = 0.0, unit "radians", soft -3.2..=3.2;
    }
    outputs {
        /// The transform.
        transform: transform;
    }
    body |e, i| {
        let one = diagonal(e, e.real(1.0), e.real(1.0), e.real(1.0));
        let x = rotated(one.x, i.axis, i.angle);
        let y = rotated(one.y, i.axis, i.angle);
        let z = rotated(one.z, i.axis, i.angle);
        Outputs { transform: Transform { x, y, z, ..one } }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn takes_x_to_y_to_minus_x() {
        let rows = numbers!(angle = std::f32::consts::FRAC_PI_2 => transform);
        let expected =
            [0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        crate::nodes::harness::assert_close(&rows, &expected, 1e-7, 1e-7);
    }
}
