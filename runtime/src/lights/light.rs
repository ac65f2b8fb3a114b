//! Lights: what they send to a point.

use std::f64::consts::PI;

use glam::DVec3;

use super::arrival::{Arrival, LightSource, Way};
use super::{Disc, Rectangle, Sphere, Spot};
use crate::geometry::{double, single};

/// A light.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Its name, by which graphs list it.
    pub name: String,
    /// Its colour times its intensity: radiant intensity of a light with a place, in the direction in which it shines
    /// most, whatever its size; irradiance of a directional one on a surface square to it.
    pub power: [f32; 3],
    /// Its shape.
    pub kind: LightKind,
}

/// Shape of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// Shines from a point, falling off with the square of the distance.
    Point {
        /// Where it is.
        position: [f32; 3],
    },
    /// Shines from infinity.
    Directional {
        /// Direction its light travels in, any length.
        direction: [f32; 3],
    },
    /// Shines from a point into a cone.
    Spot(Spot),
    /// Shines from one side of a rectangle.
    Rectangle(Rectangle),
    /// Shines from one side of a disc.
    Disc(Disc),
    /// Shines from a sphere.
    Sphere(Sphere),
    /// Shines from all around, as the environment of the scene does.
    Environment {
        /// How many samples a point takes of it.
        samples: u32,
    },
}

impl LightKind {
    /// How many samples a point takes of it: 1 of a light without extent.
    pub fn samples(&self) -> u32 {
        match self {
            LightKind::Point { .. } | LightKind::Directional { .. } | LightKind::Spot(_) => 1,
            LightKind::Rectangle(rectangle) => rectangle.samples,
            LightKind::Disc(disc) => disc.samples,
            LightKind::Sphere(sphere) => sphere.samples,
            LightKind::Environment { samples } => *samples,
        }
    }

    /// Whether it matters where on the light a sample lies.
    pub fn has_extent(&self) -> bool {
        !matches!(
            self,
            LightKind::Point { .. } | LightKind::Directional { .. } | LightKind::Spot(_)
        )
    }
}

/// Most that arrives from a light at one point, in each channel: 2^100. A light's power is
/// divided by the square of a distance that may be next to nothing; so much light saturates every
/// picture, and sums of a million of it are still finite.
pub const LIGHT_LIMIT: f32 = 1.267_650_6e30;

/// A sample of a light as a point sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSight {
    /// Unit direction from the point towards the light.
    pub direction: [f32; 3],
    /// Distance to it; none for a light at infinity.
    pub distance: Option<f64>,
    /// What arrives where nothing is in the way, were it all of the light.
    pub color: [f32; 3],
    /// Where it comes from.
    pub source: LightSource,
    /// How densely all samples of the light lie there, per steradian; infinite for a light that no ray finds.
    pub density: f32,
}

impl Light {
    /// The light as `point` sees it, or of a light with extent the place of it that lies at `at` in the unit square;
    /// none if nothing can arrive from there: it has no direction, as at its very centre, or shines to another side. What an
    /// environment shows is not known here: `Light::seen_towards`.
    #[inline]
    pub fn seen_from(&self, point: [f32; 3], at: [f64; 2]) -> Option<LightSight> {
        let point = double(point);
        match &self.kind {
            LightKind::Point { position } => {
                let place = double(*position);
                let way = Way::between(point, place)?;
                Some(self.sight(&Arrival::from_place(place, way, 1.0)))
            }
            LightKind::Directional { direction } => {
                let towards = -double(*direction);
                let length = towards.length();
                let usable = length > 0.0 && length.is_finite();
                let source = LightSource::Towards(towards.try_normalize()?);
                let (direction, distance) = (single(towards / length), None);
                let color = self.power.map(|power| saturated(power.into()));
                let density = f32::INFINITY;
                usable.then_some(LightSight { direction, distance, color, source, density })
            }
            LightKind::Spot(spot) => Some(self.sight(&spot.arrival(point)?)),
            LightKind::Rectangle(rectangle) => Some(self.sight(&rectangle.arrival(point, at)?)),
            LightKind::Disc(disc) => Some(self.sight(&disc.arrival(point, at)?)),
            LightKind::Sphere(sphere) => Some(self.sight(&sphere.arrival(point, at)?)),
            LightKind::Environment { .. } => None,
        }
    }

    /// A sample of an environment in a direction that is drawn so densely, per steradian. Its colour is that of a white
    /// one, over pi as that of all lights: under it, white that is matt is 1.
    pub(crate) fn seen_towards(&self, towards: DVec3, density: f32) -> LightSight {
        LightSight {
            direction: single(towards),
            distance: None,
            color: self.power.map(|power| saturated(f64::from(power) / (PI * f64::from(density)))),
            source: LightSource::Towards(towards),
            density: density * self.kind.samples() as f32,
        }
    }

    /// What arrives, as the point sees it.
    #[inline]
    fn sight(&self, it: &Arrival) -> LightSight {
        LightSight {
            direction: single(it.direction),
            distance: Some(it.distance),
            color: self.power.map(|power| saturated(f64::from(power) * it.share / it.over)),
            source: LightSource::At(it.place),
            density: f32::INFINITY,
        }
    }
}

/// Light of a colour through a glass of another, which is no light where it is negative or no number.
pub(crate) fn tinted(light: [f32; 3], by: [f32; 4]) -> [f32; 3] {
    std::array::from_fn(|k| match f64::from(by[k]) {
        by if by > 0.0 => saturated(f64::from(light[k]) * by.min(f64::from(f32::MAX))),
        _ => 0.0,
    })
}

/// At most the limit, of either sign.
fn saturated(light: f64) -> f32 {
    let limit = f64::from(LIGHT_LIMIT);
    light.clamp(-limit, limit) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn point_lights_fall_off_with_the_square() {
        let kind = LightKind::Point { position: [0.0, 2.0, 0.0] };
        let light = Light { name: "key".into(), power: [4.0, 8.0, 0.0], kind };
        let sight = light.seen_from([0.0; 3], [0.5; 2]).unwrap();
        assert_eq!(sight.color, [1.0, 2.0, 0.0]);
        assert_eq!((sight.direction, sight.distance), ([0.0, 1.0, 0.0], Some(2.0)));
        assert_eq!(light.seen_from([0.0, 2.0, 0.0], [0.5; 2]), None);
        assert_eq!(light.seen_from([f32::NAN; 3], [0.5; 2]), None);
    }

    #[test]
    fn directional_lights_come_from_behind_their_direction() {
        let kind = LightKind::Directional { direction: [0.0, -2.0, 0.0] };
        let mut light = Light { name: "sun".into(), power: [1.0; 3], kind };
        let sight = light.seen_from([5.0; 3], [0.5; 2]).unwrap();
        assert_eq!((sight.direction, sight.distance), ([0.0, 1.0, 0.0], None));
        light.kind = LightKind::Directional { direction: [0.0; 3] };
        assert_eq!(light.seen_from([5.0; 3], [0.5; 2]), None);
    }
}
