use crate::emit::Real;
use crate::emit::functions::passage::mixed;
use crate::nodes::finite::SUMMAND;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Between four corners, linear in u and in v, and constant outside of 0 to 1, alpha too. A corner that
    /// does not show is not evaluated. MaterialX's `ramp4`.
    ramp4 in ramps generic,
    source "MaterialX 1.39, ramp4",
    inputs {
        /// Where to look: across.
        u: scalar = state(Field::U);
        /// Where to look: up.
        v: scalar = state(Field::V);
        /// Value at u = 0, v = 1.
        top_left: generic = 0.0, in SUMMAND,
            when i.u.saturate().less(e.real(1.0)) & i.v.saturate().greater(e.real(0.0));
        /// Value at u = 1, v = 1.
        top_right: generic = 0.0, in SUMMAND,
            when i.u.saturate().greater(e.real(0.0)) & i.v.saturate().greater(e.real(0.0));
        /// Value at u = 0, v = 0.
        bottom_left: generic = 0.0, in SUMMAND,
            when i.u.saturate().less(e.real(1.0)) & i.v.saturate().less(e.real(1.0));
        /// Value at u = 1, v = 0.
        bottom_right: generic = 0.0, in SUMMAND,
            when i.u.saturate().greater(e.real(0.0)) & i.v.saturate().less(e.real(1.0));
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| {
        let (u, v) = (i.u.saturate(), i.v.saturate());
        let top = mixed(i.top_left, i.top_right, u);
        let bottom = mixed(i.bottom_left, i.bottom_right, u);
        Outputs { result: mixed(bottom, top, v) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn corners_are_met_and_the_middle_is_their_mean() {
        let at = |u: f32, v: f32| {
            number!(
                u = u, v = v, top_left = 1.0, top_right = 2.0, bottom_left = 4.0, bottom_right = 8.0
                    => result
            )
        };
        let corners = [at(0.0, 1.0), at(1.0, 1.0), at(0.0, 0.0), at(1.0, 0.0)];
        assert_eq!(corners, [1.0, 2.0, 4.0, 8.0]);
        assert_eq!([at(0.5, 0.5), at(-5.0, 0.5), at(0.5, 7.0)], [3.75, 2.5, 1.5]);
    }

    #[test]
    fn a_corner_that_does_not_show_is_not_asked_for() {
        assert!(demanded!(u = 0.0, v = 0.0 => bottom_left));
        assert!(!demanded!(u = 0.0, v = 0.0 => bottom_right));
        assert!(!demanded!(u = 0.0, v = 0.0 => top_left));
        assert!(demanded!(u = 0.5, v = 0.5 => top_right));
    }
}
