//! The objects of a scene.

use phenomenon_compiler::state;

use crate::geometry::{ShadowTerminator, Shape, Transform};

/// An object in its place.
#[derive(Clone, Debug)]
pub(super) struct Object {
    /// Its shape.
    pub(super) shape: Shape,
    /// From its space to that of the scene.
    pub(super) transform: Transform,
    /// Position of its material.
    pub(super) material: u32,
    /// Where its own shadow ends, if it is a mesh with normals.
    pub(super) terminator: ShadowTerminator,
}

impl Object {
    /// What shaders can know of it, being at a position in the scene.
    pub(super) fn known(&self, position: u32) -> state::Object {
        let to_world = self.transform.rows();
        let to_object = self.transform.inverse().rows();
        state::Object { to_world, to_object, ..state::Object::at(position) }
    }
}
