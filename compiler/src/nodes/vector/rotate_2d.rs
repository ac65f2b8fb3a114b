use crate::emit::{Real, Vector};
use crate::nodes::finite::FACTOR;

node! {
    /// A vector turned about the z axis by an angle in radians, from x towards y; z stays.
    /// MaterialX's rotate2d turns the other way, by degrees.
    rotate_2d in vector,
    source "",
    inputs {
        /// What is turned.
        vector: vector = [0.0; 3], in FACTOR;
        /// The angle.
        angle: scalar = 0.0, unit "radians", soft -3.2..=3.2;
    }
    outputs {
        /// The turned vector.
        result: vector;
    }
    body |e, i| {
        let (sine, cosine) = (i.angle.sin(), i.angle.cos());
        let (x, y) = (i.vector.x, i.vector.y);
        let result = Vector {
            x: x.mul_add(cosine, -(y * sine)),
            y: x.mul_add(sine, y * cosine),
            z: i.vector.z,
        };
        Outputs { result }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_quarter_turn_takes_x_to_y() {
        let turned =
            numbers!(vector = [2.0, 0.0, 5.0], angle = std::f32::consts::FRAC_PI_2 => result);
        crate::nodes::harness::assert_close(&turned, &[0.0, 2.0, 5.0], 1e-7, 1e-6);
        assert_eq!(numbers!(vector = [2.0, 3.0, 5.0] => result), [2.0, 3.0, 5.0]);
    }
}
