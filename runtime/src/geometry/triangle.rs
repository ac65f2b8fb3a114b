//! The watertight ray-triangle test of Woop, Benthin and Wald (JCGT 2013).
//!
//! The ray is sheared onto an axis and the signs of three 2-D edge functions decide. Each vertex is
//! sheared the same way in every triangle it belongs to, and `a*b - c*d` has the right sign or is 0
//! in floating point, with 0 counted as inside: no ray slips between triangles that share an edge
//! or a vertex. All of it runs in f64 (the paper falls back to f64 where an edge function is 0 in
//! f32), which also leaves a distance precise enough to order close surfaces.

/// A ray made ready for the test.
#[derive(Clone, Copy, Debug)]
pub struct ShearedRay {
    axes: [usize; 3],
    /// Origin, its components in the order of `axes`.
    origin: [f64; 3],
    shear: [f64; 3],
}

impl ShearedRay {
    /// Prepares the ray; the direction is not zero.
    #[inline(always)]
    pub fn new(origin: [f32; 3], direction: [f32; 3]) -> Self {
        let [x, y, z] = direction.map(f32::abs);
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
        let along = f64::from(direction[kz]);
        Self {
            axes: [kx, ky, kz],
            origin: [origin[kx].into(), origin[ky].into(), origin[kz].into()],
            shear: [
                f64::from(direction[kx]) / along,
                f64::from(direction[ky]) / along,
                1.0 / along,
            ],
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

    /// Distance (in units of the direction's length) and the barycentric weights of the second and
    /// third vertex, where the ray's line meets the triangle from either side.
    #[inline(always)]
    pub fn meet(&self, vertices: &[[f32; 3]; 3]) -> Option<(f64, f64, f64)> {
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
        Some((t, v / determinant, w / determinant))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: [[f32; 3]; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

    #[test]
    fn met_from_both_sides_with_weights() {
        let (t, b, c) = ShearedRay::new([0.25, 0.5, 2.0], [0.0, 0.0, -1.0]).meet(&UNIT).unwrap();
        assert_eq!((t, b, c), (2.0, 0.25, 0.5));
        let (t, b, c) = ShearedRay::new([0.25, 0.5, -2.0], [0.0, 0.0, 1.0]).meet(&UNIT).unwrap();
        assert_eq!((t, b, c), (2.0, 0.25, 0.5));
    }

    #[test]
    fn edges_and_corners_belong_to_it() {
        for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.5, 0.5), (0.5, 0.0), (0.0, 0.5)] {
            let ray = ShearedRay::new([x, y, 1.0], [0.0, 0.0, -1.0]);
            assert!(ray.meet(&UNIT).is_some(), "{x} {y}");
        }
    }

    #[test]
    fn edge_on_and_flat_triangles_are_missed() {
        assert!(ShearedRay::new([-1.0, 0.2, 0.0], [1.0, 0.0, 0.0]).meet(&UNIT).is_none());
        let flat = [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]];
        assert!(ShearedRay::new([1.0, 0.0, 1.0], [0.0, 0.0, -1.0]).meet(&flat).is_none());
    }

    #[test]
    fn negative_zero_in_the_direction_changes_nothing() {
        let plus = ShearedRay::new([0.25, 0.25, 1.0], [0.0, 0.0, -1.0]).meet(&UNIT);
        let minus = ShearedRay::new([0.25, 0.25, 1.0], [-0.0, -0.0, -1.0]).meet(&UNIT);
        assert_eq!(plus, minus);
    }
}
