//! Reflection and refraction at a smooth boundary.

use glam::{Vec3, Vec4};
use phenomenon_compiler::state::State;

/// An index of refraction as shaders read it: 0 and less mean unset.
fn index(ior: f32) -> f32 {
    if ior > 0.0 { ior.clamp(1.0 / 64.0, 100.0) } else { 1.0 }
}

/// The indices before and behind the surface, in the ray's order.
pub fn media(point: &State, ior: f32) -> (f32, f32) {
    match point.inv_normal {
        true => (index(ior), index(point.ior)),
        false => (index(point.ior_in), index(ior)),
    }
}

/// Share of unpolarised light reflected at a boundary.
pub fn fresnel(n1: f32, n2: f32, cosine: f32) -> f32 {
    if n1 == n2 {
        return 0.0;
    }
    let cosine = cosine.clamp(0.0, 1.0);
    let ratio = n1 / n2;
    let sine_squared = ratio * ratio * (1.0 - cosine * cosine);
    if sine_squared >= 1.0 {
        return 1.0;
    }
    let refracted = (1.0 - sine_squared).sqrt();
    let rs = (n1 * cosine - n2 * refracted) / (n1 * cosine + n2 * refracted);
    let rp = (n2 * cosine - n1 * refracted) / (n2 * cosine + n1 * refracted);
    0.5 * (rs * rs + rp * rp)
}

/// Share of light the surface at a point mirrors.
pub fn fresnel_at(point: &State, ior: f32) -> f32 {
    let (n1, n2) = media(point, ior);
    fresnel(n1, n2, -point.dot_nd)
}

/// Direction of the mirrored ray, lifted onto the geometric surface should a bent normal send it
/// below.
pub fn reflect(point: &State) -> Vec3 {
    let (direction, normal) = (Vec3::from(point.direction), Vec3::from(point.normal));
    let surface = Vec3::from(point.normal_geom);
    let mirrored = direction - 2.0 * direction.dot(normal) * normal;
    let above = mirrored.dot(surface);
    let lifted = if above <= 0.0 { mirrored + (1e-4 - above) * surface } else { mirrored };
    lifted.normalize_or_zero()
}

/// Direction of the refracted ray, and whether it is totally reflected instead.
pub fn refract(point: &State, n1: f32, n2: f32) -> (Vec3, bool) {
    let (direction, normal) = (Vec3::from(point.direction), Vec3::from(point.normal));
    if n1 == n2 {
        return (direction, false);
    }
    let cosine = (-direction.dot(normal)).clamp(0.0, 1.0);
    let ratio = n1 / n2;
    let squared = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    if squared <= 0.0 {
        return (reflect(point), true);
    }
    let refracted = direction * ratio + normal * (ratio * cosine - squared.sqrt());
    let surface = Vec3::from(point.normal_geom);
    let above = refracted.dot(surface);
    let lowered = if above >= 0.0 { refracted - (1e-4 + above) * surface } else { refracted };
    (lowered.normalize_or_zero(), false)
}

/// Colour with another's red, green and blue multiplied in; alpha stays.
pub fn filtered(color: Vec4, by: Vec3) -> Vec4 {
    color * by.extend(1.0)
}
