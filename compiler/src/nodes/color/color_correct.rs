use crate::emit::functions::colors::{from_hsv, luminance, to_hsv};
use crate::emit::functions::conventions::clamp_finite;
use crate::emit::functions::shaping::signed_power;
use crate::emit::{Color, Emit, Mask, Real};
use crate::nodes::WHITE;
use crate::nodes::finite::FACTOR;

node! {
    /// A colour through the steps of a grading desk, in this order: hue is turned, saturation
    /// scaled, then per component gamma (as in `gamma`), lift `x (1 - lift) + lift`, gain,
    /// contrast about a pivot, and exposure in stops. Neutral by default. MaterialX's
    /// colorcorrect has these steps too, with the luminance weights of ACEScg in the
    /// saturation. A colour keeps its alpha.
    color_correct in color,
    source "",
    inputs {
        /// The colour.
        color: color = WHITE, in -1e6..=1e6;
        /// Turns that are added to the hue.
        hue: scalar = 0.0, in FACTOR, unit "turns", soft -0.5..=0.5;
        /// 0 is grey, 1 changes nothing.
        saturation: scalar = 1.0, in -1e3..=1e3, soft 0.0..=2.0;
        /// Above 1 brightens the middle.
        gamma: scalar = 1.0, avoid zero, soft 0.2..=5.0;
        /// What black becomes.
        lift: scalar = 0.0, in -1e3..=1e3, soft -0.5..=0.5;
        /// Factor.
        gain: scalar = 1.0, in -1e3..=1e3, soft 0.0..=2.0;
        /// Factor on the distance from the pivot.
        contrast: scalar = 1.0, in -1e3..=1e3, soft 0.0..=2.0;
        /// The value that contrast leaves alone.
        pivot: scalar = 0.5, in -1e3..=1e3, soft 0.0..=1.0;
        /// Stops: one more is twice the light.
        exposure: scalar = 0.0, unit "stops", soft -5.0..=5.0;
    }
    outputs {
        /// The colour.
        color: color;
    }
    body |e, i| {
        let [hue, pure, value] = to_hsv(i.color);
        let turned = from_hsv([hue + i.hue, pure, value], i.color.a);
        let turned = i.hue.equal(e.real(0.0)).select(i.color, turned);
        let grey = luminance(turned);
        let color = Color {
            r: corrected(e, i, (turned.r - grey).mul_add(i.saturation, grey)),
            g: corrected(e, i, (turned.g - grey).mul_add(i.saturation, grey)),
            b: corrected(e, i, (turned.b - grey).mul_add(i.saturation, grey)),
            a: i.color.a,
        };
        Outputs { color }
    }
}

/// A component through the steps that take each alone.
#[inline(always)]
fn corrected<E: Emit>(e: E, i: &Inputs<E>, x: E::Real) -> E::Real {
    let one = e.real(1.0);
    let bent = signed_power(x, one.divide_or_zero(i.gamma));
    let lifted = bent.mul_add(one - i.lift, i.lift);
    let contrasted = (lifted * i.gain - i.pivot).mul_add(i.contrast, i.pivot);
    clamp_finite(clamp_finite(contrasted) * i.exposure.exp2())
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_neutral_by_default() {
        let color = [0.8, 0.25, 3.0, 0.5];
        crate::nodes::harness::assert_close(
            &numbers!(color = color => color),
            &[0.8, 0.25, 3.0, 0.5],
            3e-7,
            0.0,
        );
    }

    #[test]
    fn the_steps_stand_in_order() {
        let grey = [0.25, 0.25, 0.25, 1.0];
        let graded = numbers!(
            color = grey, gamma = 2.0, lift = 0.5, gain = 2.0, contrast = 3.0, pivot = 1.0, exposure = 1.0 => color
        );
        // Gamma 0.5, lift 0.75, gain 1.5, contrast 2.5, exposure 5.
        crate::nodes::harness::assert_close(&graded, &[5.0, 5.0, 5.0, 1.0], 1e-6, 0.0);
    }

    #[test]
    fn hues_turn() {
        let red = numbers!(color = [1.0, 0.0, 0.0, 1.0], hue = 1.0_f32 / 3.0 => color);
        crate::nodes::harness::assert_close(&red, &[0.0, 1.0, 0.0, 1.0], 1e-6, 1e-6);
    }
}
