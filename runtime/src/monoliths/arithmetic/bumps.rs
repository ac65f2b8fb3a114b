use glam::Vec3;
use phenomenon_compiler::emit::functions::bent_normal::{along_surface, facing_out, raised, slope};
use phenomenon_compiler::emit::scalar::F32;

use super::frames::Frames;
use super::kinds::{SameBits, Std, vec3, vector};

/// Surfaces raised by heights.
pub trait Bumps {
    /// The ways of both surface coordinates, of unit length, from how the point moves with them; any two where
    /// these do not span the surface.
    fn ways(derivatives: [Vec3; 2], normal: Vec3) -> [Vec3; 2];
    /// The unit normal of a surface that is raised by the first height here, and by the others a step along
    /// each of its ways. Where it would mirror the ray below the surface, whose geometric normal is `surface`,
    /// it is bent less.
    fn bumped(
        ways: [Vec3; 2],
        heights: [f32; 3],
        step: f32,
        normal: Vec3,
        direction: Vec3,
        surface: Vec3,
    ) -> Vec3;
}

/// The sine of the angle by which two ways must be apart to span a surface.
const APART: f32 = 1e-3;

/// The sine of the angle by which a mirrored ray is kept above the surface.
const ABOVE: f32 = 1e-3;

impl Bumps for Std {
    #[inline]
    fn ways(derivatives: [Vec3; 2], normal: Vec3) -> [Vec3; 2] {
        let [u, v] = derivatives.map(Vec3::normalize_or_zero);
        if u.cross(v).dot(normal).abs() > APART {
            return [u, v];
        }
        let any = Self::any_tangent(normal);
        [any, normal.cross(any)]
    }

    #[inline]
    fn bumped(
        [u, v]: [Vec3; 2],
        [here, at_u, at_v]: [f32; 3],
        step: f32,
        normal: Vec3,
        direction: Vec3,
        surface: Vec3,
    ) -> Vec3 {
        // Mikkelsen 2010, equation 4.
        let (to_u, to_v) = (v.cross(normal), normal.cross(u));
        let determinant = u.dot(to_u);
        let gradient = (to_u * (at_u - here) + to_v * (at_v - here)) / step;
        let bent = normal * determinant.abs() - gradient * determinant.signum();
        let bent = bent.normalize_or_zero();
        let away = bent.dot(direction).max(0.0);
        let facing = bent - direction * away;
        let mirrored = direction - facing * (2.0 * facing.dot(direction));
        let missing = ABOVE - mirrored.dot(surface);
        if missing <= 0.0 && away <= 0.0 {
            return bent;
        }
        // Halfway between the ray and where it must at least go.
        let lifted = (mirrored + surface * missing).normalize_or_zero();
        let halfway = (lifted - direction).normalize_or_zero();
        if bent == Vec3::ZERO || halfway == Vec3::ZERO { surface } else { halfway }
    }
}

impl Bumps for SameBits {
    #[inline(always)]
    fn ways([u, v]: [Vec3; 2], normal: Vec3) -> [Vec3; 2] {
        let along = along_surface(vector(u), vector(v), vector(normal));
        [vec3(along.across), vec3(along.up)]
    }

    #[inline(always)]
    fn bumped(
        [u, v]: [Vec3; 2],
        [here, at_u, at_v]: [f32; 3],
        step: f32,
        normal: Vec3,
        direction: Vec3,
        surface: Vec3,
    ) -> Vec3 {
        let one = F32(1.0);
        let slopes = [
            slope([F32(here), F32(at_u)], F32(step), one),
            slope([F32(here), F32(at_v)], F32(step), one),
        ];
        let bent = raised([vector(u), vector(v)], slopes, vector(normal));
        vec3(facing_out(bent, vector(direction), vector(surface)))
    }
}
