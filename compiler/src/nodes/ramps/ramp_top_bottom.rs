use crate::emit::Real;
use crate::emit::functions::passage::mixed;
use crate::nodes::finite::SUMMAND;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// From `bottom` at v = 0 to `top` at v = 1, and those values outside, alpha too. An end that does not
    /// show is not evaluated, and the other passes unchanged. MaterialX's `ramptb`.
    ramp_top_bottom in ramps generic,
    source "MaterialX 1.39, ramptb",
    inputs {
        /// Where to look.
        v: scalar = state(Field::V);
        /// Value at v = 0.
        bottom: generic = 0.0, in SUMMAND, when i.v.saturate().less(e.real(1.0));
        /// Value at v = 1.
        top: generic = 1.0, in SUMMAND, when i.v.saturate().greater(e.real(0.0));
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| Outputs { result: mixed(i.bottom, i.top, i.v.saturate()) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn it_goes_from_end_to_end_and_stays_there() {
        let (bottom, top) = ([1.0, 2.0, -4.0, 0.0], [3.0, 2.0, 4.0, 1.0]);
        let at = |u: f32| numbers!(v = u, bottom = bottom, top = top => result);
        assert_eq!(at(0.25), [1.5, 2.0, -2.0, 0.25]);
        assert_eq!([at(-3.0), at(0.0), at(1.0), at(1e9)], [bottom, bottom, top, top]);
        for (u, of_bottom, of_top) in [(0.0, true, false), (1.0, false, true), (0.5, true, true)] {
            assert_eq!((demanded!(v = u => bottom), demanded!(v = u => top)), (of_bottom, of_top));
        }
    }
}
