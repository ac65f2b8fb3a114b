use crate::emit::Real;
use crate::emit::functions::figures::{is_odd, one_where, within_tile};
use crate::nodes::finite::{FACTOR, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Lines between tiles: 1 on them, 0 within the tiles. MaterialX's `grid`.
    grid in patterns,
    source "MaterialX 1.39, grid",
    inputs {
        /// Where to look: across.
        u: scalar = state(Field::U), in FACTOR;
        /// Where to look: up.
        v: scalar = state(Field::V), in FACTOR;
        /// Tiles per unit; x and y count.
        tiling: vector = [8.0, 8.0, 8.0], in FACTOR, soft 0.0..=100.0;
        /// What the grid is moved by, in tiles; x and y count.
        offset: vector = [0.0; 3], in FACTOR, unit "tiles", soft UNIT;
        /// Share of the tile that lines cover, half of it on each side.
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
        // The half row at the start of an odd one is not moved, as MaterialX has it.
        let upper = is_odd(y) & (y - y.floor()).greater(e.real(0.0));
        let x = x + one_where(e, upper & i.staggered) * 0.5;
        let across = (within_tile(x) * 2.0 - 1.0).absolute();
        let up = (within_tile(y) * 2.0 - 1.0).absolute();
        Outputs { result: one_where(e, across.maximum(up).greater(one - i.thickness)) }
    }
}

#[cfg(test)]
mod tests {
    fn on(u: f32, v: f32, staggered: bool) -> bool {
        let tiling = [2.0, 2.0, 0.0];
        number!(u = u, v = v, tiling = tiling, thickness = 0.25, staggered = staggered => result)
            == 1.0
    }

    #[test]
    fn lines_go_round_tiles() {
        assert!(on(0.0, 0.25, false) && on(0.5, 0.25, false) && on(0.25, 0.0, false));
        assert!(on(0.06, 0.25, false) && !on(0.07, 0.25, false) && on(-0.06, 0.25, false));
        assert!(!on(0.25, 0.25, false) && !on(-0.75, 0.25, false));
    }

    #[test]
    fn every_other_row_may_be_moved() {
        assert!(on(0.0, 0.25, true) && !on(0.25, 0.25, true));
        assert!(!on(0.0, 0.75, true) && on(0.25, 0.75, true));
    }
}
