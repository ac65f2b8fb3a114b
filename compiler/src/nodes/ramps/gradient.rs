use crate::emit::functions::conventions::atan2_or_zero;
use crate::emit::{Emit, Real};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// A number that changes over u and v, for a `ramp` to colour: u itself; once round the middle
    /// (0.5, 0.5), from below clockwise; the distance from the middle, 1 in the corners (in round figures:
    /// 1.414 times it, as MaterialX has it); the distance of the square through the place, 1 on the edge.
    /// These are the four types of MaterialX's `ramp`.
    gradient in ramps,
    source "MaterialX 1.39, ramp",
    inputs {
        /// Where to look: across.
        u: scalar = state(Field::U), in -1e18..=1e18;
        /// Where to look: up.
        v: scalar = state(Field::V), in -1e18..=1e18;
        /// How it changes.
        shape: choice = 0, of ["linear", "radial", "circular", "box"];
    }
    outputs {
        /// The number; between 0 and 1 where u and v are.
        result: scalar;
    }
    body |e, i| Outputs { result: number(e, i) }
}

#[inline(always)]
fn number<E: Emit>(e: E, i: &Inputs<E>) -> E::Real {
    let (x, y) = (i.u - 0.5, i.v - 0.5);
    match i.shape {
        0 => i.u,
        1 => atan2_or_zero(x, y).mul_add(e.real(1.0 / std::f64::consts::TAU), e.real(0.5)),
        2 => {
            let (x, y) = (x * 1.414, y * 1.414);
            x.mul_add(x, y * y).sqrt()
        }
        _ => x.absolute().maximum(y.absolute()) * 2.0,
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn each_shape_where_it_is_known() {
        for (shape, u, v, expected) in [
            (0, 0.3, 9.0, 0.3),
            (1, 0.5, 1.0, 0.5),
            (1, 1.0, 0.5, 0.75),
            (1, 0.0, 0.5, 0.25),
            (1, 0.5, 0.5, 0.5),
            (2, 0.5, 0.5, 0.0),
            (2, 1.0, 1.0, 0.999849),
            (3, 0.5, 0.25, 0.5),
            (3, 1.0, 0.9, 1.0),
        ] {
            let found = numbers!(u = u, v = v, shape = shape => result);
            assert_close(&found, &[expected], 1e-6, 1e-6);
        }
    }
}
