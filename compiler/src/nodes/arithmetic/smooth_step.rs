use crate::emit::Real;
use crate::emit::functions::shaping::passage;
use crate::nodes::finite::{SUMMAND, UNIT};

node! {
    /// Smooth passage from 0 at `low` to 1 at `high`, per component: `t t (3 - 2 t)` with
    /// `t = (input - low) / (high - low)` clamped to 0..1. Equal bounds make a step: 1 from the bound
    /// on. With `low` above `high` it falls. A colour keeps its alpha.
    smooth_step in arithmetic per component,
    source "RenderMan Interface Specification, smoothstep",
    inputs {
        /// Where to look.
        input: generic = 0.0, in SUMMAND;
        /// Where it is 0.
        low: scalar = 0.0, in SUMMAND;
        /// Where it is 1.
        high: scalar = 1.0, in SUMMAND;
    }
    outputs {
        /// The height of the curve.
        result: generic, in UNIT;
    }
    body |e, i| {
        let t = passage(i.input, i.low, i.high);
        t * t * (t.mul_add(e.real(-2.0), e.real(3.0)))
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn passes_through_its_three_points() {
        assert_eq!(numbers!(input = [-1.0, 0.5, 3.0] => result), [0.0, 0.5, 1.0]);
        assert_eq!(number!(input = 3.0, low = 4.0, high = 2.0 => result), 0.5);
        assert_eq!(number!(input = 5.0, low = 4.0, high = 2.0 => result), 0.0);
        assert_eq!(number!(input = 0.25 => result), 0.15625);
    }

    #[test]
    fn equal_bounds_make_a_step() {
        for (input, height) in [(2.0_f32.next_down(), 0.0), (2.0, 1.0), (2.0_f32.next_up(), 1.0)] {
            assert_eq!(number!(input = input, low = 2.0, high = 2.0 => result), height);
        }
    }
}
