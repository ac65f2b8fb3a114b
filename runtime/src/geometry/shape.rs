//! The shapes of objects, and the surface at a hit.

use std::sync::Arc;

use glam::DVec3;

use super::mesh::Mesh;
use super::primitive::{Primitive, RawHit};
use super::sphere::Sphere;
use super::vector::{double, single, unit};

/// The shape of an object.
#[derive(Clone, Debug)]
pub enum Shape {
    /// One sphere, in world space.
    Sphere(Sphere),
    /// A mesh, its normals in world space.
    Mesh(Arc<Mesh>),
}

/// The surface where a ray met it, as seen from outside: not yet turned to the ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// The point.
    pub point: [f32; 3],
    /// The same point in double precision: rays that leave it start here.
    pub position: DVec3,
    /// Unit geometric normal, outwards.
    pub normal_geom: [f32; 3],
    /// Unit shading normal, in the hemisphere of the geometric one.
    pub normal: [f32; 3],
    /// Surface coordinates.
    pub uv: [f32; 2],
}

impl Surface {
    /// Works out the surface where the ray, by its origin and direction, met `primitive`, number
    /// `number` of an object of `shape`; its coordinates are 0 unless `coordinates` are wanted.
    pub fn at(
        (origin, direction): (DVec3, DVec3),
        hit: &RawHit,
        primitive: &Primitive,
        shape: &Shape,
        number: u32,
        coordinates: bool,
    ) -> Self {
        match primitive {
            Primitive::Sphere(sphere) => {
                let (point, normal) = sphere.point(origin, direction, hit.t);
                let normal = single(normal);
                Surface {
                    point: single(point),
                    position: point,
                    normal_geom: normal,
                    normal,
                    uv: if coordinates { sphere_coordinates(normal) } else { [0.0; 2] },
                }
            }
            Primitive::Triangle(vertices) => {
                let [a, b, c] = vertices.map(double);
                let weights = [1.0 - hit.b1 - hit.b2, hit.b1, hit.b2];
                let point = a * weights[0] + b * weights[1] + c * weights[2];
                let normal_geom = unit((b - a).cross(c - a)).unwrap_or(-direction);
                let normal = match shape {
                    Shape::Mesh(mesh) => mesh.normal(number, weights, normal_geom),
                    Shape::Sphere(_) => normal_geom,
                };
                let uv = match shape {
                    _ if !coordinates => [0.0; 2],
                    Shape::Mesh(mesh) => mesh.coordinates(number, weights),
                    Shape::Sphere(_) => [hit.b1 as f32, hit.b2 as f32],
                };
                Surface {
                    point: single(point),
                    position: point,
                    normal_geom: single(normal_geom),
                    normal: single(normal),
                    uv,
                }
            }
        }
    }
}

/// Longitude from -z by way of -x, and latitude from -y up, both in 0..=1: a picture wrapped round has
/// its middle at +z and, seen from outside with +y up, stands upright and is not mirrored.
fn sphere_coordinates([x, y, z]: [f32; 3]) -> [f32; 2] {
    use std::f32::consts::{PI, TAU};
    [(x.atan2(z) / TAU + 0.5).clamp(0.0, 1.0), (-y.clamp(-1.0, 1.0)).acos() / PI]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_on_a_sphere_stands_upright_and_is_not_mirrored() {
        let middle = sphere_coordinates([0.0, 0.0, 1.0]);
        assert_eq!(middle, [0.5, 0.5]);
        let [right, _] = sphere_coordinates([0.6, 0.0, 0.8]);
        let [_, above] = sphere_coordinates([0.0, 0.6, 0.8]);
        assert!(right > middle[0] && above > middle[1]);
        for y in [-1.0, 1.0, 1.000_000_1] {
            assert!(sphere_coordinates([0.0, y, -0.0]).iter().all(|x| (0.0..=1.0).contains(x)));
        }
        for x in [-0.0, 0.0, -1e-45, 1e-45] {
            let [seam, _] = sphere_coordinates([x, 0.0, -1.0]);
            assert!(seam == 0.0 || seam == 1.0, "{x}: {seam}");
        }
    }
}
