//! Instances, and the surface at a hit.

use std::sync::Arc;

use glam::DVec3;

use super::primitive::{PreparedRay, Primitive, RawHit, double, single};
use super::{Mesh, coordinate_error};

/// What an instance is made of.
#[derive(Clone, Debug)]
pub enum Shape {
    /// One sphere.
    Sphere,
    /// A mesh, its normals in world space.
    Mesh(Arc<Mesh>),
}

/// An object placed in the scene.
#[derive(Clone, Debug)]
pub struct Instance {
    /// Its shape.
    pub shape: Shape,
    /// Position of its material.
    pub material: u32,
}

/// The surface where a ray met it, as seen from outside: not yet turned to the ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// The point.
    pub point: [f32; 3],
    /// Bound on the error of each component of `point`.
    pub error: [f32; 3],
    /// Unit geometric normal, outwards.
    pub normal_geom: [f32; 3],
    /// Unit shading normal, in the hemisphere of the geometric one.
    pub normal: [f32; 3],
    /// Surface coordinates.
    pub uv: [f32; 2],
}

impl Surface {
    /// Works out the surface at `hit` of `primitive`, number `number` of an instance of `shape`.
    pub fn at(
        ray: &PreparedRay,
        hit: &RawHit,
        primitive: &Primitive,
        shape: &Shape,
        number: u32,
    ) -> Self {
        match primitive {
            Primitive::Sphere(sphere) => {
                let (point, normal) =
                    sphere.point(double(ray.origin), double(ray.direction), hit.t);
                let magnitude = |k: usize| f64::from(sphere.center[k].abs() + sphere.radius);
                let normal = single(normal);
                Surface {
                    point: single(point),
                    error: [0, 1, 2].map(|k| coordinate_error(point[k], magnitude(k))),
                    normal_geom: normal,
                    normal,
                    uv: sphere_coordinates(normal),
                }
            }
            Primitive::Triangle(vertices) => {
                let [a, b, c] = vertices.map(double);
                let weights = [1.0 - hit.b1 - hit.b2, hit.b1, hit.b2];
                let point = a * weights[0] + b * weights[1] + c * weights[2];
                let magnitude = a.abs() + b.abs() + c.abs();
                let normal_geom = unit((b - a).cross(c - a)).unwrap_or(-double(ray.direction));
                let (normal, uv) = match shape {
                    Shape::Mesh(mesh) => mesh.attributes(number, weights, normal_geom),
                    Shape::Sphere => (normal_geom, [hit.b1 as f32, hit.b2 as f32]),
                };
                Surface {
                    point: single(point),
                    error: [0, 1, 2].map(|k| coordinate_error(point[k], magnitude[k])),
                    normal_geom: single(normal_geom),
                    normal: single(normal),
                    uv,
                }
            }
        }
    }
}

/// The vector made unit; none if it is zero or not finite.
pub(super) fn unit(v: DVec3) -> Option<DVec3> {
    let length = v.length();
    (length > 0.0 && length.is_finite()).then(|| v / length)
}

/// Longitude from +x towards +z and latitude from +y down, both in 0..=1.
fn sphere_coordinates(normal: [f32; 3]) -> [f32; 2] {
    use std::f32::consts::{PI, TAU};
    let longitude = normal[2].atan2(normal[0]) / TAU;
    let longitude = if longitude < 0.0 { longitude + 1.0 } else { longitude };
    [longitude, normal[1].clamp(-1.0, 1.0).acos() / PI]
}
