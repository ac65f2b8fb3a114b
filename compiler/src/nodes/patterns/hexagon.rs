use crate::emit::Vector;
use crate::emit::functions::figures::{Place, in_hexagon, one_where};
use crate::nodes::finite::{FACTOR, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// 1 inside a regular hexagon round `center`, else 0. Two of its sides are upright.
    hexagon in patterns,
    source "MaterialX 1.39",
    inputs {
        /// Where to look: across.
        u: scalar = state(Field::U), in FACTOR;
        /// Where to look: up.
        v: scalar = state(Field::V), in FACTOR;
        /// The middle; x and y count.
        center: vector = [0.0; 3], in FACTOR;
        /// Distance from the middle to a side.
        radius: scalar = 0.5, in FACTOR, soft UNIT;
    }
    outputs {
        /// 1 inside, 0 outside.
        result: scalar, in 0.0..=1.0;
    }
    body |e, i| {
        let Vector { x, y, .. } = i.center;
        let at = Place { x: i.u - x, y: i.v - y };
        Outputs { result: one_where(e, in_hexagon(at, i.radius)) }
    }
}

#[cfg(test)]
mod tests {
    fn inside(u: f32, v: f32) -> bool {
        number!(u = u, v = v, center = [0.5, -0.25, 9.0], radius = 0.25 => result) == 1.0
    }

    #[test]
    fn sides_are_upright_and_corners_above_and_below() {
        assert!(inside(0.75, -0.25) && !inside(0.751, -0.25));
        // The corner: the radius over the cosine of 30 degrees.
        assert!(inside(0.5, 0.038) && !inside(0.5, 0.039));
        assert!(inside(0.749, -0.11) && !inside(0.749, -0.10));
    }
}
