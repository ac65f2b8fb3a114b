//! What the BVH holds: triangles and spheres in world space.

use glam::DVec3;

use super::sphere::Sphere;
use super::triangle::ShearedRay;

/// A shape the BVH holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Primitive {
    /// A triangle by its vertices; counter-clockwise seen from outside.
    Triangle([[f32; 3]; 3]),
    /// A sphere.
    Sphere(Sphere),
}

/// A ray made ready for every kind of primitive.
#[derive(Clone, Copy, Debug)]
pub struct PreparedRay {
    /// Origin.
    pub origin: [f32; 3],
    /// Direction, of about unit length.
    pub direction: [f32; 3],
    sheared: ShearedRay,
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
}

impl PreparedRay {
    /// Prepares a ray. The direction must be finite and not zero.
    #[inline(always)]
    pub fn new(origin: [f32; 3], direction: [f32; 3]) -> Self {
        Self { origin, direction, sheared: ShearedRay::new(origin, direction) }
    }
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
    /// The nearest meeting at a distance above 0.
    #[inline(always)]
    pub fn nearest(&self, ray: &PreparedRay, slot: u32) -> Option<RawHit> {
        match self {
            Primitive::Triangle(vertices) => {
                let (t, b1, b2) = ray.sheared.meet(vertices)?;
                (t > 0.0).then_some(RawHit { t, b1, b2, slot })
            }
            Primitive::Sphere(sphere) => {
                let (near, far) = sphere.roots(double(ray.origin), double(ray.direction))?;
                let t = if near > 0.0 { near } else { far };
                (t > 0.0).then_some(RawHit { t, b1: 0.0, b2: 0.0, slot })
            }
        }
    }

    /// Every meeting at a distance above 0.
    #[inline(always)]
    pub fn every(&self, ray: &PreparedRay, slot: u32, mut found: impl FnMut(RawHit)) {
        match self {
            Primitive::Triangle(_) => {
                if let Some(hit) = self.nearest(ray, slot) {
                    found(hit);
                }
            }
            Primitive::Sphere(sphere) => {
                let roots = sphere.roots(double(ray.origin), double(ray.direction));
                for t in roots.map_or([0.0; 2], |(near, far)| [near, far]) {
                    if t > 0.0 {
                        found(RawHit { t, b1: 0.0, b2: 0.0, slot });
                    }
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
