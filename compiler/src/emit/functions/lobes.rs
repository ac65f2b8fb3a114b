//! Directions drawn from lobes: two numbers from 0 to below 1 become a direction, and every lobe has its
//! density over directions.

use std::f64::consts::{PI, TAU};

use super::conventions::not_negative;
use super::distributions::{BECKMANN, ELLIPSOID, distribution};
use super::facets::Facets;
use super::frames::Frame;
use crate::emit::{Real, Vector};

/// A drawn number, 0 to the largest number below 1.
#[inline(always)]
pub fn drawn<R: Real>(number: R) -> R {
    number.clamp_to(number.same(0.0), number.same(1.0 - 2.0_f64.powi(-24)))
}

/// The direction of a share of a full turn, as cosine and sine.
#[inline(always)]
pub fn turned<R: Real>(share: R) -> (R, R) {
    let angle = share.saturate() * TAU;
    (angle.cos(), angle.sin())
}

/// A direction about a unit vector, as dense as the cosine from it.
#[inline(always)]
pub fn cosine_direction<R: Real>(normal: Vector<R>, first: R, second: R) -> Vector<R> {
    let first = drawn(first);
    let radius = first.sqrt();
    let (x, y) = turned(second);
    let height = (first.same(1.0) - first).sqrt();
    Frame::around(normal).world(Vector { x: x * radius, y: y * radius, z: height }).normalized()
}

/// The density of [`cosine_direction`].
#[inline(always)]
pub fn cosine_density<R: Real>(normal: Vector<R>, direction: Vector<R>) -> R {
    not_negative(normal.dot(direction) * (1.0 / PI))
}

/// Tangent of a half vector drawn from a normalised distribution times the cosine.
#[inline(always)]
pub fn drawn_slope<R: Real>(kind: i32, number: R, roughness: R) -> R {
    let number = drawn(number);
    // -ln(1 - number).
    let depth = -(-number).log1p();
    let squared = roughness * roughness;
    match kind {
        BECKMANN => depth.sqrt() * roughness,
        ELLIPSOID => (number / (number.same(1.0) - number)).sqrt() * roughness,
        _ => (squared * depth).expm1().sqrt(),
    }
}

/// The ray mirrored at a half vector: towards where its light comes from.
#[inline(always)]
pub fn mirrored_at<R: Real>(half: Vector<R>, ray: Vector<R>) -> Vector<R> {
    let twice = half.dot(ray) * -2.0;
    (half * twice + ray).normalized()
}

/// Density over directions of one that is mirrored at a half vector, whose own density is `of_half`; of
/// either sign, since what the ray sees from behind is mirrored too.
#[inline(always)]
pub fn mirrored_density<R: Real>(facets: &Facets<R>, of_half: R) -> R {
    // 1 / (4 v·h), v·h = |s| / 2.
    let size = facets.squared().sqrt();
    not_negative(of_half / (size * 2.0))
}

/// Density of a direction mirrored at a half vector from an isotropic distribution.
#[inline(always)]
pub fn facet_density<R: Real>(kind: i32, facets: &Facets<R>, roughness: R) -> R {
    let cosine = facets.height().absolute() / facets.squared().sqrt();
    let spread = distribution(kind, facets.slope_squared(), roughness);
    mirrored_density(facets, spread * cosine)
}
