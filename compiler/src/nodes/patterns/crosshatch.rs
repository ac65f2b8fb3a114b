use crate::emit::Real;
use crate::emit::functions::figures::{Place, is_odd, on_line, one_where, within_tile};
use crate::nodes::finite::{FACTOR, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Both diagonals of every tile: 1 on them, else 0. MaterialX's `crosshatch`.
    crosshatch in patterns,
    source "MaterialX 1.39, crosshatch",
    inputs {
        /// Where to look: across.
        u: scalar = state(Field::U), in FACTOR;
        /// Where to look: up.
        v: scalar = state(Field::V), in FACTOR;
        /// Tiles per unit; x and y count.
        tiling: vector = [8.0, 8.0, 8.0], in FACTOR, soft 0.0..=100.0;
        /// What the hatch is moved by, in tiles; x and y count.
        offset: vector = [0.0; 3], in FACTOR, unit "tiles", soft UNIT;
        /// Half of a line's width, in half tiles.
        thickness: scalar = 0.05, in FACTOR, soft UNIT;
        /// Whether every other row is moved by half a tile.
        staggered: boolean = false;
    }
    outputs {
        /// 1 on lines.
        result: scalar, in 0.0..=1.0;
    }
    body |e, i| {
        let (x, y) = (i.u * i.tiling.x - i.offset.x, i.v * i.tiling.y - i.offset.y);
        let one = e.real(1.0);
        let upper = is_odd(y) & (y - y.floor()).greater(e.real(0.0));
        let x = x + one_where(e, upper & i.staggered) * 0.5;
        let at = Place { x: within_tile(x) * 2.0 - 1.0, y: within_tile(y) * 2.0 - 1.0 };
        let (low, high) = (Place { x: -one, y: -one }, Place { x: one, y: one });
        let (left, right) = (Place { x: -one, y: one }, Place { x: one, y: -one });
        let rising = on_line(at, high, low, i.thickness);
        Outputs { result: one_where(e, rising | on_line(at, left, right, i.thickness)) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn diagonals_cross_in_the_middle_and_meet_at_corners() {
        let on = |u: f32, v: f32| {
            number!(u = u, v = v, tiling = [1.0; 3], thickness = 0.1 => result) == 1.0
        };
        assert!(on(0.5, 0.5) && on(0.0, 0.0) && on(0.25, 0.25) && on(0.25, 0.75));
        assert!(on(0.57, 0.5) && !on(0.58, 0.5) && !on(0.5, 0.0));
        assert!(on(-3.75, 7.25) && !on(-3.5, 7.0));
    }

    #[test]
    fn every_other_row_may_be_moved() {
        let on = |u: f32, v: f32| {
            number!(u = u, v = v, tiling = [1.0; 3], thickness = 0.1, staggered = true => result)
                == 1.0
        };
        assert!(on(0.5, 0.5) && !on(0.5, 1.5) && on(0.0, 1.5) && on(1.0, 1.5));
    }
}
