use crate::emit::functions::cells::{cell_share, numbered_share};
use crate::emit::functions::gradient_noise::cell_of;
use crate::emit::{Color, Int, Vector};
use crate::nodes::finite::FACTOR;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// One random number, 0 to 1, for each cell of the lattice of whole numbers, and three more: the same
    /// throughout the cell. Those of MaterialX's `cellnoise2d` and `cellnoise3d` and of OSL's
    /// `cellnoise`.
    ///
    /// Trap: a position that ought to be whole and is a little less belongs to the cell before. Add a half
    /// to numbers of things.
    cell_noise in noise,
    source "Jenkins 2006, lookup3; Gritz et al. 2010, Open Shading Language",
    inputs {
        /// Where to look; the first `dimensions` coordinates count.
        position: vector = state(Field::Point), in FACTOR;
        /// How many coordinates count: 2 for uv; the fourth is `w`.
        dimensions: count = 3, in 1.0..=4.0;
        /// The fourth coordinate, often a seed.
        w: scalar = 0.0, in FACTOR, when e.mask(i.dimensions == 4);
    }
    outputs {
        /// The number of the cell.
        result: scalar, in 0.0..=1.0;
        /// Three others.
        vector: vector, in 0.0..=1.0;
        /// The same three as a colour.
        color: color, in 0.0..=1.0;
    }
    body |e, i| {
        let Vector { x, y, z } = i.position;
        let (x, y, z) = (cell_of(x).0, cell_of(y).0, cell_of(z).0);
        let [result, r, g, b] = match i.dimensions {
            1 => numbers([x]),
            2 => numbers([x, y]),
            3 => numbers([x, y, z]),
            _ => numbers([x, y, z, cell_of(i.w).0]),
        };
        let vector = Vector { x: r, y: g, z: b };
        Outputs { result, vector, color: Color { r, g, b, a: e.real(1.0) } }
    }
}

/// The number of a cell, and three more.
#[inline(always)]
fn numbers<I: Int, const D: usize>(cell: [I; D]) -> [I::Real; 4] {
    let first = cell_share(cell);
    [first, numbered_share(cell, 0), numbered_share(cell, 1), numbered_share(cell, 2)]
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_cell_has_one_number_and_its_neighbours_others() {
        for dimensions in 1..=4 {
            let at = |x: f32| numbers!(position = [x, -3.5, 2.25], dimensions = dimensions, w = 0.5 => color);
            assert_eq!(at(-2.0), at((-1.0_f32).next_down()));
            assert!(at(-2.0) != at(-1.0) && at(-2.0) != at((-2.0_f32).next_down()));
            assert_eq!(at(-0.0), at(1e-45));
            assert_eq!(at(1e6), at(1_000_000.9));
        }
    }

    #[test]
    fn numbers_are_spread_evenly_and_apart() {
        let mut tenths = [0; 10];
        for x in 0..2000 {
            let value = number!(position = [x as f32, 0.0, 0.0], dimensions = 2 => result);
            tenths[(value * 10.0).min(9.0) as usize] += 1;
        }
        // A binomial count of 200 is within five deviations of 13.4.
        assert!(tenths.iter().all(|count| (133..267).contains(count)), "{tenths:?}");
    }

    #[test]
    fn beyond_the_integers_it_is_the_last_cell() {
        let at = |x: f32| number!(position = [x, 0.0, 0.0] => result);
        assert_eq!(at(1e10), at(1e19));
        assert_eq!(at(-1e10), at(-1e19));
        assert!(at(1e9) != at(1e10));
    }
}
