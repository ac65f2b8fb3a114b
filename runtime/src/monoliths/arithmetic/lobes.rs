use std::f32::consts::PI;

use glam::{Vec3, Vec4};
use phenomenon_compiler::emit::functions::facets::Facets;
use phenomenon_compiler::emit::functions::reflected::reflected;
use phenomenon_compiler::emit::scalar::F32;
use phenomenon_compiler::nodes::brdf::ashikhmin_shirley_brdf::{coat, ground};

use super::frames::{Frame, as_compiled};
use super::kinds::{SameBits, Std, color, rgb, vector};
use super::numbers::Numbers;

/// A surface, the light that falls onto it and the ray that looks at it.
#[derive(Clone, Copy, Debug)]
pub struct Facing {
    /// Unit normal.
    pub normal: Vec3,
    /// Unit direction towards the light.
    pub light: Vec3,
    /// Unit direction of the ray, towards the surface.
    pub ray: Vec3,
}

/// Light of one sample that surfaces reflect, by the models of the nodes of the same names. Of colours
/// with alpha, alpha does not count.
pub trait Lobes: Numbers {
    /// Whether light and viewer are above the surface: elsewhere all that follow are black.
    #[inline(always)]
    fn is_lit(facing: &Facing) -> bool {
        Self::dot(facing.normal, facing.light) > 0.0 && Self::dot(facing.normal, facing.ray) < 0.0
    }

    /// `color light cosine`: a matt surface, whose cosine is above 0.
    #[inline(always)]
    fn lambert(color: Vec3, light: Vec3, cosine: f32) -> Vec3 {
        color * light * cosine
    }

    /// A brushed, clear coat over a diffuse ground, for light and viewer above the surface. The exponents go
    /// along and across the frame.
    fn ashikhmin_shirley(
        facing: &Facing,
        frame: &Frame,
        exponents: [f32; 2],
        specular: Vec4,
        diffuse: Vec4,
        light: Vec3,
    ) -> Vec3;
}

impl Lobes for Std {
    #[inline]
    fn ashikhmin_shirley(
        facing: &Facing,
        frame: &Frame,
        [along, across]: [f32; 2],
        specular: Vec4,
        diffuse: Vec4,
        light: Vec3,
    ) -> Vec3 {
        let Facing { normal, light: to_light, ray } = *facing;
        let (cosine_in, cosine_out) = (normal.dot(to_light), -normal.dot(ray));
        let half = (to_light - ray).normalize();
        let (height, of_half) = (half.dot(normal), half.dot(to_light));
        let (of_u, of_v) = (half.dot(frame.u), half.dot(frame.v));
        let (of_u, of_v) = (of_u * of_u, of_v * of_v);
        // Squares of the sine of the half vector's angle: it vanishes in the middle of the highlight.
        let sine = of_u + of_v;
        let exponent = if sine > 0.0 { (along * of_u + across * of_v) / sine } else { 0.0 };
        let lobe = ((along + 1.0) * (across + 1.0)).sqrt() * height.min(1.0).powf(exponent);
        let specular = specular.truncate();
        let fresnel = specular + (1.0 - specular) * (1.0 - of_half).max(0.0).powi(5);
        let coat = fresnel * (lobe / (8.0 * PI * of_half * cosine_in.max(cosine_out)));
        let rising = |cosine: f32| 1.0 - (1.0 - 0.5 * cosine).powi(5);
        let ground = diffuse.truncate() * (1.0 - specular);
        let ground = ground * (28.0 / (23.0 * PI) * rising(cosine_in) * rising(cosine_out));
        (coat + ground) * light * cosine_in
    }
}

impl Lobes for SameBits {
    #[inline(always)]
    fn ashikhmin_shirley(
        facing: &Facing,
        frame: &Frame,
        [along, across]: [f32; 2],
        specular: Vec4,
        diffuse: Vec4,
        light: Vec3,
    ) -> Vec3 {
        let (facets, frame) = (facets(facing), as_compiled(frame));
        let specular = color(specular);
        let coat = coat(&facets, &frame, F32(along), F32(across), specular);
        let both = coat + ground(&facets, specular, color(diffuse));
        let light = color(light.extend(1.0));
        rgb(reflected(facets.above(), both, light, facets.cosine_in))
    }
}

/// A light and a viewer as the compiler's functions take them.
#[inline(always)]
pub(super) fn facets(facing: &Facing) -> Facets<F32> {
    Facets::of(vector(facing.normal), vector(facing.light), vector(facing.ray))
}
