use crate::emit::Vector;
use crate::emit::functions::figures::{Place, in_circle, one_where};
use crate::nodes::finite::{FACTOR, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// 1 within `radius` of `center`, else 0.
    circle in patterns,
    source "MaterialX 1.39",
    inputs {
        /// Where to look: across.
        u: scalar = state(Field::U), in FACTOR;
        /// Where to look: up.
        v: scalar = state(Field::V), in FACTOR;
        /// The middle; x and y count.
        center: vector = [0.0; 3], in FACTOR;
        /// Distance from the middle to the rim.
        radius: scalar = 0.5, in FACTOR, soft UNIT;
    }
    outputs {
        /// 1 inside, 0 outside.
        result: scalar, in 0.0..=1.0;
    }
    body |e, i| {
        let Vector { x, y, .. } = i.center;
        let at = Place { x: i.u - x, y: i.v - y };
        Outputs { result: one_where(e, in_circle(at, i.radius)) }
    }
}

#[cfg(test)]
mod tests {
    fn inside(u: f32, v: f32) -> bool {
        number!(u = u, v = v, center = [0.5, -0.25, 9.0], radius = 0.25 => result) == 1.0
    }

    #[test]
    fn the_rim_is_inside() {
        assert!(inside(0.5, 0.0) && inside(0.25, -0.25) && inside(0.675, -0.075));
        assert!(!inside(0.5, 1e-6) && !inside(0.7, -0.05));
    }
}
