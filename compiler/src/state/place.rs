//! A point with all that may be read there, to be set field by field.

use super::camera::Camera;
use super::object::Object;
use super::shading_point::State;
use super::surface::Surface;

/// A point of no scene: its state, and what scenes add. [`Field::put`](super::Field::put) sets a field,
/// [`Objects::of_place`](super::Objects::of_place) looks them up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place {
    /// The point.
    pub state: State,
    /// The object it is on.
    pub object: Object,
    /// The surface there.
    pub surface: Surface,
    /// Where it is seen from.
    pub camera: Camera,
}
