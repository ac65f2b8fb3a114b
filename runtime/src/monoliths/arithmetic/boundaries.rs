use glam::Vec3;
use phenomenon_compiler::emit::Real;
use phenomenon_compiler::emit::scalar::{F32, Scalar};
use phenomenon_compiler::nodes::fresnel::fresnel_dielectric::reflectance;
use phenomenon_compiler::nodes::fresnel::fresnel_schlick::schlick;
use phenomenon_compiler::nodes::rays::reflection_direction::mirrored;
use phenomenon_compiler::nodes::rays::refraction_direction::refracted;

use super::kinds::{SameBits, Std, vec3, vector};

/// Light at smooth boundaries. Directions come towards the surface; `surface` is the geometric normal.
pub trait Boundaries {
    /// Share of unpolarised light reflected at a boundary, from the index `n1` to `n2`.
    fn fresnel(n1: f32, n2: f32, cosine: f32) -> f32;
    /// Schlick's share of light reflected, for each component of a colour: `head_on` there, all of it at grazing
    /// angles.
    fn schlick(head_on: Vec3, cosine: f32) -> Vec3;
    /// Direction of the mirrored ray, lifted onto the surface should a bent normal send it below.
    fn reflect(direction: Vec3, normal: Vec3, surface: Vec3) -> Vec3;
    /// Direction of the refracted ray, and whether it is totally reflected instead.
    fn refract(direction: Vec3, normal: Vec3, surface: Vec3, n1: f32, n2: f32) -> (Vec3, bool);
}

impl Boundaries for Std {
    #[inline]
    fn fresnel(n1: f32, n2: f32, cosine: f32) -> f32 {
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

    #[inline]
    fn schlick(head_on: Vec3, cosine: f32) -> Vec3 {
        head_on + (1.0 - head_on) * (1.0 - cosine.clamp(0.0, 1.0)).powi(5)
    }

    #[inline]
    fn reflect(direction: Vec3, normal: Vec3, surface: Vec3) -> Vec3 {
        let mirrored = direction - 2.0 * direction.dot(normal) * normal;
        let above = mirrored.dot(surface);
        let lifted = if above <= 0.0 { mirrored + (1e-4 - above) * surface } else { mirrored };
        lifted.normalize_or_zero()
    }

    #[inline]
    fn refract(direction: Vec3, normal: Vec3, surface: Vec3, n1: f32, n2: f32) -> (Vec3, bool) {
        if n1 == n2 {
            return (direction, false);
        }
        let cosine = (-direction.dot(normal)).clamp(0.0, 1.0);
        let ratio = n1 / n2;
        let squared = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
        if squared <= 0.0 {
            return (Self::reflect(direction, normal, surface), true);
        }
        let refracted = direction * ratio + normal * (ratio * cosine - squared.sqrt());
        let above = refracted.dot(surface);
        let lowered = if above >= 0.0 { refracted - (1e-4 + above) * surface } else { refracted };
        (lowered.normalize_or_zero(), false)
    }
}

impl Boundaries for SameBits {
    #[inline(always)]
    fn fresnel(n1: f32, n2: f32, cosine: f32) -> f32 {
        reflectance(Scalar, F32(n1), F32(n2), F32(cosine)).0
    }

    #[inline(always)]
    fn schlick(head_on: Vec3, cosine: f32) -> Vec3 {
        let cosine = F32(cosine).saturate();
        Vec3::from(head_on.to_array().map(|f0| schlick(F32(f0), F32(1.0), cosine).saturate().0))
    }

    #[inline(always)]
    fn reflect(direction: Vec3, normal: Vec3, surface: Vec3) -> Vec3 {
        vec3(mirrored(Scalar, vector(direction), vector(normal), vector(surface)))
    }

    #[inline(always)]
    fn refract(direction: Vec3, normal: Vec3, surface: Vec3, n1: f32, n2: f32) -> (Vec3, bool) {
        let (direction, normal, surface) = (vector(direction), vector(normal), vector(surface));
        let (bent, total) = refracted(Scalar, [F32(n1), F32(n2)], direction, normal, surface);
        (vec3(bent), total.0)
    }
}
