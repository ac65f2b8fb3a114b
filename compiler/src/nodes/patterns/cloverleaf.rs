use crate::emit::Vector;
use crate::emit::functions::figures::{Place, in_cloverleaf, one_where};
use crate::nodes::finite::{FACTOR, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// 1 inside four leaves, circles of half the radius beside, above and below `center`, else 0.
    cloverleaf in patterns,
    source "MaterialX 1.39",
    inputs {
        /// Where to look: across.
        u: scalar = state(Field::U), in FACTOR;
        /// Where to look: up.
        v: scalar = state(Field::V), in FACTOR;
        /// The middle; x and y count.
        center: vector = [0.0; 3], in FACTOR;
        /// Distance from the middle to the tip of a leaf.
        radius: scalar = 0.5, in FACTOR, soft UNIT;
    }
    outputs {
        /// 1 inside, 0 outside.
        result: scalar, in 0.0..=1.0;
    }
    body |e, i| {
        let Vector { x, y, .. } = i.center;
        let at = Place { x: i.u - x, y: i.v - y };
        Outputs { result: one_where(e, in_cloverleaf(at, i.radius)) }
    }
}

#[cfg(test)]
mod tests {
    fn inside(u: f32, v: f32) -> bool {
        number!(u = u, v = v, center = [0.5, -0.25, 9.0], radius = 0.25 => result) == 1.0
    }

    #[test]
    fn leaves_reach_to_the_four_sides_and_leave_corners_free() {
        assert!(inside(0.75, -0.25) && inside(0.25, -0.25) && inside(0.5, 0.0));
        assert!(inside(0.5, -0.5) && inside(0.5, -0.25));
        assert!(!inside(0.7, -0.05) && !inside(0.751, -0.25));
    }
}
