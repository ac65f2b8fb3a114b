//! What the BVH holds: triangles and spheres in world space.

use glam::DVec3;

use super::sphere::Sphere;
use super::triangle::{ShearedRay, ahead};

/// A shape the BVH holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Primitive {
    /// A triangle by its vertices; counter-clockwise seen from outside.
    Triangle([[f32; 3]; 3]),
    /// A sphere.
    Sphere(Sphere),
}

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

/// Where a ray meets a primitive, before anything about the surface is worked out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RawHit {
    /// Distance.
    pub t: f64,
    /// Barycentric weight of the second vertex; 0 on spheres.
    pub b1: f64,
    /// Barycentric weight of the third vertex; 0 on spheres.
    pub b2: f64,
    /// Position of the primitive in the tree.
    pub slot: u32,
    /// Whether the ray comes from the inner side.
    pub inside: bool,
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

/// A vector in double precision.
#[inline(always)]
pub fn double(v: [f32; 3]) -> DVec3 {
    DVec3::new(v[0].into(), v[1].into(), v[2].into())
}

/// A vector rounded to single precision.
#[inline(always)]
pub fn single(v: DVec3) -> [f32; 3] {
    [v.x as f32, v.y as f32, v.z as f32]
}

impl Primitive {
    /// The nearest meeting past the ray's start and before its end.
    #[inline(always)]
    pub fn nearest(&self, ray: &PreparedRay, slot: u32) -> Option<RawHit> {
        match self {
            Primitive::Triangle(vertices) => {
                let (hit, inside) = ahead(ray, vertices)?;
                Some(RawHit { t: hit.t, b1: hit.b1, b2: hit.b2, slot, inside })
            }
            Primitive::Sphere(sphere) => {
                let (t, inside) = sphere.ahead(ray).into_iter().flatten().next()?;
                Some(RawHit { t, b1: 0.0, b2: 0.0, slot, inside })
            }
        }
    }

    /// Every meeting past the ray's start and before its end.
    #[inline(always)]
    pub fn every(&self, ray: &PreparedRay, slot: u32, mut found: impl FnMut(RawHit)) {
        match self {
            Primitive::Triangle(_) => {
                if let Some(hit) = self.nearest(ray, slot) {
                    found(hit);
                }
            }
            Primitive::Sphere(sphere) => {
                for (t, inside) in sphere.ahead(ray).into_iter().flatten() {
                    found(RawHit { t, b1: 0.0, b2: 0.0, slot, inside });
                }
            }
        }
    }

    /// Corners of a box that holds it.
    pub fn bounds(&self) -> ([f32; 3], [f32; 3]) {
        match self {
            Primitive::Triangle([a, b, c]) => {
                let axis = |pick: fn(f32, f32) -> f32| {
                    [0, 1, 2].map(|k: usize| pick(pick(a[k], b[k]), c[k]))
                };
                (axis(f32::min), axis(f32::max))
            }
            Primitive::Sphere(sphere) => {
                let low = sphere.center.map(|x| (x - sphere.radius).next_down());
                (low, sphere.center.map(|x| (x + sphere.radius).next_up()))
            }
        }
    }
}
