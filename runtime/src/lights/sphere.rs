//! Sphere lights.

use std::f64::consts::TAU;

use glam::DVec3;

use super::arrival::{Arrival, Way};

/// A light that shines from the outside of a sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    center: DVec3,
    radius: f64,
    /// How many samples a point takes of it.
    pub(super) samples: u32,
}

impl Sphere {
    /// A sphere light; of radius 0 it is a point light.
    pub fn new(center: [f64; 3], radius: f64, samples: u32) -> Self {
        Self { center: DVec3::from(center), radius, samples }
    }

    /// A sample of the cone in which a point sees the sphere, evenly by solid angle (Shirley, Wang, Zimmerman,
    /// Monte Carlo Techniques for Direct Lighting Calculations, 1996). None on the sphere and in it.
    ///
    /// Its radiance is the power over `pi r^2`; times the solid angle `2 pi (1 - c)`, c being the cosine at the edge of the cone,
    /// and with `1 - c = (r / d)^2 / (1 + c)`, that is the power times `2 / ((1 + c) d^2)`: nothing is
    /// lost where the cone is narrow.
    #[inline]
    pub(super) fn arrival(&self, point: DVec3, [u, v]: [f64; 2]) -> Option<Arrival> {
        let way = Way::between(point, self.center)?;
        let (distance, radius) = (way.distance, self.radius);
        if distance <= radius {
            return None;
        }
        let sine = radius / distance;
        let outside = (distance - radius) * (distance + radius);
        let edge = (outside / way.squared).sqrt().min(1.0);
        // 1 - cos between the sample and the middle.
        let off = u * sine * sine / (1.0 + edge);
        let aside = (off * (2.0 - off)).sqrt();
        let (across, up) = way.direction.any_orthonormal_pair();
        let (turned_up, turned_across) = (TAU * v).sin_cos();
        let round = across * turned_across + up * turned_up;
        let direction = (way.direction * (1.0 - off) + round * aside).normalize();
        // The nearer of the places where the ray meets the sphere.
        let half_chord = (radius * radius - (distance * aside).powi(2)).max(0.0).sqrt();
        let near = outside / (distance * (1.0 - off) + half_chord);
        let (place, share) = (point + direction * near, 2.0 / (1.0 + edge));
        Some(Arrival { direction, distance: near, place, share, over: way.squared })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::light_position;

    #[test]
    fn samples_lie_on_the_sphere_towards_the_point() {
        for (radius, distance) in
            [(1.0, 3.0), (1.0, 1.000001), (1e-6, 1e6), (1e12, 1.5e12), (0.5, 1e3)]
        {
            let center = DVec3::new(0.0, distance, 0.0);
            let sphere = Sphere::new(center.to_array(), radius, 64);
            for sample in 0..64 {
                let it = sphere.arrival(DVec3::ZERO, light_position(7, 0, sample)).unwrap();
                let out = it.place - center;
                assert!((out.length() - radius).abs() <= 1e-9 * radius + 1e-14 * distance);
                assert!(
                    out.dot(it.direction) <= 1e-6 * radius + 1e-14 * distance,
                    "the side that is seen"
                );
                assert!((it.direction.length() - 1.0).abs() < 1e-12);
                assert!(it.distance > 0.0 && it.distance <= distance);
            }
        }
    }

    #[test]
    fn what_arrives_square_to_it_is_that_of_a_point_light() {
        // Irradiance by a sphere on a surface that faces it is exactly that of a point of its intensity.
        let sphere = Sphere::new([0.0, 2.0, 0.0], 1.0, 1024);
        let sum: f64 = (0..1024)
            .map(|sample| {
                let it = sphere.arrival(DVec3::ZERO, light_position(1, 0, sample)).unwrap();
                it.share / it.over * it.direction.y
            })
            .sum();
        assert!((sum / 1024.0 - 0.25).abs() < 1e-4, "{sum}");
        let point = Sphere::new([0.0, 2.0, 0.0], 0.0, 1).arrival(DVec3::ZERO, [0.3, 0.9]).unwrap();
        assert_eq!((point.share, point.over, point.distance), (1.0, 4.0, 2.0));
        assert_eq!(point.direction, DVec3::Y);
    }

    #[test]
    fn inside_nothing_is_lit() {
        let sphere = Sphere::new([0.0; 3], 1.0, 4);
        for point in [DVec3::ZERO, DVec3::X, DVec3::splat(0.5), DVec3::NAN] {
            assert!(sphere.arrival(point, [0.5; 2]).is_none());
        }
        assert!(Sphere::new([0.0; 3], 0.0, 1).arrival(DVec3::ZERO, [0.5; 2]).is_none());
    }
}
