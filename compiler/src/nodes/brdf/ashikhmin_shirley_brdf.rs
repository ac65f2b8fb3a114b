use std::f64::consts::PI;

use crate::emit::functions::facets::Facets;
use crate::emit::functions::frames::Frame;
use crate::emit::functions::reflected::{grey, shown};
use crate::emit::{Color, Components, Real};
use crate::nodes::finite::UNIT;
use crate::nodes::fresnel::fresnel_schlick::schlick_color;
use crate::nodes::{NOT_NEGATIVE, node, state};
use crate::state::Field;

node! {
    /// Reflectance of a brushed, clear coat on a diffuse ground. The coat's is
    /// `sqrt((a + 1) (b + 1)) / (8 pi) (n·h)^e F / ((h·l) max(n·l, n·v))` with
    /// `e = (a (h·u)^2 + b (h·v)^2) / (1 - (h·n)^2)` and Schlick's Fresnel term of `specular`; the ground's
    /// `28 / (23 pi) diffuse (1 - specular) (1 - (1 - n·l / 2)^5) (1 - (1 - n·v / 2)^5)`. Draw directions by
    /// `ashikhmin_shirley_sample` and `lambert_sample`. Reciprocal, and at most all light is reflected
    /// (measured: 0.926).
    ///
    /// As printed the exponent is 0 / 0 at every mirror pair. Here the power is `exp(-e log1p(tan^2) / 2)` of the
    /// half vector's tangent, and e is that of its direction along the surface. The ground's factors are
    /// `x (5 - 10 x + 10 x^2 - 5 x^3 + x^4)`, x being half the cosine, accurate at grazing angles too.
    ashikhmin_shirley_brdf in brdf,
    source "Ashikhmin and Shirley 2000, An Anisotropic Phong BRDF Model",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Direction along the surface that `exponent_u` goes by, by default that of u; put at right
        /// angles to the normal. Any is taken where this is zero or along the normal.
        tangent: vector = node("frame_from_derivatives"), in -1.0..=1.0;
        /// How narrow the lobe is along the tangent.
        exponent_u: scalar = 10.0, in 0.0..=1e8, soft 1.0..=1e4;
        /// How narrow it is across.
        exponent_v: scalar = 100.0, in 0.0..=1e8, soft 1.0..=1e4;
        /// Reflectance of the coat head on.
        specular: color = [0.04, 0.04, 0.04, 1.0], in UNIT;
        /// Share of light the ground reflects.
        diffuse: color = [0.5, 0.5, 0.5, 1.0], in UNIT;
    }
    outputs {
        /// The reflectance, per steradian; alpha is 1.
        value: color, in NOT_NEGATIVE;
        /// The coat's part of it.
        coat: color, in NOT_NEGATIVE;
        /// The ground's part of it.
        ground: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let frame = Frame::along(i.normal, i.tangent);
        let coat = coat(&facets, &frame, i.exponent_u, i.exponent_v, i.specular);
        let ground = ground(&facets, i.specular, i.diffuse);
        let above = facets.above();
        Outputs { value: shown(above, coat + ground), coat: shown(above, coat), ground: shown(above, ground) }
    }
}

/// The coat's reflectance where light and viewer are above the surface.
#[inline(always)]
pub fn coat<R: Real>(
    facets: &Facets<R>,
    frame: &Frame<R>,
    u: R,
    v: R,
    specular: Color<R>,
) -> Color<R> {
    let cosine = facets.cosine_half();
    let high = facets.cosine_in.maximum(facets.cosine_out);
    let lobe = lobe(facets, frame, u, v) * 0.25 / cosine / high;
    schlick_color(specular, grey(lobe.same(1.0)), cosine) * lobe
}

/// `sqrt((a + 1) (b + 1)) / (2 pi) (n·h)^e`: the density of half vectors.
#[inline(always)]
pub fn lobe<R: Real>(facets: &Facets<R>, frame: &Frame<R>, u: R, v: R) -> R {
    let (along, across) = (facets.sum.dot(frame.u), facets.sum.dot(frame.v));
    let (along, across) = (along * along, across * across);
    let exponent = (u * along + v * across).divide_or_zero(along + across);
    let power = (exponent * facets.slope_squared().log1p() * -0.5).exp();
    ((u + 1.0) * (v + 1.0)).sqrt() * (0.5 / PI) * power
}

/// The ground's reflectance where light and viewer are above the surface.
#[inline(always)]
pub fn ground<R: Real>(facets: &Facets<R>, specular: Color<R>, diffuse: Color<R>) -> Color<R> {
    let rest = (grey(specular.r.same(1.0)) - specular).maximum(grey(specular.r.same(0.0)));
    let both = rising(facets.cosine_in) * rising(facets.cosine_out);
    diffuse * rest * (both * (28.0 / (23.0 * PI)))
}

/// `1 - (1 - c / 2)^5`.
#[inline(always)]
fn rising<R: Real>(cosine: R) -> R {
    let x = cosine * 0.5;
    let second = x.mul_add((x - 5.0).mul_add(x, x.same(10.0)), x.same(-10.0));
    x * x.mul_add(second, x.same(5.0))
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn head_on_nothing_is_undefined() {
        let coat = number!(normal = UP, direction = UP, ray = DOWN, tangent = [1.0, 0.0, 0.0], specular = [0.5, 0.5, 0.5, 1.0] => coat);
        crate::nodes::harness::assert_close(&[coat], &[0.6631124381074464], 1e-6, 0.0);
    }

    #[test]
    fn the_parts_sum_up() {
        let given = |output: usize| {
            let (direction, ray) = ([0.6, 0.0, 0.8], [0.8, 0.0, -0.6]);
            match output {
                0 => numbers!(normal = UP, direction = direction, ray = ray => value),
                1 => numbers!(normal = UP, direction = direction, ray = ray => coat),
                _ => numbers!(normal = UP, direction = direction, ray = ray => ground),
            }
        };
        assert_eq!(given(0)[0], given(1)[0] + given(2)[0]);
        assert!(given(1)[0] > 0.0 && given(2)[0] > 0.0);
    }
}
