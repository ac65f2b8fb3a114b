use crate::emit::functions::figures::is_odd;
use crate::emit::{Emit, Mask};
use crate::nodes::finite::{FACTOR, SUMMAND, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// A checkerboard over u and v: `odd` where `floor(u tiling.x - offset.x) + floor(v tiling.y - offset.y)`
    /// is odd, else `even`. Only the value that is due is evaluated. MaterialX's `checkerboard` has the
    /// same squares, `color1` being `odd`.
    checker in patterns generic,
    source "MaterialX 1.39, checkerboard",
    inputs {
        /// Where to look: across.
        u: scalar = state(Field::U), in FACTOR;
        /// Where to look: up.
        v: scalar = state(Field::V), in FACTOR;
        /// Squares per unit; x and y count.
        tiling: vector = [8.0, 8.0, 8.0], in FACTOR, soft 0.0..=100.0;
        /// What the board is moved by, in squares; x and y count.
        offset: vector = [0.0; 3], in FACTOR, unit "squares", soft UNIT;
        /// Value of even squares, the one at the origin among them.
        even: generic = 0.0, in SUMMAND, when !odd(e, i);
        /// Value of odd squares.
        odd: generic = 1.0, in SUMMAND, when odd(e, i);
    }
    outputs {
        /// The value of the square.
        result: generic;
    }
    body |e, i| Outputs { result: odd(e, i).select(i.odd, i.even) }
}

#[inline(always)]
fn odd<E: Emit, T: Copy>(_: E, i: &Inputs<E, T>) -> E::Mask {
    is_odd(i.u * i.tiling.x - i.offset.x) ^ is_odd(i.v * i.tiling.y - i.offset.y)
}

#[cfg(test)]
mod tests {
    fn at(u: f32, v: f32) -> f32 {
        number!(u = u, v = v, tiling = [2.0, 4.0, 0.0] => result)
    }

    #[test]
    fn squares_alternate_on_both_sides_of_the_origin() {
        assert_eq!([at(0.1, 0.1), at(0.6, 0.1), at(0.1, 0.3), at(0.6, 0.3)], [0.0, 1.0, 1.0, 0.0]);
        assert_eq!([at(-0.1, 0.1), at(-0.1, -0.1), at(-0.6, 0.1)], [1.0, 0.0, 0.0]);
        assert_eq!([at(0.5, 0.0), at(0.5_f32.next_down(), 0.0)], [1.0, 0.0]);
        assert_eq!([at(3e7, 0.1), at(-1e18, 1e19)], [0.0, 0.0]);
    }

    #[test]
    fn values_pass_to_the_bit_and_the_other_is_not_asked_for() {
        let (even, odd) = ([0.1, -0.0, 3.0, 0.5], [f32::NAN, 1.0, 2.0, 0.25]);
        assert_eq!(numbers!(u = 0.0, v = 0.0, even = even, odd = odd => result), even);
        assert!(demanded!(u = 0.0, v = 0.0 => even) && !demanded!(u = 0.0, v = 0.0 => odd));
        assert!(demanded!(u = 0.2, v = 0.0 => odd) && !demanded!(u = 0.2, v = 0.0 => even));
    }

    #[test]
    fn the_offset_is_in_squares() {
        let moved = number!(u = 0.1, v = 0.1, offset = [1.0, 0.0, 0.0] => result);
        assert_eq!(moved, 1.0);
    }
}
