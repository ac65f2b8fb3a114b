//! Spot lights.

use glam::DVec3;

use super::arrival::{Arrival, Way, direction};

/// A light that shines from a point into a cone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    position: DVec3,
    axis: DVec3,
    /// `1 - cos` of the angle where light starts to fade, and of that where it ends.
    fading: [f64; 2],
}

impl Spot {
    /// A spot light at `position` that shines along `axis`, of any length. Its light fades from `inner` to
    /// `outer` degrees off the axis. None where the axis has no direction.
    pub fn new(position: [f64; 3], axis: [f64; 3], inner: f64, outer: f64) -> Option<Self> {
        // 1 - cos x, without the loss of digits of a difference.
        let fading = [inner, outer].map(|angle| 2.0 * (angle.to_radians() * 0.5).sin().powi(2));
        Some(Self { position: DVec3::from(position), axis: direction(axis)?, fading })
    }

    #[inline]
    pub(super) fn arrival(&self, point: DVec3) -> Option<Arrival> {
        let way = Way::between(point, self.position)?;
        // 1 - cos of the angle between the axis and the way the light takes.
        let off = (self.axis + way.direction).length_squared() * 0.5;
        let [inner, outer] = self.fading;
        let share = if off < inner {
            1.0
        } else {
            let within = ((outer - off) / (outer - inner)).clamp(0.0, 1.0);
            within * within * (3.0 - 2.0 * within)
        };
        (share > 0.0).then(|| Arrival::from_place(self.position, way, share))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The share of light that arrives so many degrees off the axis.
    fn share(spot: &Spot, angle: f64) -> f64 {
        let (sine, cosine) = angle.to_radians().sin_cos();
        spot.arrival(DVec3::new(3.0 * sine, -3.0 * cosine, 0.0)).map_or(0.0, |it| it.share)
    }

    #[test]
    fn light_fades_between_the_two_angles() {
        let spot = Spot::new([0.0; 3], [0.0, -7.0, 0.0], 20.0, 40.0).unwrap();
        assert_eq!([0.0, 10.0, 19.999].map(|angle| share(&spot, angle)), [1.0; 3]);
        assert_eq!([40.001, 90.0, 180.0].map(|angle| share(&spot, angle)), [0.0; 3]);
        // Half of it where the cosine lies in the middle.
        let middle = ((20.0_f64.to_radians().cos() + 40.0_f64.to_radians().cos()) / 2.0).acos();
        assert!((share(&spot, middle.to_degrees()) - 0.5).abs() < 1e-12);
        let shares: Vec<f64> =
            (0..100).map(|at| share(&spot, 20.0 + 0.2 * f64::from(at))).collect();
        assert!(shares.is_sorted_by(|a, b| a >= b));
    }

    #[test]
    fn hard_edges_narrow_cones_and_whole_spheres_of_light_are_sharp() {
        let hard = Spot::new([0.0; 3], [0.0, -1.0, 0.0], 30.0, 30.0).unwrap();
        assert_eq!([29.999, 30.001].map(|angle| share(&hard, angle)), [1.0, 0.0]);
        let narrow = Spot::new([0.0; 3], [0.0, -1.0, 0.0], 0.0, 1e-3).unwrap();
        assert_eq!(share(&narrow, 0.0), 1.0);
        assert!((share(&narrow, 0.5e-3) - 0.84375).abs() < 1e-6);
        assert_eq!(share(&narrow, 1.001e-3), 0.0);
        let whole = Spot::new([0.0; 3], [0.0, -1.0, 0.0], 180.0, 180.0).unwrap();
        assert_eq!([0.0, 90.0, 179.9].map(|angle| share(&whole, angle)), [1.0; 3]);
        assert!(whole.arrival(DVec3::ZERO).is_none());
        for axis in [[0.0; 3], [f64::NAN; 3], [f64::INFINITY, 0.0, 0.0]] {
            assert_eq!(Spot::new([0.0; 3], axis, 10.0, 20.0), None);
        }
        assert!(Spot::new([0.0; 3], [0.0, 1e-300, 0.0], 10.0, 20.0).is_some());
    }
}
