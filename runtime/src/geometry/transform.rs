//! Affine transforms from object to world space.

use glam::{DMat3, DVec3};

/// An affine map from object to world space, in f64.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// Rotation, scale and shear.
    pub linear: DMat3,
    /// Translation, applied last.
    pub translation: DVec3,
}

impl Default for Transform {
    fn default() -> Self {
        Self { linear: DMat3::IDENTITY, translation: DVec3::ZERO }
    }
}

impl Transform {
    /// Scales by `scale`, then rotates by `degrees` about x, then y, then z, then translates.
    pub fn new(scale: [f64; 3], degrees: [f64; 3], translation: [f64; 3]) -> Self {
        let [x, y, z] = degrees.map(exact_rotation);
        let about_x =
            DMat3::from_cols(DVec3::X, DVec3::new(0.0, x.1, x.0), DVec3::new(0.0, -x.0, x.1));
        let about_y =
            DMat3::from_cols(DVec3::new(y.1, 0.0, -y.0), DVec3::Y, DVec3::new(y.0, 0.0, y.1));
        let about_z =
            DMat3::from_cols(DVec3::new(z.1, z.0, 0.0), DVec3::new(-z.0, z.1, 0.0), DVec3::Z);
        let linear = about_z * about_y * about_x * DMat3::from_diagonal(DVec3::from(scale));
        Self { linear, translation: DVec3::from(translation) }
    }

    /// The map with these rows; the fourth column is the translation.
    pub fn from_rows(rows: [[f64; 4]; 3]) -> Self {
        let column = |at: usize| DVec3::new(rows[0][at], rows[1][at], rows[2][at]);
        Self { linear: DMat3::from_cols(column(0), column(1), column(2)), translation: column(3) }
    }

    /// The map back; not of numbers for a map that flattens space.
    pub fn inverse(&self) -> Self {
        let linear = self.linear.inverse();
        Self { linear, translation: -(linear * self.translation) }
    }

    /// The map of the rows that graphs see.
    pub fn of_graph_rows(rows: &[f32; 16]) -> Self {
        let row = |at: usize| DVec3::new(rows[at].into(), rows[at + 1].into(), rows[at + 2].into());
        Self { linear: DMat3::from_cols(row(0), row(4), row(8)), translation: row(12) }
    }

    /// The rows that graphs see, rounded to 32 bits: where the axes go, then the origin.
    pub fn rows(&self) -> [f32; 16] {
        let Self { linear: DMat3 { x_axis, y_axis, z_axis }, translation } = *self;
        let rows = [(x_axis, 0.0), (y_axis, 0.0), (z_axis, 0.0), (translation, 1.0)];
        let rows = rows.map(|(row, last)| [row.x as f32, row.y as f32, row.z as f32, last]);
        let mut all = [0.0; 16];
        all.copy_from_slice(rows.as_flattened());
        all
    }

    /// Where a point goes.
    pub fn point(&self, point: DVec3) -> DVec3 {
        self.linear * point + self.translation
    }

    /// Where a normal goes, unnormalised: by the cofactor matrix, which needs no division. It keeps
    /// to the outside when the map mirrors.
    pub fn normal(&self, normal: DVec3) -> DVec3 {
        let m = self.linear;
        let cofactors = DMat3::from_cols(
            m.y_axis.cross(m.z_axis),
            m.z_axis.cross(m.x_axis),
            m.x_axis.cross(m.y_axis),
        );
        let mapped = cofactors * normal;
        if self.mirrors() { -mapped } else { mapped }
    }

    /// Whether the map turns right hands into left hands.
    pub fn mirrors(&self) -> bool {
        self.linear.determinant() < 0.0
    }

    /// Whether the map is finite and does not flatten space.
    pub fn is_regular(&self) -> bool {
        let finite = self.linear.is_finite() && self.translation.is_finite();
        let determinant = self.linear.determinant();
        finite && determinant.is_finite() && determinant != 0.0
    }

    /// The factor by which all lengths grow, where it is the same in every direction to within a
    /// millionth: then spheres stay spheres.
    pub fn uniform_scale(&self) -> Option<f64> {
        let [x, y, z] = [self.linear.x_axis, self.linear.y_axis, self.linear.z_axis];
        let scale = x.length();
        let same = |length: f64| (length - scale).abs() <= 1e-6 * scale;
        let square = |cosine: f64| cosine.abs() <= 1e-6 * scale * scale;
        let uniform = same(y.length())
            && same(z.length())
            && square(x.dot(y))
            && square(y.dot(z))
            && square(z.dot(x));
        (uniform && scale > 0.0).then_some(scale)
    }
}

/// Sine and cosine, exact at quarter turns.
fn exact_rotation(degrees: f64) -> (f64, f64) {
    let turned = degrees.rem_euclid(360.0);
    match turned {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => turned.to_radians().sin_cos(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scale_then_rotation_then_translation() {
        let transform = Transform::new([2.0; 3], [0.0, 0.0, 90.0], [1.0, 0.0, 0.0]);
        assert_eq!(transform.point(DVec3::X), DVec3::new(1.0, 2.0, 0.0));
        assert_eq!(transform.uniform_scale(), Some(2.0));
    }

    #[test]
    fn the_inverse_leads_back_and_rows_are_where_the_axes_go() {
        let transform = Transform::new([2.0, -3.0, 0.5], [10.0, 20.0, 30.0], [1.0, 2.0, 3.0]);
        let point = DVec3::new(0.3, -7.0, 4.0);
        let back = transform.inverse().point(transform.point(point));
        assert!((back - point).length() < 1e-14);
        assert_eq!(Transform::of_graph_rows(&transform.rows()).rows(), transform.rows());
        let rows = Transform::new([2.0; 3], [0.0, 0.0, 90.0], [1.0, 0.5, 0.0]).rows();
        assert_eq!(rows[..8], [0.0, 2.0, 0.0, 0.0, -2.0, 0.0, 0.0, 0.0]);
        assert_eq!(rows[8..], [0.0, 0.0, 2.0, 0.0, 1.0, 0.5, 0.0, 1.0]);
    }

    #[test]
    fn normals_stay_square_to_sheared_and_mirrored_surfaces() {
        let transform = Transform::from_rows([
            [1.0, 0.5, 0.0, 3.0],
            [0.0, 2.0, 0.0, 0.0],
            [0.3, 0.0, -1.0, 0.0],
        ]);
        let (u, v) = (DVec3::new(1.0, 2.0, 0.5), DVec3::new(-1.0, 0.3, 2.0));
        let normal = transform.normal(u.cross(v));
        assert!(normal.dot(transform.linear * u).abs() < 1e-12);
        assert!(normal.dot(transform.linear * v).abs() < 1e-12);
        assert!(transform.mirrors());
        // The outside stays the outside: a point on the normal's side stays on it.
        let outside = transform.linear * u.cross(v);
        assert!(outside.dot(normal) > 0.0);
        assert_eq!(transform.uniform_scale(), None);
    }

    #[test]
    fn flat_and_infinite_maps_are_irregular() {
        assert!(!Transform::new([1.0, 0.0, 1.0], [0.0; 3], [0.0; 3]).is_regular());
        assert!(!Transform::new([1.0; 3], [0.0; 3], [f64::NAN, 0.0, 0.0]).is_regular());
        assert!(Transform::default().is_regular());
    }
}
