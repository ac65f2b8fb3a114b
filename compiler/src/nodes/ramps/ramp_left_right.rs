use crate::emit::Real;
use crate::emit::functions::passage::mixed;
use crate::nodes::finite::SUMMAND;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// From `left` at u = 0 to `right` at u = 1, and those values outside, alpha too. An end that does not
    /// show is not evaluated, and the other passes unchanged. MaterialX's `ramplr`.
    ramp_left_right in ramps generic,
    source "MaterialX 1.39, ramplr",
    inputs {
        /// Where to look.
        u: scalar = state(Field::U);
        /// Value at u = 0.
        left: generic = 0.0, in SUMMAND, when i.u.saturate().less(e.real(1.0));
        /// Value at u = 1.
        right: generic = 1.0, in SUMMAND, when i.u.saturate().greater(e.real(0.0));
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| Outputs { result: mixed(i.left, i.right, i.u.saturate()) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn it_goes_from_end_to_end_and_stays_there() {
        let (left, right) = ([1.0, 2.0, -4.0, 0.0], [3.0, 2.0, 4.0, 1.0]);
        let at = |u: f32| numbers!(u = u, left = left, right = right => result);
        assert_eq!(at(0.25), [1.5, 2.0, -2.0, 0.25]);
        assert_eq!([at(-3.0), at(0.0), at(1.0), at(1e9)], [left, left, right, right]);
        for (u, of_left, of_right) in [(0.0, true, false), (1.0, false, true), (0.5, true, true)] {
            assert_eq!((demanded!(u = u => left), demanded!(u = u => right)), (of_left, of_right));
        }
    }
}
