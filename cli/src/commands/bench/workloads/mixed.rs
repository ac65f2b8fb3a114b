//! `mixed.json` by hand.

use glam::{Vec3A, Vec4};
use phenomenon_compiler::state::State;

use super::blending::hue;

pub struct Layer {
    pub shift: Vec3A,
    pub frequencies: Vec3A,
    pub exponent: f32,
    pub saturation: f32,
    pub weight: f32,
}

const fn layer(
    shift: Vec3A,
    frequencies: Vec3A,
    exponent: f32,
    saturation: f32,
    weight: f32,
) -> Layer {
    Layer { shift, frequencies, exponent, saturation, weight }
}

pub static LAYERS: [Layer; 12] = [
    layer(Vec3A::new(-0.678, 0.246, 0.618), Vec3A::new(-1.755, -2.82, 3.999), 2.007, 0.816, 0.277),
    layer(Vec3A::new(0.386, -0.451, 0.636), Vec3A::new(2.395, 3.723, -3.675), 1.521, 0.442, 0.156),
    layer(Vec3A::new(-0.363, 0.455, -0.699), Vec3A::new(3.986, 3.39, 3.369), 1.124, 0.815, 0.261),
    layer(Vec3A::new(0.677, 0.558, -0.527), Vec3A::new(2.47, 2.503, 2.985), 2.199, 0.577, 0.292),
    layer(Vec3A::new(0.66, -0.443, -0.67), Vec3A::new(3.63, 3.319, 1.929), 1.024, 0.425, 0.278),
    layer(
        Vec3A::new(-0.667, 0.592, -0.563),
        Vec3A::new(-3.991, -1.176, -1.819),
        1.765,
        0.85,
        0.339,
    ),
    layer(Vec3A::new(0.268, -0.322, -0.672), Vec3A::new(-2.269, 1.17, -1.516), 0.566, 0.873, 0.156),
    layer(
        Vec3A::new(-0.565, -0.387, -0.607),
        Vec3A::new(-3.204, -2.157, -3.382),
        0.703,
        0.322,
        0.236,
    ),
    layer(Vec3A::new(-0.508, 0.343, 0.215), Vec3A::new(-2.655, 3.706, -3.587), 1.346, 0.435, 0.315),
    layer(Vec3A::new(-0.358, -0.212, 0.459), Vec3A::new(2.461, 1.431, 1.777), 1.707, 0.72, 0.39),
    layer(
        Vec3A::new(0.535, -0.217, 0.285),
        Vec3A::new(-2.905, -3.984, -3.242),
        0.902,
        0.655,
        0.306,
    ),
    layer(Vec3A::new(0.6, 0.328, -0.339), Vec3A::new(1.453, -2.226, -2.536), 0.882, 0.36, 0.195),
];

/// Its colour at a point.
pub fn shade(point: &State) -> Vec4 {
    let mut color = Vec4::from(point.incoming);
    let mut toward = Vec3A::from(point.normal);
    for layer in &LAYERS {
        toward = (toward + layer.shift).normalize_or_zero();
        let wave = toward.dot(layer.frequencies).sin();
        let tone = wave.exp().powf(layer.exponent);
        let layered = hue(wave, layer.saturation, tone).extend(1.0);
        color = color.lerp(layered, layer.weight);
    }
    color
}
