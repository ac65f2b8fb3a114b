//! Disc lights.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use glam::DVec3;

use super::arrival::{Arrival, Way, direction};

/// A light that shines from one side of a disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    center: DVec3,
    normal: DVec3,
    /// Two radii, square to each other.
    radii: [DVec3; 2],
    /// How many samples a point takes of it.
    pub(super) samples: u32,
}

impl Disc {
    /// A disc light that shines to the side its `normal`, of any length, points to. None where that has no direction.
    pub fn new(center: [f64; 3], normal: [f64; 3], radius: f64, samples: u32) -> Option<Self> {
        let normal = direction(normal)?;
        let (across, up) = normal.any_orthonormal_pair();
        let radii = [across * radius, up * radius];
        Some(Self { center: DVec3::from(center), normal, radii, samples })
    }

    /// A sample of the disc, evenly by area. None where its back is seen, or its edge.
    #[inline]
    pub(super) fn arrival(&self, point: DVec3, at: [f64; 2]) -> Option<Arrival> {
        let [x, y] = concentric(at);
        let place = self.center + self.radii[0] * x + self.radii[1] * y;
        let way = Way::between(point, place)?;
        let cosine = -way.direction.dot(self.normal);
        (cosine > 0.0).then(|| Arrival::from_place(place, way, cosine))
    }
}

/// From the square to the disc of radius 1, areas and neighbours kept (Shirley and Chiu, A Low Distortion Map
/// Between Disk and Square, 1997).
fn concentric([u, v]: [f64; 2]) -> [f64; 2] {
    let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    let (radius, angle) = match x.abs() > y.abs() {
        true => (x, FRAC_PI_4 * (y / x)),
        false if y == 0.0 => return [0.0; 2],
        false => (y, FRAC_PI_2 - FRAC_PI_4 * (x / y)),
    };
    let (sine, cosine) = angle.sin_cos();
    [radius * cosine, radius * sine]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::light_position;

    #[test]
    fn the_map_keeps_areas() {
        let mut within = [0; 4];
        for sample in 0..4096 {
            let [x, y] = concentric(light_position(3, 0, sample));
            let squared = x * x + y * y;
            assert!(squared < 1.0);
            within[(squared * 4.0) as usize] += 1;
        }
        assert!(within.iter().all(|count| (count - 1024_i32).abs() < 40), "{within:?}");
        assert_eq!(concentric([0.5; 2]), [0.0; 2]);
    }

    #[test]
    fn irradiance_on_the_axis_is_that_of_the_closed_form() {
        // A disc of radius r and intensity 1 at distance d: 1 / (d^2 + r^2).
        let disc = Disc::new([0.0, 2.0, 0.0], [0.0, -3.0, 0.0], 1.0, 4096).unwrap();
        let sum: f64 = (0..4096)
            .map(|sample| {
                let it = disc.arrival(DVec3::ZERO, light_position(5, 0, sample)).unwrap();
                it.share / it.over * it.direction.y
            })
            .sum();
        assert!((sum / 4096.0 - 0.2).abs() < 5e-4, "{sum}");
    }

    #[test]
    fn its_back_and_its_plane_are_dark() {
        let disc = Disc::new([0.0; 3], [0.0, -1.0, 0.0], 1.0, 4).unwrap();
        for point in [DVec3::Y, DVec3::X * 5.0, DVec3::NAN] {
            assert!(disc.arrival(point, [0.2, 0.7]).is_none());
        }
        assert!(disc.arrival(DVec3::new(5.0, -1e-9, 0.0), [0.2, 0.7]).is_some());
        assert_eq!(Disc::new([0.0; 3], [0.0; 3], 1.0, 4), None);
        let point = Disc::new([0.0; 3], [0.0, -1.0, 0.0], 0.0, 4).unwrap();
        let it = point.arrival(-DVec3::Y * 2.0, [0.2, 0.7]).unwrap();
        assert_eq!((it.share, it.over), (1.0, 4.0));
    }
}
