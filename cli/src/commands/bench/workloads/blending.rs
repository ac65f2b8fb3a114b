//! Formulas that several workloads share, as their nodes have them.

use glam::Vec3;

/// The colour of a hue in turns.
pub fn hue(hue: f32, saturation: f32, value: f32) -> Vec3 {
    let sextants = (hue - hue.floor()) * 6.0;
    let red = (sextants - 3.0).abs() - 1.0;
    let green = 2.0 - (sextants - 2.0).abs();
    let blue = 2.0 - (sextants - 4.0).abs();
    let pure = Vec3::new(red, green, blue).clamp(Vec3::ZERO, Vec3::ONE);
    value * (saturation * pure + (1.0 - saturation))
}

/// A layer of colours in 0..=1 laid over a base; bases of 1 and more pass.
pub fn overlay(base: Vec3, layer: Vec3) -> Vec3 {
    let blended = base * (base + 2.0 * layer * (1.0 - base));
    let lit = Vec3::select(base.cmpgt(Vec3::ZERO), blended, Vec3::ZERO);
    Vec3::select(base.cmpge(Vec3::ONE), base, lit)
}

/// A layer of light over a base; where either reaches 1, the brighter.
pub fn screen(base: Vec3, layer: Vec3) -> Vec3 {
    let both_below_one = base.cmplt(Vec3::ONE) & layer.cmplt(Vec3::ONE);
    Vec3::select(both_below_one, base + layer * (1.0 - base), base.max(layer))
}

/// From 0 at `low` to 1 at `high`.
pub fn smooth_step(at: f32, low: f32, high: f32) -> f32 {
    let t = ((at - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
