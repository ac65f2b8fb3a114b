use crate::emit::functions::figures::is_odd;
use crate::emit::{Emit, Mask};
use crate::nodes::finite::{FACTOR, SUMMAND, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// A board of cubes in space: `odd` where the sum of `floor(position tiling - offset)` over the
    /// coordinates is odd, else `even`. Only the value that is due is evaluated.
    ///
    /// Trap: a surface in a plane between cubes flickers from one to the other; move the board by half a
    /// cube. Blender adds 10^-6 instead.
    checker_3d in patterns generic,
    source "",
    inputs {
        /// Where to look.
        position: vector = state(Field::Point), in FACTOR;
        /// Cubes per unit.
        tiling: vector = [1.0; 3], in FACTOR, soft 0.0..=100.0;
        /// What the board is moved by, in cubes.
        offset: vector = [0.0; 3], in FACTOR, unit "cubes", soft UNIT;
        /// Value of even cubes, the one at the origin among them.
        even: generic = 0.0, in SUMMAND, when !odd(e, i);
        /// Value of odd cubes.
        odd: generic = 1.0, in SUMMAND, when odd(e, i);
    }
    outputs {
        /// The value of the cube.
        result: generic;
    }
    body |e, i| Outputs { result: odd(e, i).select(i.odd, i.even) }
}

#[inline(always)]
fn odd<E: Emit, T: Copy>(_: E, i: &Inputs<E, T>) -> E::Mask {
    let at = i.position * i.tiling - i.offset;
    is_odd(at.x) ^ is_odd(at.y) ^ is_odd(at.z)
}

#[cfg(test)]
mod tests {
    #[test]
    fn cubes_alternate_along_every_axis() {
        let at = |position: [f32; 3]| number!(position = position => result);
        assert_eq!(at([0.5, 0.5, 0.5]), 0.0);
        for axis in 0..3 {
            for to in [1.5, -0.5] {
                let mut beside = [0.5; 3];
                beside[axis] = to;
                assert_eq!(at(beside), 1.0, "{beside:?}");
            }
        }
        assert_eq!(at([1.5, 1.5, 0.5]), 0.0);
        assert_eq!(at([1.5, 1.5, 1.5]), 1.0);
        assert_eq!(at([1e19, -1e19, 1e9]), 0.0);
    }
}
