//! Formulas that several workloads share, as their nodes have them.

use glam::Vec3A;

/// What is left above the next lower integer, of a number that fits an integer. Without SSE 4.1
/// `floor` is a call, which would cost as much as all the rest of a blend.
pub fn fraction(x: f32) -> f32 {
    let towards_zero = x as i32 as f32;
    let rest = x - towards_zero;
    if rest < 0.0 { rest + 1.0 } else { rest }
}

/// The colour of a hue in turns.
pub fn hue(hue: f32, saturation: f32, value: f32) -> Vec3A {
    let sextants = fraction(hue) * 6.0;
    let red = (sextants - 3.0).abs() - 1.0;
    let green = 2.0 - (sextants - 2.0).abs();
    let blue = 2.0 - (sextants - 4.0).abs();
    let pure = Vec3A::new(red, green, blue).clamp(Vec3A::ZERO, Vec3A::ONE);
    value * (saturation * pure + (1.0 - saturation))
}

/// A layer of colours in 0..=1 laid over a base; bases of 1 and more pass.
pub fn overlay(base: Vec3A, layer: Vec3A) -> Vec3A {
    let blended = base * (base + 2.0 * layer * (1.0 - base));
    let lit = Vec3A::select(base.cmpgt(Vec3A::ZERO), blended, Vec3A::ZERO);
    Vec3A::select(base.cmpge(Vec3A::ONE), base, lit)
}

/// A layer of light over a base; where either reaches 1, the brighter.
pub fn screen(base: Vec3A, layer: Vec3A) -> Vec3A {
    let both_below_one = base.cmplt(Vec3A::ONE) & layer.cmplt(Vec3A::ONE);
    Vec3A::select(both_below_one, base + layer * (1.0 - base), base.max(layer))
}

/// From 0 at `low` to 1 at `high`.
pub fn smooth_step(at: f32, low: f32, high: f32) -> f32 {
    let t = ((at - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
