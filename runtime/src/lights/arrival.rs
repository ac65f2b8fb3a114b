//! The ways between points and lights, and what arrives along them.

use glam::DVec3;

use crate::geometry::PreparedRay;

/// Where the light that reaches a point comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightSource {
    /// From a place.
    At(DVec3),
    /// From infinity, in this direction from the point.
    Towards(DVec3),
}

impl LightSource {
    /// The ray from a point of a surface, its normal given, to the source; none where they are in one place.
    #[inline]
    pub(crate) fn ray_from(self, point: DVec3, normal: [f32; 3]) -> Option<PreparedRay> {
        match self {
            LightSource::At(place) => PreparedRay::to(point, normal, place),
            LightSource::Towards(towards) => Some(PreparedRay::leaving(point, normal, towards)),
        }
    }

    /// Where light that goes through `point` along `-towards` starts: the source itself, or a point
    /// `reach` away for a light at infinity.
    pub(crate) fn origin(self, point: DVec3, towards: DVec3, reach: f64) -> DVec3 {
        match self {
            LightSource::At(place) => place,
            LightSource::Towards(_) => point + towards * reach,
        }
    }
}

/// The straight way from one place to another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way {
    /// Unit length.
    pub(super) direction: DVec3,
    pub(super) distance: f64,
    /// Its square.
    pub(super) squared: f64,
}

impl Way {
    /// None where there is no direction.
    #[inline]
    pub(super) fn between(from: DVec3, to: DVec3) -> Option<Self> {
        let towards = to - from;
        let squared = towards.length_squared();
        let distance = squared.sqrt();
        let usable = distance > 0.0 && distance.is_finite();
        usable.then(|| Self { direction: towards / distance, distance, squared })
    }
}

/// What one sample of a light sends to a point where nothing is in the way: the light's power times
/// `share / over`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arrival {
    /// Unit direction from the point.
    pub(super) direction: DVec3,
    pub(super) distance: f64,
    /// The place on the light.
    pub(super) place: DVec3,
    pub(super) share: f64,
    pub(super) over: f64,
}

impl Arrival {
    /// Light that falls off with the square of the distance from a place, and of which the direction lets `share` pass.
    #[inline]
    pub(super) fn from_place(place: DVec3, way: Way, share: f64) -> Self {
        Self { direction: way.direction, distance: way.distance, place, share, over: way.squared }
    }
}

/// A vector of length 1; none if it has no direction.
pub(super) fn direction(vector: [f64; 3]) -> Option<DVec3> {
    let vector = DVec3::from(vector);
    // Scaled first: squares of what is very long or very short are no numbers to divide by.
    let largest = vector.abs().max_element();
    (largest > 0.0 && largest.is_finite()).then(|| (vector / largest).normalize())
}
