use crate::emit::functions::cells::{cell_share, numbered_share};
use crate::emit::functions::figures::{Place, hexagon_distance};
use crate::emit::{Color, Mask, Real};
use crate::nodes::finite::FACTOR;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Hexagons that fill the plane, two of their sides upright. `edge` is the distance to the nearest
    /// side, 0 on it and a half in the middle: less than the width of a joint is joint. Each hexagon has a random
    /// number and colour of its own.
    ///
    /// Their middles are two lattices of 1 by the square root of 3, one moved by half of both; the nearer of
    /// the two nearest middles is the hexagon's.
    hexagon_tiles in patterns,
    source "",
    inputs {
        /// Where to look: across.
        u: scalar = state(Field::U), in FACTOR;
        /// Where to look: up.
        v: scalar = state(Field::V), in FACTOR;
        /// Hexagons per unit, side by side.
        frequency: scalar = 8.0, in FACTOR, unit "hexagons per unit", soft 0.0..=100.0;
        /// Another seed gives other numbers and colours.
        seed: integer = 0;
    }
    outputs {
        /// Distance to the nearest side, in hexagons: 0 to a half.
        edge: scalar, in 0.0..=0.5;
        /// A random number of the hexagon, 0 to 1.
        id: scalar, in 0.0..=1.0;
        /// A random colour of the hexagon.
        color: color, in 0.0..=1.0;
        /// Place on the hexagon across, from its middle.
        u: scalar, in -1.0..=1.0;
        /// Place on the hexagon up, from its middle.
        v: scalar, in -1.0..=1.0;
    }
    body |e, i| {
        let (x, y) = (i.u * i.frequency, i.v * i.frequency / ROWS);
        let (even_x, even_y) = (x.round_even(), y.round_even());
        let (odd_x, odd_y) = (x.floor() + 0.5, y.floor() + 0.5);
        let even = Place { x: clamped(x - even_x), y: clamped(y - even_y) * ROWS };
        let odd = Place { x: clamped(x - odd_x), y: clamped(y - odd_y) * ROWS };
        let (to_even, to_odd) =
            (even.x.mul_add(even.x, even.y * even.y), odd.x.mul_add(odd.x, odd.y * odd.y));
        let first = to_even.less(to_odd);
        let at = Place { x: first.select(even.x, odd.x), y: first.select(even.y, odd.y) };
        // Twice the middles are whole, and of one parity.
        let across = (first.select(even_x, odd_x) * 2.0).to_int();
        let up = (first.select(even_y, odd_y) * 2.0).to_int();
        let cell = [across, up, i.seed];
        let color = Color {
            r: numbered_share(cell, 0),
            g: numbered_share(cell, 1),
            b: numbered_share(cell, 2),
            a: e.real(1.0),
        };
        let edge = (e.real(0.5) - hexagon_distance(at)).clamp_to(e.real(0.0), e.real(0.5));
        Outputs { edge, id: cell_share(cell), color, u: at.x, v: at.y }
    }
}

/// Distance between rows of one lattice, the square root of 3.
const ROWS: f64 = 1.732_050_8;

/// Within half a unit: more is rounding far from the origin.
#[inline(always)]
fn clamped<R: Real>(x: R) -> R {
    x.clamp_to(x.same(-0.5), x.same(0.5))
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    fn at(u: f32, v: f32) -> (f32, f32) {
        let edge = number!(u = u, v = v, frequency = 1.0 => edge);
        (edge, number!(u = u, v = v, frequency = 1.0 => id))
    }

    #[test]
    fn middles_and_sides_are_where_they_should_be() {
        for (u, v, edge) in [
            (0.0, 0.0, 0.5),
            (0.5, 0.0, 0.0),
            (0.25, 0.0, 0.25),
            (0.5, 0.866_025_4, 0.5),
            (-1.5, -0.866_025_4, 0.5),
            (0.0, 0.577_350_3, 0.0),
            (0.0, 0.288, 0.250_584),
        ] {
            assert_close(&[at(u, v).0], &[edge], 1e-5, 1e-6);
        }
    }

    #[test]
    fn a_hexagon_has_one_number_and_its_neighbours_others() {
        let middle = at(3.0, 0.0).1;
        for turn in 0..12 {
            let (sin, cos) = (turn as f32 * 0.52).sin_cos();
            assert_eq!(at(3.0 + 0.45 * cos, 0.45 * sin).1, middle);
            assert!(at(3.0 + 0.75 * cos, 0.75 * sin).1 != middle);
        }
    }
}
