//! The objects of a scene.

use crate::geometry::{ShadowTerminator, Shape};

/// An object in its place.
#[derive(Clone, Debug)]
pub(super) struct Object {
    /// Its shape.
    pub(super) shape: Shape,
    /// Position of its material.
    pub(super) material: u32,
    /// Where its own shadow ends, if it is a mesh with normals.
    pub(super) terminator: ShadowTerminator,
}
