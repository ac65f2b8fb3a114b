use crate::emit::Real;
use crate::emit::functions::shaping::passage;
use crate::nodes::finite::{SUMMAND, UNIT};

node! {
    /// Passage from 0 at `low` to 1 at `high` whose first two derivatives vanish at both ends,
    /// per component: `t^3 (t (6 t - 15) + 10)` of the clamped share t. Equal bounds make a
    /// step. With `low` above `high` it falls. A colour keeps its alpha.
    smoother_step in ranges per component,
    source "Perlin 2002, Improving Noise",
    inputs {
        /// Where to look.
        input: generic = 0.0, in SUMMAND;
        /// Where it is 0.
        low: generic = 0.0, in SUMMAND;
        /// Where it is 1.
        high: generic = 1.0, in SUMMAND;
    }
    outputs {
        /// The height of the curve.
        result: generic, in UNIT;
    }
    body |e, i| {
        let t = passage(i.input, i.low, i.high);
        let inner = t.mul_add(t.mul_add(e.real(6.0), e.real(-15.0)), e.real(10.0));
        (t * t * t * inner).saturate()
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_the_quintic() {
        for (x, height) in [(0.0, 0.0), (0.5, 0.5), (1.0, 1.0), (0.25, 0.103_515_625), (7.0, 1.0)] {
            assert_eq!(number!(input = x => result), height);
        }
    }
}
