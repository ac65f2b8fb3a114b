//! How the point of a surface moves with its surface coordinates.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3};

use super::barycentric::weights;
use super::mesh::Mesh;
use super::sphere::Sphere;
use super::vector::{double, single, unit};

impl Sphere {
    /// How the point moves with u and with v, at a point of the sphere: `2 pi (z, 0, -x)` and
    /// `pi (-x y / s, s, -z y / s)` with `s` the distance from the axis, (x, y, z) seen from the centre.
    /// At a pole u moves nothing, and v is taken as where u is 0.5.
    pub fn derivatives(&self, position: DVec3) -> [DVec3; 2] {
        let from_center = position - double(self.center);
        let around = DVec2::new(from_center.x, from_center.z);
        let s = around.length();
        let outwards = if s > 0.0 { around / s } else { DVec2::Y };
        let along_v = DVec3::new(-outwards.x * from_center.y, s, -outwards.y * from_center.y);
        [DVec3::new(from_center.z, 0.0, -from_center.x) * TAU, along_v * PI]
    }
}

impl Mesh {
    /// How the point moves with u and with v on triangle `number`: the edges solved for the differences
    /// of the coordinates along them. Where these do not span the plane, or not in 32 bits, two
    /// directions at right angles in the triangle, of unit length.
    pub fn derivatives(&self, number: u32) -> [DVec3; 2] {
        let indices = self.triangles[number as usize];
        let [a, b, c] = indices.map(|vertex| double(self.positions[vertex as usize]));
        let (first, second) = (b - a, c - a);
        let [ua, ub, uc] = match self.uvs.is_empty() {
            true => return [first, second],
            false => indices.map(|vertex| {
                let [u, v] = self.uvs[vertex as usize];
                DVec2::new(u.into(), v.into())
            }),
        };
        let (along_first, along_second) = (ub - ua, uc - ua);
        let determinant = along_first.perp_dot(along_second);
        let with_u = (first * along_second.y - second * along_first.y) / determinant;
        let with_v = (second * along_first.x - first * along_second.x) / determinant;
        let fits = |vector: DVec3| single(vector).iter().all(|x| x.is_finite());
        match determinant != 0.0 && fits(with_u) && fits(with_v) {
            true => [with_u, with_v],
            false => frame(unit(first.cross(second)).unwrap_or(DVec3::Z)),
        }
    }

    /// The colour between those of the corners of triangle `number`, at a point of it; white where the
    /// mesh has none.
    pub fn color(&self, number: u32, position: DVec3) -> [f32; 4] {
        if self.colors.is_empty() {
            return [1.0; 4];
        }
        let weights = self.weights(number, position);
        let indices = self.triangles[number as usize];
        let of = |at: usize| double(self.colors[indices[at] as usize]) * weights[at];
        let [r, g, b] = single(of(0) + of(1) + of(2));
        [r, g, b, 1.0]
    }

    /// The second surface coordinates at a point of triangle `number`; none where the mesh has one set.
    pub fn second_uv(&self, number: u32, position: DVec3) -> Option<[f32; 2]> {
        let corners = self.second_uvs.get(number as usize)?;
        let weights = self.weights(number, position);
        Some([0, 1].map(|axis| {
            let of = |at: usize| f64::from(corners[at][axis]) * weights[at];
            (of(0) + of(1) + of(2)) as f32
        }))
    }

    /// Barycentric weights of a point of triangle `number`; those of its middle for a point elsewhere.
    fn weights(&self, number: u32, position: DVec3) -> [f64; 3] {
        let corners = self.vertices(number as usize).map(double);
        weights(corners, position).unwrap_or([1.0 / 3.0; 3])
    }
}

/// Two unit vectors at right angles to a unit vector and to one another, without a jump but where z
/// changes its sign (Duff et al. 2017, Building an Orthonormal Basis, Revisited).
fn frame(normal: DVec3) -> [DVec3; 2] {
    let DVec3 { x, y, z } = normal;
    let sign = 1.0_f64.copysign(z);
    let a = -1.0 / (sign + z);
    let b = x * y * a;
    [DVec3::new(1.0 + sign * x * x * a, sign * b, -sign * x), DVec3::new(b, sign + y * y * a, -y)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Primitive, RawHit, Shape, Surface};

    fn close(found: DVec3, expected: DVec3) {
        assert!(
            (found - expected).length() < 1e-6 * (1.0 + expected.length()),
            "{found} {expected}"
        );
    }

    #[test]
    fn spheres_move_as_differences_of_their_coordinates_say() {
        let sphere = Sphere { center: [3.0, -1.0, 2.0], radius: 2.5 };
        let at = |direction: DVec3| {
            let origin = double(sphere.center) + direction * 9.0;
            let hit = RawHit { t: 6.5, b1: 0.0, b2: 0.0, slot: 0, inside: false };
            let surface = Surface::at(
                (origin, -direction),
                &hit,
                &Primitive::Sphere(sphere),
                &Shape::Sphere(sphere),
                0,
                true,
            );
            (surface.position, surface.uv.map(f64::from))
        };
        for direction in [[1.0, 0.2, 0.3], [-0.5, -0.8, 0.1], [0.1, 0.9, -0.4]] {
            let direction = DVec3::from(direction).normalize();
            let (position, uv) = at(direction);
            let [with_u, with_v] = sphere.derivatives(position);
            for step in [DVec3::X, DVec3::Y, DVec3::Z] {
                let (moved, to) = at((direction + step * 0.01).normalize());
                let predicted = with_u * (to[0] - uv[0]) + with_v * (to[1] - uv[1]);
                let error = (moved - position - predicted).length();
                assert!(error < 0.05 * (moved - position).length(), "{direction} {error}");
            }
        }
        // At the pole u moves nothing, and v runs along.
        let [with_u, with_v] = sphere.derivatives(double(sphere.center) + DVec3::Y * 2.5);
        assert_eq!((with_u, with_v), (DVec3::ZERO, DVec3::new(-0.0, 0.0, -2.5 * PI)));
    }

    #[test]
    fn rectangles_move_by_their_sides() {
        let mesh = Mesh::rectangle(4.0, 6.0);
        for number in 0..2 {
            let [with_u, with_v] = mesh.derivatives(number);
            close(with_u, DVec3::X * 4.0);
            close(with_v, DVec3::Z * -6.0);
        }
    }

    #[test]
    fn without_coordinates_the_edges_move_and_where_they_span_nothing_a_frame_does() {
        let mut mesh = Mesh::rectangle(2.0, 2.0);
        mesh.uvs.clear();
        assert_eq!(mesh.derivatives(0), [DVec3::Z * 2.0, DVec3::new(2.0, 0.0, 2.0)]);
        for uvs in [[[0.5, 0.5]; 4], [[0.0, 0.0], [1e-30, 0.0], [0.0, 1e-44], [0.0, 0.0]]] {
            mesh.uvs = uvs.to_vec();
            let [with_u, with_v] = mesh.derivatives(0);
            close(with_u.cross(with_v), DVec3::Y);
            assert!(with_u.dot(DVec3::Y) == 0.0 && (with_u.length() - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn colours_and_second_coordinates_lie_between_those_of_the_corners() {
        let mut mesh = Mesh::rectangle(2.0, 2.0);
        let middle = DVec3::new(-1.0 / 3.0, 0.0, 1.0 / 3.0);
        assert_eq!((mesh.color(0, middle), mesh.second_uv(0, middle)), ([1.0; 4], None));
        mesh.colors = vec![[3.0, 0.0, 0.0], [0.0, 1.5, 0.0], [0.0, 0.0, 0.75], [9.0; 3]];
        mesh.second_uvs = vec![[[0.0, 3.0], [3.0, 0.0], [0.0, 0.0]]; 2];
        assert_eq!(mesh.color(0, middle), [1.0, 0.5, 0.25, 1.0]);
        assert_eq!(mesh.second_uv(0, middle), Some([1.0, 1.0]));
        // What is not on the triangle has the mean.
        assert_eq!(mesh.color(0, DVec3::splat(7.0)), [1.0, 0.5, 0.25, 1.0]);
        let corner = DVec3::new(-1.0, 0.0, 1.0);
        assert_eq!(mesh.second_uv(0, corner), Some([3.0, 0.0]));
    }
}
