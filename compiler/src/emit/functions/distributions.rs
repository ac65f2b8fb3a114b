//! How the normals of small facets are spread, and how facets hide each other.

use std::f64::consts::PI;

use super::facets::Facets;
use crate::emit::Real;

/// The distributions by their numbers as choices.
pub const DISTRIBUTIONS: [&str; 4] = ["beckmann", "ellipsoid", "power", "gaussian"];
/// Those that can be sampled.
pub const SAMPLED_DISTRIBUTIONS: [&str; 3] = ["beckmann", "ellipsoid", "power"];
/// Beckmann's, by the squared tangent.
pub const BECKMANN: i32 = 0;
/// That of ellipsoids: Trowbridge and Reitz's, also called GGX.
pub const ELLIPSOID: i32 = 1;
/// A power of the cosine.
pub const POWER: i32 = 2;

/// The ways of hiding by their numbers as choices.
pub const GEOMETRIES: [&str; 3] = ["cavity", "smith", "correlated"];
/// Facets are sides of long grooves in the shape of a V.
pub const CAVITY: i32 = 0;
/// Facets hide independently of each other, towards light and viewer independently.
pub const SMITH: i32 = 1;

/// Roughness as it is read: 0 would be a mirror, which has no value.
#[inline(always)]
pub fn roughness<R: Real>(roughness: R) -> R {
    roughness.clamp_to(roughness.same(1e-6), roughness.same(1.0))
}

/// The distribution before it is normalised: that of ellipsoids and the Gaussian one are 1 at the peak,
/// the others integrate to 1 over the hemisphere once multiplied by the cosine.
#[inline(always)]
pub fn spread<R: Real>(kind: i32, slope_squared: R, roughness: R) -> R {
    let squared = roughness * roughness;
    // 1 / cos^2.
    let secant_squared = slope_squared + 1.0;
    match kind {
        BECKMANN => {
            let slopes = (-(slope_squared / squared)).exp();
            slopes * secant_squared * secant_squared / (squared * PI)
        }
        ELLIPSOID => {
            let one_side = squared * secant_squared / (squared + slope_squared);
            one_side * one_side
        }
        POWER => {
            // The exponent n is 2 / m^2 - 2, and ln cos = -ln(1 + tan^2) / 2.
            let half_exponent = squared.same(1.0) / squared - 1.0;
            (-(half_exponent * slope_squared.log1p())).exp() / (squared * PI)
        }
        _ => {
            let angle = slope_squared.sqrt().atan() / roughness;
            (-(angle * angle)).exp()
        }
    }
}

/// The distribution normalised: the Gaussian one as far as roughness is small.
#[inline(always)]
pub fn distribution<R: Real>(kind: i32, slope_squared: R, roughness: R) -> R {
    let spread = spread(kind, slope_squared, roughness);
    match kind {
        BECKMANN | POWER => spread,
        _ => spread / (roughness * roughness * PI),
    }
}

/// Share of facets that are seen and lit, over `4 (n·l) (n·v)`.
#[inline(always)]
pub fn visibility<R: Real>(kind: i32, facets: &Facets<R>, roughness: R) -> R {
    let (light, viewer) = (facets.cosine_in, facets.cosine_out);
    match kind {
        CAVITY => {
            // min(1, 4 (n·s) low / s^2) / (4 low high): divided first, so that no product vanishes.
            let (low, high) = (light.minimum(viewer), light.maximum(viewer));
            let open = low.same(0.25) / low;
            open.minimum(facets.height() / facets.squared()) / high
        }
        SMITH => {
            let one = light.same(1.0);
            one / (light + stretched(light, roughness)) / (viewer + stretched(viewer, roughness))
        }
        _ => {
            let crossed = viewer * stretched(light, roughness);
            light.same(0.5) / light.mul_add(stretched(viewer, roughness), crossed)
        }
    }
}

/// Length of a direction with this cosine once what lies along the surface is scaled by roughness.
#[inline(always)]
fn stretched<R: Real>(cosine: R, roughness: R) -> R {
    let squared = roughness * roughness;
    cosine.mul_add(cosine, squared * (-cosine).mul_add(cosine, cosine.same(1.0))).sqrt()
}
