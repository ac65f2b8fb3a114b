use crate::emit::functions::conventions::pow_or_zero;
use crate::emit::{Mask, Real};
use crate::nodes::NOT_NEGATIVE;
use crate::nodes::finite::UNIT;

node! {
    /// Share of light left after a way through a medium, per component: `color^distance`, `color` being what is
    /// left after one scene unit, clamped to 0..1 (Beer's law, as mental ray's `dielectric_material` has it).
    /// Nothing absorbs over no distance, black included: 0^0 is 1. Where the ray hit nothing the way is
    /// infinite: white passes, all else is absorbed; traces give distance 0 there, so connect their `hit`.
    beer_absorption in fresnel per component,
    source "Beer 1852; mental ray physics shaders, dielectric_material",
    inputs {
        /// What is left after one scene unit.
        color: generic = 0.9, in UNIT;
        /// Length of the way; below 0 counts as 0.
        distance: scalar = 0.0, in NOT_NEGATIVE, unit "scene units";
        /// Whether the way ends: the `hit` of a trace.
        hit: boolean = true;
    }
    outputs {
        /// Share left.
        transmittance: generic, in UNIT;
    }
    body |e, i| {
        let (zero, one) = (e.real(0.0), e.real(1.0));
        let left = i.color.saturate();
        let ended = pow_or_zero(left, i.distance.maximum(zero));
        let endless = left.equal(one).select(one, zero);
        i.hit.select(ended, endless)
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    fn at(color: f32, distance: f32) -> f32 {
        number!(color = color, distance = distance => transmittance)
    }

    #[test]
    fn falls_geometrically() {
        assert_close(&[at(0.5, 3.0), at(0.9, 0.5)], &[0.125, 0.9_f64.sqrt()], 2e-7, 0.0);
        let color = numbers!(color = [1.0, 0.5, 0.0, 0.7], distance = 2.0 => transmittance);
        assert_close(&color, &[1.0, 0.25, 0.0, 0.7], 1e-7, 0.0);
    }

    #[test]
    fn the_ends_are_defined() {
        assert_eq!([at(0.0, 0.0), at(0.3, 0.0), at(2.0, 5.0), at(0.3, -1.0)], [1.0; 4]);
        assert_eq!([at(0.0, 1e-45), at(0.3, 1e30), at(-1.0, 1.0)], [0.0; 3]);
        assert_eq!([at(1.0, f32::INFINITY), at(0.3, f32::INFINITY)], [1.0, 0.0]);
        let endless =
            |color: f32| number!(color = color, distance = 0.0, hit = false => transmittance);
        assert_eq!([endless(0.0), endless(0.999), endless(1.0)], [0.0, 0.0, 1.0]);
    }
}
