//! Rays made ready for whatever they may meet.

use glam::DVec3;

use super::sheared::ShearedRay;
use super::vector::double;

/// A ray made ready for every kind of primitive.
///
/// It meets what lies past its start and, if it has one, before its end: a surface that passes
/// through the start or the end, as far as arithmetic can tell, is not met there. So a ray that
/// leaves a surface does not meet that surface again where it starts, whatever the angle, nor any
/// other in the same place; and what a light touches does not shadow it.
#[derive(Clone, Copy, Debug)]
pub struct PreparedRay {
    /// Where it starts.
    pub origin: DVec3,
    /// Direction, of about unit length.
    pub direction: DVec3,
    /// The normal of the surface it leaves, on the side it leaves to; zero for other rays.
    pub(super) side: DVec3,
    /// Where it ends, and the distance there.
    pub(super) end: Option<(DVec3, f64)>,
    pub(super) sheared: ShearedRay,
}

impl PreparedRay {
    /// A ray from a point in space. The direction must be finite and not zero.
    #[inline(always)]
    pub fn new(origin: [f32; 3], direction: [f32; 3]) -> Self {
        Self::between(double(origin), double(direction), DVec3::ZERO, None)
    }

    /// A ray that leaves a surface at a point known in double precision. `normal` is that of the
    /// surface, of any length; the ray leaves to the side its direction points to.
    #[inline(always)]
    pub fn leaving(point: DVec3, normal: [f32; 3], direction: DVec3) -> Self {
        Self::between(point, direction, to_side(normal, direction), None)
    }

    /// A ray from a point of a surface to another point. None where they are the same or too far
    /// apart.
    #[inline(always)]
    pub fn to(point: DVec3, normal: [f32; 3], end: DVec3) -> Option<Self> {
        let towards = end - point;
        let distance = towards.length();
        if !(distance > 0.0 && distance.is_finite()) {
            return None;
        }
        let direction = towards / distance;
        let side = to_side(normal, direction);
        Some(Self::between(point, direction, side, Some((end, distance))))
    }

    #[inline(always)]
    fn between(origin: DVec3, direction: DVec3, side: DVec3, end: Option<(DVec3, f64)>) -> Self {
        Self { origin, direction, side, end, sheared: ShearedRay::new(origin, direction) }
    }

    /// How far it reaches.
    #[inline(always)]
    pub fn reach(&self) -> f64 {
        self.end.map_or(f64::INFINITY, |(_, distance)| distance)
    }
}

/// The normal turned to the side a direction points to.
#[inline(always)]
fn to_side(normal: [f32; 3], direction: DVec3) -> DVec3 {
    let normal = double(normal);
    if normal.dot(direction) < 0.0 { -normal } else { normal }
}
