//! Spheres, met analytically.

use glam::DVec3;

use super::ray::PreparedRay;
use super::vector::double;

/// A sphere in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its centre.
    pub center: [f32; 3],
    /// Its radius, above 0.
    pub radius: f32,
}

/// Unit roundoff of f64.
const U: f64 = f64::EPSILON / 2.0;

/// A point as a sphere sees it.
struct Seen {
    from_center: DVec3,
    /// Distance from the surface, below 0 inside.
    gap: f64,
    /// Whether it lies on the sphere as far as arithmetic can tell.
    touches: bool,
}

impl Sphere {
    /// Where a ray meets the sphere past its start and before its end, nearest first, and whether
    /// it comes from inside there.
    ///
    /// A ray that starts on the sphere meets it once more if it leaves inwards, at 2b/a, and not at
    /// all if it leaves outwards. Which of the two it does is asked of the surface normal the ray
    /// was given, not of b: a direction that rounding bent below a grazing surface still leaves it.
    /// A ray that ends on the sphere, as one to a lamp there does, does not meet it at its end.
    ///
    /// # When a point lies on it
    ///
    /// A point on the sphere is c + r n, n unit to within 3u (u = 2^-53): product and sum put it
    /// 4u r + u |p| off, and |p - c| is known to 4u r. `seen` takes 16u r + 4u |p|₁.
    #[inline(always)]
    pub(super) fn ahead(&self, ray: &PreparedRay) -> [Option<(f64, bool)>; 2] {
        let start = self.seen(ray.origin);
        let hits = if start.touches {
            let outwards = ray.side.dot(start.from_center);
            let b = -start.from_center.dot(ray.direction);
            let far = 2.0 * b / ray.direction.length_squared();
            let meets = outwards <= 0.0 && far > 0.0;
            [meets.then_some((far, true)), None]
        } else {
            match self.roots(ray.origin, ray.direction) {
                Some((near, far)) if start.gap > 0.0 && near > 0.0 => {
                    [Some((near, false)), Some((far, true))]
                }
                Some((_, far)) if start.gap < 0.0 && far > 0.0 => [Some((far, true)), None],
                _ => [None, None],
            }
        };
        match ray.end {
            Some((end, distance)) => self.before(end, distance, ray.direction, hits),
            None => hits,
        }
    }

    /// Those of the meetings that lie before the ray's end.
    #[inline(always)]
    fn before(
        &self,
        end: DVec3,
        distance: f64,
        direction: DVec3,
        hits: [Option<(f64, bool)>; 2],
    ) -> [Option<(f64, bool)>; 2] {
        let seen = self.seen(end);
        // At an end on the sphere the ray either arrives from outside, and has met nothing yet, or
        // from inside, and has met only where it came in.
        let arrives_from_inside = seen.from_center.dot(direction) > 0.0;
        hits.map(|hit| {
            hit.filter(|&(t, inside)| match seen.touches {
                true => arrives_from_inside && !inside && t < distance,
                false => t < distance,
            })
        })
    }

    #[inline(always)]
    fn seen(&self, point: DVec3) -> Seen {
        let from_center = point - double(self.center);
        let radius = f64::from(self.radius);
        let gap = from_center.length() - radius;
        let size = point.x.abs() + point.y.abs() + point.z.abs();
        let touches = gap.abs() <= U * (16.0 * radius + 4.0 * size);
        Seen { from_center, gap, touches }
    }

    /// Distances at which the ray's line meets the sphere, near one first, in units of the
    /// direction's length. The discriminant is formed from the ray's closest point to the centre
    /// and the near root by the stable quadratic, in f64 (Pharr et al., Physically Based Rendering
    /// 4th ed., 6.2.2): the usual b² - 4ac loses every digit on small far spheres.
    #[inline(always)]
    pub fn roots(&self, origin: DVec3, direction: DVec3) -> Option<(f64, f64)> {
        let radius = f64::from(self.radius);
        let from_center = origin - double(self.center);
        let a = direction.dot(direction);
        let b = -from_center.dot(direction);
        let closest = from_center + direction * (b / a);
        let discriminant = radius * radius - closest.dot(closest);
        if !(discriminant >= 0.0 && a > 0.0) {
            return None;
        }
        // |f|² - r², without its cancellation near the surface.
        let length = from_center.length();
        let c = (length - radius) * (length + radius);
        let root = (a * discriminant).sqrt();
        let q = if b < 0.0 { b - root } else { b + root };
        if q == 0.0 {
            return None;
        }
        let (first, second) = (c / q, q / a);
        Some(if first < second { (first, second) } else { (second, first) })
    }

    /// The point of the sphere at distance `t` of the ray, put back on the sphere, and the unit
    /// normal there, outwards.
    pub fn point(&self, origin: DVec3, direction: DVec3, t: f64) -> (DVec3, DVec3) {
        let from_center = origin + direction * t - double(self.center);
        let length = from_center.length();
        let normal = if length > 0.0 { from_center / length } else { -direction };
        (double(self.center) + normal * f64::from(self.radius), normal)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn roots(
        center: [f32; 3],
        radius: f32,
        origin: [f64; 3],
        direction: [f64; 3],
    ) -> Option<(f64, f64)> {
        Sphere { center, radius }.roots(DVec3::from(origin), DVec3::from(direction))
    }

    #[test]
    fn from_outside_inside_and_behind() {
        assert_eq!(roots([0.0; 3], 1.0, [0.0, 0.0, 3.0], [0.0, 0.0, -1.0]), Some((2.0, 4.0)));
        assert_eq!(roots([0.0; 3], 1.0, [0.0, 0.0, 0.5], [0.0, 0.0, -1.0]), Some((-0.5, 1.5)));
        assert_eq!(roots([0.0; 3], 1.0, [0.0, 0.0, 3.0], [0.0, 0.0, 1.0]), Some((-4.0, -2.0)));
        assert_eq!(roots([0.0; 3], 1.0, [0.0, 1.5, 3.0], [0.0, 0.0, -1.0]), None);
    }

    #[test]
    fn a_tiny_far_sphere_is_met_precisely() {
        let (near, far) = roots([0.0; 3], 1e-3, [0.0, 0.0, 1e6], [0.0, 0.0, -1.0]).unwrap();
        assert!((near - (1e6 - 1e-3)).abs() < 1e-8, "{near}");
        assert!((far - near - 2e-3).abs() < 1e-8);
    }

    #[test]
    fn one_step_inside_the_rim_hits_and_one_outside_misses() {
        let at = |y: f32| roots([0.0; 3], 1.0, [0.0, y.into(), 10.0], [0.0, 0.0, -1.0]);
        assert!(at(1f32.next_down()).is_some());
        assert!(at(1f32.next_up()).is_none());
        let (near, far) = at(1f32.next_down()).unwrap();
        assert!(near < 10.0 && 10.0 < far && far - near < 1e-3);
    }

    #[test]
    fn zero_and_nan_directions_miss() {
        assert_eq!(roots([0.0; 3], 1.0, [0.0; 3], [0.0; 3]), None);
        assert_eq!(roots([0.0; 3], 1.0, [0.0; 3], [f64::NAN, 0.0, 1.0]), None);
    }
}
