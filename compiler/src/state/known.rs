//! What is looked up of one point.

use super::camera::Camera;
use super::object::Object;
use super::shading_point::State;
use super::surface::Surfaces;

/// A point with all that its state does not hold.
#[derive(Clone, Copy)]
pub struct Known<'a> {
    /// The point.
    pub state: &'a State,
    /// The object it is on.
    pub object: &'a Object,
    /// Tells what the surface there is like.
    pub surfaces: &'a dyn Surfaces,
    /// Where the scene is seen from.
    pub camera: &'a Camera,
}
