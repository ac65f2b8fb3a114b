use crate::emit::functions::cells::{cell_share, numbered_share};
use crate::emit::functions::figures::{is_odd, within_tile};
use crate::emit::{Color, Emit, Mask, Real};
use crate::nodes::finite::{FACTOR, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Bricks in rows with mortar between them. `brick` is 1 on a brick, 0 in the mortar, and goes over
    /// smoothly within `bevel` of the brick's edge, which is also a height for bumps. Each brick has a random
    /// number and colour of its own, and places on it from 0 to 1. With a `shift` of 0 they are tiles.
    ///
    /// Lengths are in those of u and v. A brick takes `width` by `height`, half of the mortar on each side
    /// included.
    bricks in patterns,
    source "",
    inputs {
        /// Where to look: along the rows.
        u: scalar = state(Field::U), in FACTOR;
        /// Where to look: across the rows.
        v: scalar = state(Field::V), in FACTOR;
        /// Length of a brick, with its mortar.
        width: scalar = 0.25, in 1e-6..=1e6, soft 0.01..=1.0;
        /// Height of a row, with its mortar.
        height: scalar = 0.1, in 1e-6..=1e6, soft 0.01..=1.0;
        /// Width of the mortar.
        mortar: scalar = 0.015, in 0.0..=1e6, soft 0.0..=0.1;
        /// Width of the passage from mortar to brick, on the brick.
        bevel: scalar = 0.0, in 0.0..=1e6, soft 0.0..=0.1;
        /// What every other row is moved by, in bricks: 0 for tiles.
        shift: scalar = 0.5, in FACTOR, unit "bricks", soft UNIT;
        /// Another seed gives other numbers and colours.
        seed: integer = 0;
    }
    outputs {
        /// 1 on bricks, 0 in the mortar.
        brick: scalar, in 0.0..=1.0;
        /// A random number of the brick, 0 to 1.
        id: scalar, in 0.0..=1.0;
        /// A random colour of the brick.
        color: color, in 0.0..=1.0;
        /// Place on the brick along the row, 0 to 1.
        u: scalar, in 0.0..=1.0;
        /// Place on the brick across the row, 0 to 1.
        v: scalar, in 0.0..=1.0;
        /// Which row: a whole number.
        row: scalar;
        /// Which brick of the row: a whole number.
        column: scalar;
    }
    body |e, i| {
        let up = i.v / i.height;
        let row = up.floor();
        let along = i.u / i.width - is_odd(row).select(i.shift, e.real(0.0));
        let column = along.floor();
        let (u, v) = (within_tile(along), within_tile(up));
        let half = e.real(0.5);
        // Lengths from the nearer side, without the mortar.
        let side = (half - (u - 0.5).absolute()) * i.width;
        let end = (half - (v - 0.5).absolute()) * i.height;
        let inside = side.minimum(end) - i.mortar * 0.5;
        let cell = [column.to_int(), row.to_int(), i.seed];
        let color = Color {
            r: numbered_share(cell, 0),
            g: numbered_share(cell, 1),
            b: numbered_share(cell, 2),
            a: e.real(1.0),
        };
        Outputs { brick: raised(e, inside, i.bevel), id: cell_share(cell), color, u, v, row, column }
    }
}

/// 0 below the edge, 1 from `bevel` on, smooth between.
#[inline(always)]
fn raised<E: Emit>(e: E, inside: E::Real, bevel: E::Real) -> E::Real {
    let (zero, one) = (e.real(0.0), e.real(1.0));
    let share = inside.divide_or_zero(bevel).saturate();
    let smooth = share * share * (e.real(3.0) - share * 2.0);
    let sharp = inside.less(zero).select(zero, one);
    bevel.greater(zero).select(smooth, sharp)
}

#[cfg(test)]
mod tests {
    fn brick(u: f32, v: f32) -> f32 {
        number!(u = u, v = v, width = 1.0, height = 0.5, mortar = 0.125 => brick)
    }

    #[test]
    fn mortar_goes_round_and_every_other_row_is_moved() {
        assert_eq!([brick(0.5, 0.25), brick(0.0, 0.25), brick(0.5, 0.0)], [1.0, 0.0, 0.0]);
        assert_eq!([brick(0.0625, 0.25), brick(0.0624, 0.25)], [1.0, 0.0]);
        assert_eq!([brick(0.0, 0.75), brick(0.5, 0.75), brick(-0.5, -0.25)], [1.0, 0.0, 0.0]);
    }

    #[test]
    fn a_bevel_goes_over_smoothly() {
        let at = |u: f32| number!(u = u, v = 0.5, width = 1.0, height = 1.0, mortar = 0.0, bevel = 0.25 => brick);
        assert_eq!([at(0.0), at(0.125), at(0.25), at(0.5)], [0.0, 0.5, 1.0, 1.0]);
    }

    #[test]
    fn a_brick_has_one_number_and_the_next_another() {
        let id = |u: f32, v: f32, seed: i32| number!(u = u, v = v, width = 1.0, height = 0.5, seed = seed => id);
        assert_eq!(id(0.01, 0.01, 0), id(0.99, 0.49, 0));
        assert!(id(0.5, 0.25, 0) != id(1.5, 0.25, 0) && id(0.5, 0.25, 0) != id(0.5, 0.25, 1));
        assert_eq!(id(0.51, 0.75, 0), id(1.49, 0.51, 0));
        let place = |u: f32| number!(u = u, v = 0.25, width = 0.5, height = 0.5 => u);
        assert_eq!([place(0.75), place(-0.125)], [0.5, 0.75]);
        assert_eq!(number!(u = 3.2, v = -0.1, width = 1.0, height = 0.5 => row), -1.0);
        assert_eq!(number!(u = 3.2, v = -0.1, width = 1.0, height = 0.5 => column), 2.0);
    }
}
