//! `light.json` by hand.

use glam::{Vec3A, Vec4, Vec4Swizzles};
use phenomenon_compiler::state::State;

use super::blending::screen;

pub struct Layer {
    pub tint: Vec3A,
    pub glow: Vec3A,
    pub color: Vec3A,
    pub dust: Vec3A,
}

const fn layer(tint: Vec3A, glow: Vec3A, color: Vec3A, dust: Vec3A) -> Layer {
    Layer { tint, glow, color, dust }
}

pub static LAYERS: [[Layer; 4]; 4] = [
    [
        layer(
            Vec3A::new(0.567, 0.924, 0.882),
            Vec3A::new(0.066, 0.109, 0.101),
            Vec3A::new(0.426, 0.494, 0.147),
            Vec3A::new(0.025, 0.17, 0.098),
        ),
        layer(
            Vec3A::new(0.501, 0.723, 0.861),
            Vec3A::new(0.061, 0.19, 0.182),
            Vec3A::new(0.115, 0.113, 0.371),
            Vec3A::new(0.189, 0.089, 0.059),
        ),
        layer(
            Vec3A::new(0.515, 0.611, 0.719),
            Vec3A::new(0.109, 0.062, 0.062),
            Vec3A::new(0.209, 0.33, 0.245),
            Vec3A::new(0.024, 0.171, 0.12),
        ),
        layer(
            Vec3A::new(0.593, 0.996, 0.93),
            Vec3A::new(0.042, 0.08, 0.15),
            Vec3A::new(0.456, 0.568, 0.311),
            Vec3A::new(0.169, 0.141, 0.075),
        ),
    ],
    [
        layer(
            Vec3A::new(0.941, 0.923, 0.753),
            Vec3A::new(0.126, 0.026, 0.064),
            Vec3A::new(0.499, 0.307, 0.187),
            Vec3A::new(0.119, 0.147, 0.141),
        ),
        layer(
            Vec3A::new(0.719, 0.754, 0.889),
            Vec3A::new(0.114, 0.091, 0.108),
            Vec3A::new(0.115, 0.122, 0.452),
            Vec3A::new(0.197, 0.127, 0.091),
        ),
        layer(
            Vec3A::new(0.751, 0.991, 0.885),
            Vec3A::new(0.117, 0.175, 0.062),
            Vec3A::new(0.357, 0.576, 0.389),
            Vec3A::new(0.103, 0.068, 0.119),
        ),
        layer(
            Vec3A::new(0.503, 0.892, 0.91),
            Vec3A::new(0.18, 0.153, 0.166),
            Vec3A::new(0.359, 0.381, 0.313),
            Vec3A::new(0.03, 0.177, 0.123),
        ),
    ],
    [
        layer(
            Vec3A::new(0.752, 0.742, 0.678),
            Vec3A::new(0.082, 0.117, 0.132),
            Vec3A::new(0.406, 0.329, 0.114),
            Vec3A::new(0.061, 0.052, 0.125),
        ),
        layer(
            Vec3A::new(0.899, 0.899, 0.908),
            Vec3A::new(0.066, 0.172, 0.141),
            Vec3A::new(0.142, 0.108, 0.107),
            Vec3A::new(0.156, 0.065, 0.04),
        ),
        layer(
            Vec3A::new(0.672, 0.535, 0.58),
            Vec3A::new(0.115, 0.05, 0.069),
            Vec3A::new(0.456, 0.327, 0.261),
            Vec3A::new(0.105, 0.024, 0.09),
        ),
        layer(
            Vec3A::new(0.594, 0.554, 0.95),
            Vec3A::new(0.112, 0.058, 0.129),
            Vec3A::new(0.509, 0.11, 0.109),
            Vec3A::new(0.046, 0.149, 0.049),
        ),
    ],
    [
        layer(
            Vec3A::new(0.839, 0.772, 0.61),
            Vec3A::new(0.196, 0.164, 0.113),
            Vec3A::new(0.212, 0.424, 0.297),
            Vec3A::new(0.124, 0.078, 0.134),
        ),
        layer(
            Vec3A::new(0.649, 0.984, 0.938),
            Vec3A::new(0.075, 0.175, 0.076),
            Vec3A::new(0.57, 0.472, 0.308),
            Vec3A::new(0.065, 0.022, 0.178),
        ),
        layer(
            Vec3A::new(0.91, 0.981, 0.785),
            Vec3A::new(0.051, 0.176, 0.195),
            Vec3A::new(0.452, 0.354, 0.289),
            Vec3A::new(0.082, 0.057, 0.141),
        ),
        layer(
            Vec3A::new(0.597, 0.552, 0.833),
            Vec3A::new(0.073, 0.11, 0.079),
            Vec3A::new(0.536, 0.55, 0.109),
            Vec3A::new(0.056, 0.079, 0.198),
        ),
    ],
];

/// Of each layer, how often its share of the blend runs from 0 to 1.
pub static TURNS: [Vec4; 4] = [
    Vec4::new(3.025, 2.344, 2.785, 2.675),
    Vec4::new(2.249, 1.841, 3.414, 1.9),
    Vec4::new(3.222, 2.75, 2.342, 2.909),
    Vec4::new(1.618, 1.576, 2.366, 3.065),
];

impl Layer {
    fn over(&self, color: Vec3A, share: f32) -> Vec3A {
        let lit = color * self.tint + self.glow;
        lit.lerp(self.color, share) * (1.0 - share)
    }
}

/// Its colour at a point.
pub fn shade(point: &State) -> Vec4 {
    let [u, v] = point.uv;
    let fields = Vec4::new(u, v, point.time, point.dist);
    let mut color = Vec3A::new(point.time, 0.4, 0.3);
    for (turns, [first, second, third, last]) in TURNS.iter().zip(&LAYERS) {
        // Four at once: without SSE 4.1, each floor alone would be a call.
        let places = fields.yzwx() * *turns + fields;
        let shares = places - places.floor();
        for (layer, share) in [(first, shares.x), (second, shares.y), (third, shares.z)] {
            color = (layer.over(color, share) - layer.dust).max(Vec3A::splat(0.02));
        }
        color = screen(last.over(color, shares.w), last.dust).min(Vec3A::splat(0.95));
    }
    color.extend(1.0)
}
