use glam::Vec3;
use phenomenon_compiler::emit::functions::colors::from_hsv;
use phenomenon_compiler::emit::scalar::{F32, Scalar};
use phenomenon_compiler::nodes::color::overlay::overlay;

use super::kinds::{SameBits, Std, rgb};

/// Colours.
pub trait Colors {
    /// The colour of a hue in turns, a saturation and a value.
    fn of_hue(hue: f32, saturation: f32, value: f32) -> Vec3;
    /// A layer of colours in 0..=1 laid over a base; bases of 1 and more pass.
    fn overlay(base: Vec3, layer: Vec3) -> Vec3;
}

impl Colors for Std {
    #[inline]
    fn of_hue(hue: f32, saturation: f32, value: f32) -> Vec3 {
        let sextants = (hue - hue.floor()) * 6.0;
        let red = (sextants - 3.0).abs() - 1.0;
        let green = 2.0 - (sextants - 2.0).abs();
        let blue = 2.0 - (sextants - 4.0).abs();
        let pure = Vec3::new(red, green, blue).clamp(Vec3::ZERO, Vec3::ONE);
        Vec3::ONE.lerp(pure, saturation) * value
    }

    #[inline]
    fn overlay(base: Vec3, layer: Vec3) -> Vec3 {
        let blended = base * (base + 2.0 * layer * (1.0 - base));
        let lit = Vec3::select(base.cmpgt(Vec3::ZERO), blended, Vec3::ZERO);
        Vec3::select(base.cmpge(Vec3::ONE), base, lit)
    }
}

impl Colors for SameBits {
    #[inline(always)]
    fn of_hue(hue: f32, saturation: f32, value: f32) -> Vec3 {
        rgb(from_hsv([F32(hue), F32(saturation), F32(value)], F32(1.0)))
    }

    #[inline(always)]
    fn overlay(base: Vec3, layer: Vec3) -> Vec3 {
        Vec3::new(
            overlay(Scalar, F32(base.x), F32(layer.x)).0,
            overlay(Scalar, F32(base.y), F32(layer.y)).0,
            overlay(Scalar, F32(base.z), F32(layer.z)).0,
        )
    }
}
