//! Spheres, met analytically.

use glam::DVec3;

/// A sphere in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its centre.
    pub center: [f32; 3],
    /// Its radius, above 0.
    pub radius: f32,
}

impl Sphere {
    /// Distances at which the ray meets the sphere, near one first, in units of the direction's
    /// length. The discriminant is formed from the ray's closest point to the centre and the near
    /// root by the stable quadratic, in f64 (Pharr et al., Physically Based Rendering 4th ed.,
    /// 6.2.2): the usual b² - 4ac loses every digit on small far spheres.
    #[inline(always)]
    pub fn roots(&self, origin: DVec3, direction: DVec3) -> Option<(f64, f64)> {
        let radius = f64::from(self.radius);
        let from_center = origin - center(self);
        let a = direction.dot(direction);
        let b = -from_center.dot(direction);
        let closest = from_center + direction * (b / a);
        let discriminant = radius * radius - closest.dot(closest);
        if !(discriminant >= 0.0 && a > 0.0) {
            return None;
        }
        let c = from_center.dot(from_center) - radius * radius;
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
        let from_center = origin + direction * t - center(self);
        let length = from_center.length();
        let normal = if length > 0.0 { from_center / length } else { -direction };
        (center(self) + normal * f64::from(self.radius), normal)
    }
}

#[inline(always)]
fn center(sphere: &Sphere) -> DVec3 {
    let [x, y, z] = sphere.center;
    DVec3::new(x.into(), y.into(), z.into())
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
