use crate::emit::functions::figures::{Place, on_line, one_where};
use crate::nodes::finite::{FACTOR, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// 1 within `radius` of the line from `from` to `to`, its ends round, else 0. Both points are moved by
    /// `center`.
    line in patterns,
    source "MaterialX 1.39",
    inputs {
        /// Where to look: across.
        u: scalar = state(Field::U), in FACTOR;
        /// Where to look: up.
        v: scalar = state(Field::V), in FACTOR;
        /// What both points are moved by; x and y count.
        center: vector = [0.0; 3], in FACTOR;
        /// Half of the line's width.
        radius: scalar = 0.1, in FACTOR, soft UNIT;
        /// One end; x and y count.
        from: vector = [0.25, 0.25, 0.0], in FACTOR;
        /// The other end; x and y count.
        to: vector = [0.75, 0.75, 0.0], in FACTOR;
    }
    outputs {
        /// 1 on the line, 0 elsewhere.
        result: scalar, in 0.0..=1.0;
    }
    body |e, i| {
        let at = Place { x: i.u - i.center.x, y: i.v - i.center.y };
        let (from, to) = (Place { x: i.from.x, y: i.from.y }, Place { x: i.to.x, y: i.to.y });
        Outputs { result: one_where(e, on_line(at, from, to, i.radius)) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn it_has_round_ends_and_may_be_a_point() {
        let on = |u: f32, v: f32, to: [f32; 3]| {
            number!(u = u, v = v, from = [0.0; 3], to = to, radius = 0.25 => result) == 1.0
        };
        let along = [1.0, 0.0, 0.0];
        assert!(on(0.5, 0.25, along) && !on(0.5, 0.26, along));
        assert!(on(1.2, 0.1, along) && !on(1.2, 0.2, along) && on(-0.25, 0.0, along));
        assert!(on(0.0, 0.25, [0.0; 3]) && !on(0.2, 0.2, [0.0; 3]));
    }

    #[test]
    fn a_radius_below_nothing_has_no_line() {
        assert_eq!(number!(u = 0.5, v = 0.5, radius = -1.0 => result), 0.0);
    }
}
