//! Rectangle lights.

use glam::DVec3;

use super::arrival::{Arrival, Way, direction};

/// Below it a solid angle, a difference of arcs, has too few digits left, and the light is far enough off
/// that samples even by area serve as well.
const SMALLEST_SOLID_ANGLE: f64 = 1e-6;

/// Sine of the least angle between `up` and the normal.
const LEAST_TURN: f64 = 1e-6;

/// A light that shines from one side of a rectangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle {
    center: DVec3,
    normal: DVec3,
    /// Unit directions of its width and of its height.
    axes: [DVec3; 2],
    /// Half of its width and of its height.
    half: [f64; 2],
    /// How many samples a point takes of it.
    pub(super) samples: u32,
}

impl Rectangle {
    /// A rectangle light of so much width and height that shines to the side its `normal` points to, its height turned
    /// to `up`; both of any length. None where one of these has no direction, or both have the same.
    pub fn new(
        center: [f64; 3],
        normal: [f64; 3],
        up: [f64; 3],
        size: [f64; 2],
        samples: u32,
    ) -> Option<Self> {
        let (normal, up) = (direction(normal)?, direction(up)?);
        let across = up.cross(normal);
        let turn = across.length();
        if turn < LEAST_TURN {
            return None;
        }
        let across = across / turn;
        let axes = [across, normal.cross(across)];
        let half = size.map(|length| length * 0.5);
        Some(Self { center: DVec3::from(center), normal, axes, half, samples })
    }

    /// A sample of the rectangle, evenly by solid angle where that has digits enough, else by area. None where
    /// its back is seen, or its edge.
    #[inline]
    pub(super) fn arrival(&self, point: DVec3, [u, v]: [f64; 2]) -> Option<Arrival> {
        let towards = self.center - point;
        let height = -towards.dot(self.normal);
        if !(height > 0.0 && height.is_finite()) {
            return None;
        }
        let middle = self.axes.map(|axis| towards.dot(axis));
        let [width, depth] =
            [0, 1].map(|at| [middle[at] - self.half[at], middle[at] + self.half[at]]);
        let seen = Seen::new(width, depth, height);
        if seen.solid_angle > SMALLEST_SOLID_ANGLE {
            let [x, y] = seen.place([u, v]);
            let place =
                self.center + self.axes[0] * (x - middle[0]) + self.axes[1] * (y - middle[1]);
            let way = Way::between(point, place)?;
            let (share, over) = (seen.solid_angle, 4.0 * self.half[0] * self.half[1]);
            let Way { direction, distance, .. } = way;
            return Some(Arrival { direction, distance, place, share, over });
        }
        let [x, y] = [self.half[0] * (2.0 * u - 1.0), self.half[1] * (2.0 * v - 1.0)];
        let place = self.center + self.axes[0] * x + self.axes[1] * y;
        let way = Way::between(point, place)?;
        let cosine = height / way.distance;
        Some(Arrival::from_place(place, way, cosine.min(1.0)))
    }
}

/// A rectangle as a point `height` above its plane sees it, which is the origin: from `x[0]` to `x[1]` and from
/// `y[0]` to `y[1]`.
///
/// Ureña, Fajardo, King, An Area-Preserving Parametrization for Spherical Rectangles, 2013, with the angles
/// at the corners taken from arc tangents in place of arc cosines, which lose half of the digits next to the plane.
struct Seen {
    x: [f64; 2],
    y: [f64; 2],
    height: f64,
    solid_angle: f64,
    /// The angle at which the first of the rectangle's sides lies.
    first: f64,
}

impl Seen {
    #[inline]
    fn new(x: [f64; 2], y: [f64; 2], height: f64) -> Self {
        // Between the axis and the corner at (x, y).
        let corner =
            |x: f64, y: f64| (x * y).atan2(height * (x * x + y * y + height * height).sqrt());
        let side = |x: f64| corner(x, y[1]) - corner(x, y[0]);
        let (first, last) = (side(x[0]), side(x[1]));
        Self { x, y, height, solid_angle: last - first, first }
    }

    /// The place in the rectangle at a place in the unit square.
    #[inline]
    fn place(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        let Self { x, y, height, .. } = *self;
        let [low, high] = y.map(|y| y / y.hypot(height));
        let (sine, cosine) = (u * self.solid_angle + self.first).sin_cos();
        let slope = (high - low * cosine) / sine;
        let across = slope.signum() / (slope * slope + low * low).sqrt();
        let at = across * height / (1.0 - across * across).max(0.0).sqrt();
        // Where all digits are lost, the middle is as good a place as any.
        let at = if at.is_nan() { 0.5 * (x[0] + x[1]) } else { at.clamp(x[0], x[1]) };
        let distance = at.hypot(height);
        let [low, high] = y.map(|y| y / y.hypot(distance));
        let up = low + v * (high - low);
        let up = up * distance / (1.0 - up * up).max(f64::MIN_POSITIVE).sqrt();
        [at, up.clamp(y[0], y[1])]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::light_position;

    const DOWN: [f64; 3] = [0.0, -1.0, 0.0];
    const FAR: [f64; 3] = [0.0, 0.0, -1.0];

    /// The mean of what arrives, times the cosine at a surface that faces up, over so many samples.
    fn irradiance(light: &Rectangle, point: DVec3, samples: u32) -> f64 {
        let each = (0..samples).map(|sample| {
            let it = light.arrival(point, light_position(11, 0, sample)).unwrap();
            assert!(it.share >= 0.0 && it.share.is_finite() && it.distance > 0.0);
            it.share / it.over * it.direction.y.max(0.0)
        });
        each.sum::<f64>() / f64::from(samples)
    }

    /// The same over a grid of the area.
    fn by_area(light: &Rectangle, point: DVec3) -> f64 {
        let steps = 400;
        let mut sum = 0.0;
        for (row, column) in (0..steps).flat_map(|row| (0..steps).map(move |column| (row, column)))
        {
            let [x, y] =
                [column, row].map(|at| (f64::from(at) + 0.5) / f64::from(steps) * 2.0 - 1.0);
            let place = light.center
                + light.axes[0] * (x * light.half[0])
                + light.axes[1] * (y * light.half[1]);
            let way = Way::between(point, place).unwrap();
            let cosine = -way.direction.dot(light.normal);
            sum += cosine.max(0.0) * way.direction.y.max(0.0) / way.squared;
        }
        sum / f64::from(steps * steps)
    }

    #[test]
    fn samples_by_solid_angle_agree_with_an_integral_over_the_area() {
        for (size, point) in [
            ([2.0, 1.0], DVec3::new(0.0, 0.0, 0.0)),
            ([2.0, 1.0], DVec3::new(3.0, -1.0, 2.0)),
            ([40.0, 0.1], DVec3::new(-5.0, 0.5, 0.01)),
            ([0.01, 0.02], DVec3::new(1.0, 0.0, -4.0)),
            ([8.0, 8.0], DVec3::new(1.0, 1.7, 1.0)),
            ([8.0, 8.0], DVec3::new(30.0, 1.9, 1.0)),
        ] {
            let light = Rectangle::new([0.0, 2.0, 0.0], DOWN, FAR, size, 1).unwrap();
            let (sampled, expected) = (irradiance(&light, point, 4096), by_area(&light, point));
            assert!(
                (sampled / expected - 1.0).abs() < 4e-3,
                "{size:?} {point}: {sampled} {expected}"
            );
        }
    }

    #[test]
    fn samples_are_even_by_solid_angle_and_lie_in_the_rectangle() {
        // A face of a cube as seen from its middle: a sixth of all directions.
        let seen = Seen::new([-1.0, 1.0], [-1.0, 1.0], 1.0);
        assert!((seen.solid_angle - 4.0 * std::f64::consts::PI / 6.0).abs() < 1e-14);
        let mut quarters = [0; 4];
        for sample in 0..1024 {
            let [x, y] = seen.place(light_position(2, 0, sample));
            assert!(x.abs() <= 1.0 && y.abs() <= 1.0);
            quarters[usize::from(x > 0.0) * 2 + usize::from(y > 0.0)] += 1;
        }
        assert!(quarters.iter().all(|count| (count - 256_i32).abs() <= 8), "{quarters:?}");
    }

    #[test]
    fn solid_angles_keep_their_digits_next_to_the_plane_and_far_away() {
        // To first order in the height, a corner lies at pi / 2 - height d / (x y).
        let slope = |x: f64, y: f64| x.hypot(y) / (x * y);
        let expected = slope(1.0, 2.0) * 2.0 - slope(1.0, 1.0) - slope(2.0, 2.0);
        for height in [1e-3, 1e-5, 1e-7] {
            let seen = Seen::new([1.0, 2.0], [1.0, 2.0], height);
            assert!((seen.solid_angle / height - expected).abs() < 1e-5, "{height}");
        }
        for distance in [10.0, 1e2, 1e3] {
            let seen = Seen::new([-0.5, 0.5], [-0.5, 0.5], distance);
            let relative = seen.solid_angle * distance * distance - 1.0;
            assert!(relative.abs() < 0.6 / (distance * distance) + 1e-9, "{distance}: {relative}");
        }
    }

    #[test]
    fn light_of_any_size_is_finite_from_anywhere_before_it() {
        let sizes =
            [[0.0, 0.0], [1.0, 0.0], [1e-12, 1e-12], [1e12, 1e12], [1e12, 1e-12], [3.0, 2.0]];
        for size in sizes {
            let light = Rectangle::new([0.0; 3], DOWN, FAR, size, 4).unwrap();
            for x in [0.0, 0.5 * size[0], 1e-6, 1.0, 1e6, 1e12] {
                for y in [-1e-40, -1e-12, -1e-3, -1.0, -1e12] {
                    for sample in 0..4 {
                        let point = DVec3::new(x, y, 0.0);
                        let Some(it) = light.arrival(point, light_position(3, 1, sample)) else {
                            continue;
                        };
                        let arrives = it.share / it.over;
                        assert!(arrives >= 0.0 && arrives.is_finite(), "{size:?} {point} {it:?}");
                        assert!(it.place.is_finite() && it.direction.is_normalized());
                        let off = it.place.abs();
                        assert!(
                            off.x <= 0.5001 * size[0] && off.z <= 0.5001 * size[1],
                            "{size:?} {off}"
                        );
                    }
                }
                assert!(light.arrival(DVec3::new(x, 0.0, 0.0), [0.5; 2]).is_none());
                assert!(light.arrival(DVec3::new(x, 1.0, 0.0), [0.5; 2]).is_none());
            }
        }
        assert_eq!(Rectangle::new([0.0; 3], DOWN, [0.0, 5.0, 0.0], [1.0; 2], 1), None);
        assert_eq!(Rectangle::new([0.0; 3], [0.0; 3], FAR, [1.0; 2], 1), None);
    }
}
