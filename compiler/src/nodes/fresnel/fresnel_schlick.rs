use crate::emit::{Color, Real};
use crate::nodes::finite::UNIT;

node! {
    /// Schlick's reflectance of a boundary, per component: `f0 + (f90 - f0) (1 - cosine)^5`. Close to
    /// `fresnel_dielectric` for `f0 = ((n - 1) / (n + 1))^2`; `f90` is 1 unless edges are to be tinted.
    /// MaterialX calls them `color0` and `color90`.
    fresnel_schlick in fresnel per component,
    source "Schlick 1994, An Inexpensive BRDF Model for Physically-based Rendering",
    inputs {
        /// Reflectance head on.
        f0: generic = 0.04, in UNIT;
        /// Reflectance at grazing angles.
        f90: generic = 1.0, in UNIT;
        /// Cosine between the light's direction and the normal, clamped to 0..1.
        cosine: scalar = 1.0, in -1.0..=1.0;
    }
    outputs {
        /// Share reflected.
        reflectance: generic, in UNIT;
    }
    body |e, i| schlick(i.f0, i.f90, i.cosine.saturate()).saturate()
}

/// Of a cosine from 0 to 1.
#[inline(always)]
pub fn schlick<R: Real>(f0: R, f90: R, cosine: R) -> R {
    let rest = cosine.same(1.0) - cosine;
    let squared = rest * rest;
    (f90 - f0).mul_add(squared * squared * rest, f0)
}

/// The same for each of a colour's components.
#[inline(always)]
pub fn schlick_color<R: Real>(f0: Color<R>, f90: Color<R>, cosine: R) -> Color<R> {
    Color {
        r: schlick(f0.r, f90.r, cosine),
        g: schlick(f0.g, f90.g, cosine),
        b: schlick(f0.b, f90.b, cosine),
        a: f0.a,
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn known_values() {
        assert_close(&[number!(f0 = 0.04, cosine = 0.5 => reflectance)], &[0.07], 1e-6, 0.0);
        assert_eq!(number!(f0 = 0.0, cosine = 1.0 => reflectance), 0.0);
        assert_eq!(number!(f0 = 0.3, cosine = 0.0 => reflectance), 1.0);
        assert_eq!(number!(f0 = 0.3, f90 = 0.5, cosine = -1.0 => reflectance), 0.5);
        let color =
            numbers!(f0 = [0.0, 0.5, 1.0, 0.25], f90 = [1.0; 4], cosine = 0.5 => reflectance);
        assert_close(&color, &[0.03125, 0.515625, 1.0, 0.25], 1e-7, 0.0);
    }
}
