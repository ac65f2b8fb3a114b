use std::f64::consts::PI;

use crate::emit::functions::facets::Facets;
use crate::emit::functions::frames::Frame;
use crate::emit::functions::reflected::shown;
use crate::emit::{Color, Mask, Real};
use crate::nodes::finite::UNIT;
use crate::nodes::fresnel::fresnel_schlick::schlick_color;
use crate::nodes::{NOT_NEGATIVE, node, state};
use crate::state::Field;

node! {
    /// Schlick's cheap reflectance of brushed surfaces: `Z A G(n·l) G(n·v) F / (4 pi (n·l) (n·v))`, with
    /// `Z = r / (1 + r t^2 - t^2)^2` of the half vector's cosine `t`, `A = sqrt(p / (p^2 - p^2 w^2 + w^2))` of the
    /// cosine `w` between tangent and half vector along the surface, `G(x) = x / (r - r x + x)` and Schlick's
    /// Fresnel term. `Z / pi` is the distribution of ellipsoids with alpha^2 = r: draw directions by
    /// `microfacet_sample` with `ellipsoid` and the square root of r.
    ///
    /// Reciprocal, but its albedo passes 1 at grazing angles (1.25 at 89 degrees for r = 0.1), and A does not
    /// average to 1 (0.97 for p = 0.5): see the tests. Z is `(r / d) / d` with `d = r cos^2 + sin^2`, the sine not
    /// had from the cosine. A is 1 where the half vector is the normal. Below 10^-12, r counts as that; below
    /// 10^-4, p does.
    schlick_anisotropic_brdf in brdf,
    source "Schlick 1994, An Inexpensive BRDF Model for Physically-based Rendering",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Direction along the surface that `isotropy` goes by, by default that of u; put at right
        /// angles to the normal. Any is taken where this is zero or along the normal.
        tangent: vector = node("frame_from_derivatives"), in -1.0..=1.0;
        /// Roughness r: 0 a mirror, 1 diffuse.
        roughness: scalar = 0.1, in UNIT;
        /// Isotropy p: 1 the same all round, less for brushed surfaces.
        isotropy: scalar = 1.0, in UNIT;
        /// Reflectance head on.
        f0: color = [0.9, 0.9, 0.9, 1.0], in UNIT;
    }
    outputs {
        /// The reflectance, per steradian; alpha is 1.
        value: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let frame = Frame::along(i.normal, i.tangent);
        let factor = factor(&facets, &frame, i.roughness, i.isotropy);
        let one = e.real(1.0);
        let fresnel = schlick_color(i.f0, Color { r: one, g: one, b: one, a: one }, facets.cosine_half());
        Outputs { value: shown(facets.above(), fresnel * factor) }
    }
}

/// The reflectance without Fresnel's term, where light and viewer are above the surface.
#[inline(always)]
pub fn factor<R: Real>(facets: &Facets<R>, frame: &Frame<R>, roughness: R, isotropy: R) -> R {
    let one = roughness.same(1.0);
    let r = roughness.clamp_to(roughness.same(1e-12), one);
    let p = isotropy.clamp_to(isotropy.same(1e-4), one);
    let slope_squared = facets.slope_squared();
    // d over cos^2, so that Z is r / d^2 / cos^4.
    let over = r + slope_squared;
    let secant_squared = slope_squared + 1.0;
    let zenith = r / over * secant_squared * (secant_squared / over);
    let (along, across) = (facets.sum.dot(frame.u), facets.sum.dot(frame.v));
    let (along, across) = (along * along, across * across);
    let azimuth = p * (along + across) / (p * p * across + along);
    let flat = (along + across).greater(one.same(0.0));
    let azimuth = flat.select(azimuth.sqrt(), one);
    let (light, viewer) = (facets.cosine_in, facets.cosine_out);
    let seen = r * (one - light) + light;
    let lit = r * (one - viewer) + viewer;
    zenith * azimuth * (1.0 / (4.0 * PI)) / seen / lit
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn isotropic_it_does_not_see_the_tangent_and_head_on_nothing_is_undefined() {
        let at = |tangent: [f32; 3], isotropy: f32, direction: [f32; 3]| number!(normal = UP, direction = direction, ray = DOWN, tangent = tangent, isotropy = isotropy, roughness = 0.1 => value);
        let slanted = [0.6, 0.0, 0.8];
        assert_eq!(at([1.0, 0.0, 0.0], 1.0, slanted), at([0.0, 1.0, 0.0], 1.0, slanted));
        assert!(at([1.0, 0.0, 0.0], 0.2, slanted) < at([0.0, 1.0, 0.0], 0.2, slanted));
        crate::nodes::harness::assert_close(
            &[at([0.0; 3], 0.3, UP)],
            &[0.9 / 0.1 / (4.0 * std::f64::consts::PI)],
            1e-6,
            0.0,
        );
    }
}
