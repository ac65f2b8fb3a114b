use std::f32::consts::TAU;

use glam::Vec3;
use phenomenon_compiler::emit::Real;
use phenomenon_compiler::emit::scalar::{F32, Scalar};
use phenomenon_compiler::nodes::samples::direction_cone::round_axis;
use phenomenon_compiler::nodes::samples::glossy_reflection_direction::facet;

use super::frames::{Frame, Frames};
use super::kinds::{SameBits, Std, vec3, vector};

/// Directions drawn: two numbers from 0 to below 1 become a direction.
pub trait Directions {
    /// The normal of a facet of a rough surface, on the side the ray comes from. Roughness is the deviation of
    /// the slopes along the tangent and across it; of two that are the same the tangent does not count.
    fn facet(
        direction: Vec3,
        normal: Vec3,
        tangent: Vec3,
        roughness: [f32; 2],
        numbers: [f32; 2],
    ) -> Vec3;
    /// A direction evenly spread over the solid angle of a cone round an axis of any length; the angle, in
    /// radians, lies between axis and side.
    fn in_cone(axis: Vec3, angle: f32, numbers: [f32; 2]) -> Vec3;
}

impl Directions for Std {
    #[inline]
    fn facet(
        direction: Vec3,
        normal: Vec3,
        tangent: Vec3,
        [along, across]: [f32; 2],
        [u, v]: [f32; 2],
    ) -> Vec3 {
        let tangent = match along == across {
            true => Self::any_tangent(normal),
            false => Self::tangent_along(tangent, normal),
        };
        let slope = (-(-u).ln_1p()).sqrt();
        let (sine, cosine) = (v * TAU).sin_cos();
        let frame = Frame { u: tangent, v: normal.cross(tangent), n: normal };
        let tilted = Vec3::new(along * slope * cosine, across * slope * sine, 1.0);
        let facet = Self::in_world(&frame, tilted).normalize();
        if facet.dot(direction) < 0.0 { facet } else { normal }
    }

    #[inline]
    fn in_cone(axis: Vec3, angle: f32, [u, v]: [f32; 2]) -> Vec3 {
        let axis = axis.normalize_or_zero();
        let half = (angle * 0.5).sin();
        // 1 less the cosine of the angle to the axis.
        let height = u * 2.0 * half * half;
        let radius = (height * (2.0 - height)).max(0.0).sqrt();
        let (sine, cosine) = (v * TAU).sin_cos();
        let tangent = Self::any_tangent(axis);
        let frame = Frame { u: tangent, v: axis.cross(tangent), n: axis };
        Self::in_world(&frame, Vec3::new(radius * cosine, radius * sine, 1.0 - height))
    }
}

impl Directions for SameBits {
    #[inline(always)]
    fn facet(
        direction: Vec3,
        normal: Vec3,
        tangent: Vec3,
        [along, across]: [f32; 2],
        [u, v]: [f32; 2],
    ) -> Vec3 {
        let (tangent, direction, normal) = (vector(tangent), vector(direction), vector(normal));
        let roughness = [F32(along), F32(across)];
        vec3(facet(Scalar, roughness, tangent, direction, normal, [F32(u), F32(v)]))
    }

    #[inline(always)]
    fn in_cone(axis: Vec3, angle: f32, [u, v]: [f32; 2]) -> Vec3 {
        let angle = F32(angle).clamp_to(F32(0.0), F32(std::f32::consts::PI));
        let half = (angle * 0.5).sin();
        let width = half * half * 2.0;
        vec3(round_axis(Scalar, vector(axis), F32(u).saturate() * width, F32(v)))
    }
}
