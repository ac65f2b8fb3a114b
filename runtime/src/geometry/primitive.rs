//! What the BVH holds: triangles and spheres in world space.

use super::ray::PreparedRay;
use super::sphere::Sphere;
use super::triangle::ahead;

/// A shape the BVH holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Primitive {
    /// A triangle by its vertices; counter-clockwise seen from outside.
    Triangle([[f32; 3]; 3]),
    /// A sphere.
    Sphere(Sphere),
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
