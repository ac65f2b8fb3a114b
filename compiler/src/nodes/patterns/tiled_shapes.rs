use crate::emit::functions::figures::{
    Place, in_circle, in_cloverleaf, in_hexagon, is_odd, one_where, within_tile,
};
use crate::emit::{Emit, Mask};
use crate::nodes::finite::{FACTOR, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// One figure in each tile: 1 inside, 0 between. MaterialX's `tiledcircles`, `tiledcloverleafs` and
    /// `tiledhexagons`; `circle`, `cloverleaf` and `hexagon` are single ones. A size of 1 fills the tile.
    ///
    /// Staggered figures of half that size stand in rows moved by half a tile: circles and hexagons as close
    /// as they go, rows 0.866 tiles apart, so that hexagons of size 1 leave nothing between them;
    /// cloverleafs in rows half a tile apart.
    tiled_shapes in patterns,
    source "MaterialX 1.39",
    inputs {
        /// Where to look: across.
        u: scalar = state(Field::U), in FACTOR;
        /// Where to look: up.
        v: scalar = state(Field::V), in FACTOR;
        /// Tiles per unit; x and y count.
        tiling: vector = [4.0, 4.0, 4.0], in FACTOR, soft 0.0..=100.0;
        /// What the tiles are moved by, in tiles; x and y count.
        offset: vector = [0.0; 3], in FACTOR, unit "tiles", soft UNIT;
        /// Size of a figure: 1 reaches the edges of its tile.
        size: scalar = 0.5, in FACTOR, soft UNIT;
        /// Whether every other row is moved by half a tile.
        staggered: boolean = false;
        /// The figure.
        shape: choice = 0, of ["circle", "cloverleaf", "hexagon"];
    }
    outputs {
        /// 1 inside.
        result: scalar, in 0.0..=1.0;
    }
    body |e, i| {
        let (x, y) = (i.u * i.tiling.x - i.offset.x, i.v * i.tiling.y - i.offset.y);
        let middle = Place { x: within_tile(x) * 2.0 - 1.0, y: within_tile(y) * 2.0 - 1.0 };
        let regular = inside::<E>(i.shape, middle, i.size);
        let staggered = closest(e, i.shape, x, y, i.size * 0.5);
        Outputs { result: one_where(e, i.staggered.select(staggered, regular)) }
    }
}

/// Inside the figure of this number.
#[inline(always)]
fn inside<E: Emit>(shape: i32, at: Place<E::Real>, radius: E::Real) -> E::Mask {
    match shape {
        0 => in_circle(at, radius),
        1 => in_cloverleaf(at, radius),
        _ => in_hexagon(at, radius),
    }
}

/// Inside one of the figures at the lower corners of a tile or above the middle between them.
#[inline(always)]
fn closest<E: Emit>(e: E, shape: i32, x: E::Real, y: E::Real, radius: E::Real) -> E::Mask {
    let row = if shape == 1 { 0.5 } else { 0.866_025 };
    let rows = y / row;
    let odd = is_odd(rows);
    let up = within_tile(rows) * row;
    let across = within_tile(x + one_where(e, odd) * 0.5);
    let left = inside::<E>(shape, Place { x: across, y: up }, radius);
    let right = inside::<E>(shape, Place { x: e.real(1.0) - across, y: up }, radius);
    let above = Place { x: across - 0.5, y: e.real(row) - up };
    left | right | inside::<E>(shape, above, radius)
}

#[cfg(test)]
mod tests {
    fn inside(u: f32, v: f32, shape: i32, staggered: bool, size: f32) -> bool {
        number!(
            u = u, v = v, tiling = [1.0; 3], shape = shape, staggered = staggered, size = size
                => result
        ) == 1.0
    }

    #[test]
    fn a_tile_holds_one_figure() {
        for shape in 0..3 {
            assert!(inside(0.5, 0.5, shape, false, 0.5) && inside(-6.5, 3.5, shape, false, 0.5));
            assert!(inside(0.74, 0.5, shape, false, 0.5) && !inside(0.76, 0.5, shape, false, 0.5));
            assert!(!inside(0.0, 0.0, shape, false, 0.5));
        }
    }

    #[test]
    fn staggered_hexagons_leave_nothing_between_them() {
        for step in 0..400 {
            let (u, v) = ((step % 20) as f32 * 0.17, (step / 20) as f32 * 0.19 - 2.0);
            assert!(inside(u, v, 2, true, 1.0001), "{u} {v}");
        }
        assert!(inside(0.0, 0.0, 0, true, 0.5) && inside(0.5, 0.866, 0, true, 0.5));
        assert!(inside(0.0, 0.0, 1, true, 0.4) && inside(0.5, 0.5, 1, true, 0.4));
        assert!(!inside(0.5, 0.0, 1, true, 0.4));
    }
}
