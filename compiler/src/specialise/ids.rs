//! Positions in what is specialised, each of its own type.

use cranelift_entity::entity_impl;

/// Position in [`Specialised::instances`](super::Specialised::instances).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct InstanceId(u32);
entity_impl!(InstanceId, "instance");

/// Position in [`Epochs`](super::Epochs).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct EpochId(u32);
entity_impl!(EpochId, "epoch");

impl EpochId {
    /// The outermost one: the point itself.
    pub const POINT: Self = Self(0);
}

/// Position in [`Specialised::light_lists`](super::Specialised::light_lists).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LightListId(u32);
entity_impl!(LightListId, "lights");

/// Position in [`Specialised::tables`](super::Specialised::tables).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LightTableId(u32);
entity_impl!(LightTableId, "table");

/// Position in [`Specialised::textures`](super::Specialised::textures).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TexturePosition(u32);
entity_impl!(TexturePosition, "texture");
