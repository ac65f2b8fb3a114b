//! Reflection and refraction at the surface of a point.

use glam::{Vec3, Vec4};
use phenomenon_compiler::state::State;

use super::arithmetic::Arithmetic;

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

/// Share of light the surface mirrors.
#[inline(always)]
pub fn fresnel<A: Arithmetic>(point: &State, ior: f32) -> f32 {
    let (n1, n2) = media(point, ior);
    A::fresnel(n1, n2, -point.dot_nd)
}

/// Direction of the mirrored ray.
#[inline(always)]
pub fn reflect<A: Arithmetic>(point: &State) -> Vec3 {
    A::reflect(point.direction.into(), point.normal.into(), point.normal_geom.into())
}

/// Direction of the refracted ray, and whether it is totally reflected instead.
#[inline(always)]
pub fn refract<A: Arithmetic>(point: &State, ior: f32) -> (Vec3, bool) {
    let (n1, n2) = media(point, ior);
    let (direction, normal) = (point.direction.into(), point.normal.into());
    A::refract(direction, normal, point.normal_geom.into(), n1, n2)
}

/// Colour with another's red, green and blue multiplied in; alpha stays.
#[inline(always)]
pub fn filtered(color: Vec4, by: Vec3) -> Vec4 {
    color * by.extend(1.0)
}
