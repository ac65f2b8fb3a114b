//! Whether a triangle lies before a ray or at its very start.

use glam::DVec3;

use super::ray::PreparedRay;
use super::sheared::LineHit;
use super::vector::double;

/// Unit roundoff of f64.
const U: f64 = f64::EPSILON / 2.0;

/// The plane of a triangle.
///
/// # When a point lies on it
///
/// With u = 2^-53, e and f the edges from the first vertex a, N = e × f, r = p - a:
///
/// * **The point.** Where a ray met a triangle the point is Σ wᵢ vᵢ, its weights in 0..=1 and their
///   sum 1 to within 2u (`1 - b1 - b2` is rounded twice); products and sums add 3u. So each
///   component lies within 5u max|v| of the plane's point with the exact weights, and as
///   v = p - r (+ e or f), within 5u (|p| + |r| + |e| + |f|).
/// * **Its distance.** N is computed with an error of at most 4u M, where M is the sum of the
///   absolute values of its products, componentwise; r with u |r|; the dot product adds 3u. So
///   s = N·r errs by at most Σ M 8u |r|.
///
/// A point computed on a triangle has |s| ≤ Σ M (13u |r| + 5u (|p| + |e| + |f|)); `side` takes 16u
/// of all four, the rest is room for terms in u². In units of length that is some 1e-15 of the
/// coordinates and of the triangle: two panes much closer to one another than a millionth of a
/// millionth of their size are still two.
///
/// Nothing here divides by a cosine: it is the distance of the start from the plane that is
/// compared, not the distance along the ray, so that the angle of the ray does not matter. A ray
/// meets a plane once, and that one time is its start.
struct Plane {
    corner: DVec3,
    edges: [DVec3; 2],
    normal: DVec3,
    /// Sums of the absolute values of the products `normal` is made of.
    magnitude: DVec3,
}

impl Plane {
    #[inline(always)]
    fn new(vertices: &[[f32; 3]; 3]) -> Self {
        let [a, b, c] = vertices.map(double);
        let (e, f) = (b - a, c - a);
        let (ae, af) = (e.abs(), f.abs());
        let magnitude = DVec3::new(
            ae.y * af.z + ae.z * af.y,
            ae.z * af.x + ae.x * af.z,
            ae.x * af.y + ae.y * af.x,
        );
        Self { corner: a, edges: [ae, af], normal: e.cross(f), magnitude }
    }

    /// 1 where the point lies surely on the outer side, -1 on the inner, 0 where it lies on the
    /// plane as far as arithmetic can tell.
    #[inline(always)]
    fn side(&self, point: DVec3) -> i8 {
        let from_corner = point - self.corner;
        let distance = self.normal.dot(from_corner);
        let reach = point.abs() + from_corner.abs() + self.edges[0] + self.edges[1];
        sign(distance, 16.0 * U * self.magnitude.dot(reach))
    }

    /// Whether a direction runs outwards (1), inwards (-1), or along the plane.
    #[inline(always)]
    fn heading(&self, direction: DVec3) -> i8 {
        sign(self.normal.dot(direction), 16.0 * U * self.magnitude.dot(direction.abs()))
    }
}

#[inline(always)]
fn sign(value: f64, bound: f64) -> i8 {
    i8::from(value > bound) - i8::from(value < -bound)
}

/// Where the ray meets the triangle past its start, and before its end where it has one; and whether
/// it comes from the inner side. A triangle whose plane holds the start or the end is not met there
/// (see [`Plane`]).
#[inline(always)]
pub(super) fn ahead(ray: &PreparedRay, vertices: &[[f32; 3]; 3]) -> Option<(LineHit, bool)> {
    let mut hit = ray.sheared.meet(vertices)?;
    let plane = Plane::new(vertices);
    let start = plane.side(ray.origin);
    if start == 0 {
        return None;
    }
    // The signs are surer than the distance, which errs by some 1000u of a triangle nearby.
    let heading = plane.heading(ray.direction);
    let is_ahead = if heading == 0 { hit.t > 0.0 } else { heading != start };
    if !is_ahead {
        return None;
    }
    if let Some((end, distance)) = ray.end {
        if plane.side(end) != -start {
            return None;
        }
        hit.t = hit.t.min(distance);
    }
    if hit.t <= 0.0 {
        hit.t = f64::MIN_POSITIVE;
    }
    Some((hit, start < 0))
}
