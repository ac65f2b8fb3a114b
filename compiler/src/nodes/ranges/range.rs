use crate::emit::functions::conventions::clamp_finite;
use crate::emit::functions::shaping::signed_power;
use crate::emit::{Mask, Real};
use crate::nodes::finite::SUMMAND;

node! {
    /// `remap` with a gamma between: of the share t of the first range it takes `sign(t) |t|^(1
    /// / gamma)`, per component. `clamped`, the share is clamped to 0..1 first. MaterialX
    /// clamps the result, which differs where `out_low` is above `out_high`: there it gives
    /// `out_high` everywhere. A colour keeps its alpha.
    range in ranges per component,
    source "MaterialX 1.39, range",
    inputs {
        /// Where to look.
        input: generic = 0.0, in SUMMAND;
        /// Where it is `out_low`.
        in_low: generic = 0.0, in SUMMAND;
        /// Where it is `out_high`.
        in_high: generic = 1.0, in SUMMAND;
        /// Above 1 lifts the middle; 0 counts as infinite.
        gamma: generic = 1.0, avoid zero;
        /// The value there.
        out_low: generic = 0.0, in SUMMAND;
        /// The value there.
        out_high: generic = 1.0, in SUMMAND;
        /// Whether it stays between `out_low` and `out_high`.
        clamped: boolean = false;
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| {
        let share = (i.input - i.in_low).divide_or_zero(i.in_high - i.in_low);
        let share = i.clamped.select(share.saturate(), share);
        let bent = signed_power(share, e.real(1.0).divide_or_zero(i.gamma));
        clamp_finite(bent.mul_add(i.out_high - i.out_low, i.out_low))
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn bends_the_share() {
        let at = |x: f32, clamped: bool| number!(input = x, in_high = 4.0, gamma = 2.0, out_high = 10.0, clamped = clamped => result);
        assert_eq!([at(1.0, false), at(16.0, false), at(-1.0, false)], [5.0, 20.0, -5.0]);
        assert_eq!([at(1.0, true), at(16.0, true), at(-1.0, true)], [5.0, 10.0, 0.0]);
    }
}
