use std::f64::consts::TAU;

use crate::emit::functions::facets::Facets;
use crate::emit::{Mask, Real};
use crate::nodes::{NOT_NEGATIVE, state};
use crate::state::Field;

node! {
    /// Phong's lobe about the mirror direction. With `c` the cosine between that and the viewer:
    /// `c^exponent`; `schlick` is `c / (exponent - exponent c + c)`, cheaper, with longer tails; `normalized`
    /// is `(exponent + 2) / (2 pi) c^exponent`, which reflects at most all light. Draw directions by
    /// `phong_sample`. All are reciprocal; the first two conserve no energy.
    ///
    /// `1 - c` is half the squared distance between mirrored light and viewer, and the power is
    /// `exp(exponent log1p(c - 1))`: near the mirror direction an exponent of 10^7 keeps its accuracy.
    phong_brdf in brdf,
    source "Phong 1975; Schlick 1994, A Fast Alternative to Phong's Specular Model; Lewis 1994, Making Shaders More Physically Plausible",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// How narrow the lobe is.
        exponent: scalar = 20.0, in 0.0..=1e8, soft 1.0..=1000.0;
        /// Which of the three.
        kind: choice = 2, of ["phong", "schlick", "normalized"];
    }
    outputs {
        /// The reflectance, per steradian.
        value: scalar, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        Outputs { value: facets.where_above(lobe(&facets, i.exponent, i.kind)) }
    }
}

/// The lobe where light and viewer are above the surface.
#[inline(always)]
pub fn lobe<R: Real>(facets: &Facets<R>, exponent: R, kind: i32) -> R {
    let off = facets.off_mirror();
    let (zero, one) = (off.same(0.0), off.same(1.0));
    let cosine = one - off;
    let value = match kind {
        1 => cosine / exponent.mul_add(off, cosine),
        _ => (exponent * (-off).log1p()).exp(),
    };
    let value = if kind == 2 { value * ((exponent + 2.0) * (1.0 / TAU)) } else { value };
    off.less(one).select(value, zero)
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn the_peak_is_known_and_an_exponent_of_zero_is_flat() {
        let at = |direction: [f32; 3], exponent: f32, kind: i32| number!(normal = UP, direction = direction, ray = DOWN, exponent = exponent, kind = kind => value);
        for exponent in [0.0, 1.0, 1e7] {
            assert_eq!(at(UP, exponent, 0), 1.0);
            assert_eq!(at(UP, exponent, 1), 1.0);
        }
        assert_eq!(at([0.6, 0.0, 0.8], 0.0, 0), 1.0);
        crate::nodes::harness::assert_close(
            &[at(UP, 1e7, 2)],
            &[(1e7 + 2.0) / std::f64::consts::TAU],
            2e-7,
            0.0,
        );
        crate::nodes::harness::assert_close(&[at([0.6, 0.0, 0.8], 3.0, 0)], &[0.512], 1e-6, 0.0);
    }
}
