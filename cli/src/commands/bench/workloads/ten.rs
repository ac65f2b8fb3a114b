//! `ten.json` by hand.

use glam::{Vec3A, Vec4};
use phenomenon_compiler::state::State;

use super::blending::{fraction, hue, overlay, screen, smooth_step};

pub const LOW: Vec3A = Vec3A::new(0.31, 0.24, 0.17);
pub const HIGH: Vec3A = Vec3A::new(0.42, 0.55, 0.71);
pub const VEIL: Vec3A = Vec3A::new(0.8, 0.82, 0.85);
pub const GLOW: Vec3A = Vec3A::new(0.12, 0.1, 0.08);
pub const DUST: Vec3A = Vec3A::new(0.05, 0.04, 0.03);

/// Its colour at a point.
pub fn shade(point: &State) -> Vec4 {
    let front = point.dot_nd.abs();
    let rim = 1.0 - front;
    let at = Vec3A::from(point.point);
    let depth = at.length();
    let up = if depth == 0.0 { 0.0 } else { at.y / depth };
    let ground = LOW.lerp(HIGH, smooth_step(up, -0.4, 0.6));
    let veiled = ground.lerp(VEIL, rim * rim);
    let lit = veiled + GLOW * (2.0 / (depth + 1.5));
    let dusty = screen(overlay(lit, hue(front, 0.7, 0.9)), DUST);
    let [u, _] = point.uv;
    dusty.lerp(lit, fraction(u)).extend(1.0)
}
