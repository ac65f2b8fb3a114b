//! Point and directional lights.

use glam::DVec3;

use crate::geometry::{PreparedRay, double, single};

/// A light.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Its name, by which graphs list it.
    pub name: String,
    /// Its colour times its intensity: radiant intensity of a point light, irradiance of a
    /// directional one on a surface square to it.
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
}

/// Most that arrives from a light at one point, in each channel: 2^100. A point light's power is
/// divided by the square of a distance that may be next to nothing; so much light saturates every
/// picture, and sums of a million of it are still finite.
pub const LIGHT_LIMIT: f32 = 1.267_650_6e30;

/// A light as a point sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSight {
    /// Unit direction from the point towards the light.
    pub direction: [f32; 3],
    /// Distance to it; none for a light at infinity.
    pub distance: Option<f64>,
    /// What arrives where nothing is in the way.
    pub color: [f32; 3],
}

impl Light {
    /// The light as `point` sees it; none if it has no direction there, as at its very centre.
    #[inline]
    pub fn seen_from(&self, point: [f32; 3]) -> Option<LightSight> {
        match self.kind {
            LightKind::Point { position } => {
                let towards = double(position) - double(point);
                let squared = towards.length_squared();
                let distance = squared.sqrt();
                if !(distance > 0.0 && distance.is_finite()) {
                    return None;
                }
                let color = self.power.map(|power| saturated(f64::from(power) / squared));
                let direction = single(towards / distance);
                Some(LightSight { direction, distance: Some(distance), color })
            }
            LightKind::Directional { direction } => {
                let towards = -double(direction);
                let length = towards.length();
                let direction = single(towards / length);
                let usable = length > 0.0 && length.is_finite();
                let color = self.power.map(|power| saturated(power.into()));
                usable.then_some(LightSight { direction, distance: None, color })
            }
        }
    }

    /// The ray from a point of a surface, its normal given, to the light; none where the light has no
    /// direction.
    #[inline]
    pub(crate) fn ray_from(&self, point: DVec3, normal: [f32; 3]) -> Option<PreparedRay> {
        match self.kind {
            LightKind::Point { position } => PreparedRay::to(point, normal, double(position)),
            LightKind::Directional { direction } => {
                let towards = (-double(direction)).try_normalize()?;
                Some(PreparedRay::leaving(point, normal, towards))
            }
        }
    }

    /// Where light that goes through `point` along `-towards` starts: the light itself, or a point
    /// `reach` away for a light at infinity.
    pub(crate) fn origin(&self, point: DVec3, towards: DVec3, reach: f64) -> DVec3 {
        match self.kind {
            LightKind::Point { position } => double(position),
            LightKind::Directional { .. } => point + towards * reach,
        }
    }
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
        let sight = light.seen_from([0.0; 3]).unwrap();
        assert_eq!(sight.color, [1.0, 2.0, 0.0]);
        assert_eq!((sight.direction, sight.distance), ([0.0, 1.0, 0.0], Some(2.0)));
        assert_eq!(light.seen_from([0.0, 2.0, 0.0]), None);
        assert_eq!(light.seen_from([f32::NAN; 3]), None);
    }

    #[test]
    fn directional_lights_come_from_behind_their_direction() {
        let kind = LightKind::Directional { direction: [0.0, -2.0, 0.0] };
        let mut light = Light { name: "sun".into(), power: [1.0; 3], kind };
        let sight = light.seen_from([5.0; 3]).unwrap();
        assert_eq!((sight.direction, sight.distance), ([0.0, 1.0, 0.0], None));
        light.kind = LightKind::Directional { direction: [0.0; 3] };
        assert_eq!(light.seen_from([5.0; 3]), None);
    }
}
