//! The watertight ray-triangle test of Woop, Benthin and Wald (JCGT 2013).
//!
//! The ray is sheared onto an axis and the signs of three 2-D edge functions decide. Each vertex is
//! sheared the same way in every triangle it belongs to, and `a*b - c*d` has the right sign or is 0
//! in floating point, with 0 counted as inside: no ray slips between triangles that share an edge
//! or a vertex. All of it runs in f64 (the paper falls back to f64 where an edge function is 0 in
//! f32), which also leaves a distance precise enough to order close surfaces.

use glam::DVec3;

/// A ray made ready for the test.
#[derive(Clone, Copy, Debug)]
pub struct ShearedRay {
    axes: [usize; 3],
    /// Origin, its components in the order of `axes`.
    origin: [f64; 3],
    shear: [f64; 3],
}

/// Where a ray's line meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineHit {
    /// Distance, in units of the direction's length; behind the ray's origin below 0.
    pub t: f64,
    /// Barycentric weight of the second vertex.
    pub b1: f64,
    /// Barycentric weight of the third vertex.
    pub b2: f64,
}

impl ShearedRay {
    /// Prepares the ray; the direction is not zero.
    #[inline(always)]
    pub fn new(origin: DVec3, direction: DVec3) -> Self {
        let (origin, direction) = (origin.to_array(), direction.to_array());
        let [x, y, z] = direction.map(f64::abs);
        let kz = if x > y {
            if x > z { 0 } else { 2 }
        } else if y > z {
            1
        } else {
            2
        };
        let (mut kx, mut ky) = ((kz + 1) % 3, (kz + 2) % 3);
        if direction[kz] < 0.0 {
            // Keeps the winding of triangles.
            std::mem::swap(&mut kx, &mut ky);
        }
        let along = direction[kz];
        Self {
            axes: [kx, ky, kz],
            origin: [origin[kx], origin[ky], origin[kz]],
            shear: [direction[kx] / along, direction[ky] / along, 1.0 / along],
        }
    }

    /// The vertex relative to the ray: x and y across it, z along it (unscaled).
    #[inline(always)]
    fn shear(&self, vertex: &[f32; 3]) -> [f64; 3] {
        let [kx, ky, kz] = self.axes;
        let x = f64::from(vertex[kx]) - self.origin[0];
        let y = f64::from(vertex[ky]) - self.origin[1];
        let z = f64::from(vertex[kz]) - self.origin[2];
        [x - self.shear[0] * z, y - self.shear[1] * z, z]
    }

    /// Where the ray's line meets the triangle, from either side. The distance is a mean of those
    /// of the vertices by the very weights that the edge functions give, so it errs by the weights'
    /// error times the triangle's depth, not times its distance; on an edge it has the same bits
    /// for both triangles.
    #[inline(always)]
    pub fn meet(&self, vertices: &[[f32; 3]; 3]) -> Option<LineHit> {
        let [a, b, c] =
            [self.shear(&vertices[0]), self.shear(&vertices[1]), self.shear(&vertices[2])];
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        let outside = (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0);
        let determinant = u + v + w;
        if outside || determinant == 0.0 {
            return None;
        }
        let t = (u * a[2] + v * b[2] + w * c[2]) * self.shear[2] / determinant;
        Some(LineHit { t, b1: v / determinant, b2: w / determinant })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: [[f32; 3]; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

    fn meet(origin: [f64; 3], direction: [f64; 3], vertices: &[[f32; 3]; 3]) -> Option<LineHit> {
        ShearedRay::new(DVec3::from(origin), DVec3::from(direction)).meet(vertices)
    }

    #[test]
    fn met_from_both_sides_with_weights() {
        let expected = Some(LineHit { t: 2.0, b1: 0.25, b2: 0.5 });
        assert_eq!(meet([0.25, 0.5, 2.0], [0.0, 0.0, -1.0], &UNIT), expected);
        assert_eq!(meet([0.25, 0.5, -2.0], [0.0, 0.0, 1.0], &UNIT), expected);
    }

    #[test]
    fn edges_and_corners_belong_to_it() {
        for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.5, 0.5), (0.5, 0.0), (0.0, 0.5)] {
            assert!(meet([x, y, 1.0], [0.0, 0.0, -1.0], &UNIT).is_some(), "{x} {y}");
        }
    }

    #[test]
    fn edge_on_and_flat_triangles_are_missed() {
        assert!(meet([-1.0, 0.2, 0.0], [1.0, 0.0, 0.0], &UNIT).is_none());
        let flat = [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]];
        assert!(meet([1.0, 0.0, 1.0], [0.0, 0.0, -1.0], &flat).is_none());
    }

    #[test]
    fn negative_zero_in_the_direction_changes_nothing() {
        let plus = meet([0.25, 0.25, 1.0], [0.0, 0.0, -1.0], &UNIT);
        let minus = meet([0.25, 0.25, 1.0], [-0.0, -0.0, -1.0], &UNIT);
        assert_eq!(plus, minus);
    }

    #[test]
    fn a_tiny_far_triangle_has_a_precise_distance() {
        let size = 1e-6f32;
        let tiny = [[0.0, 0.0, 0.0], [size, 0.0, size], [0.0, size, 0.0]];
        let hit = meet([2e-7, 3e-7, 100.0], [0.0, 0.0, -1.0], &tiny).unwrap();
        assert!((hit.t - (100.0 - 2e-7)).abs() < 1e-13, "{}", hit.t);
    }
}
