//! What the names in a shader stand for in a renderer.

use cranelift_entity::EntityRef;

use crate::effects::{LightList, TextureId};
use crate::specialise::{LightListId, TexturePosition};

/// The lights and textures a shader names, looked up once by one renderer. In an order that only the
/// shader knows, so links hold for the shader and the renderer they were made with, until the shader
/// compiles anew.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Links {
    /// Its lists of lights.
    pub light_lists: Vec<LightList>,
    /// Its textures.
    pub textures: Vec<TextureId>,
}

/// The part of the links that belongs to one program of a shader.
#[derive(Clone, Copy, Debug)]
pub(super) struct Linked<'a> {
    light_lists: &'a [LightList],
    textures: &'a [TextureId],
}

/// Where the links of a program begin.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct FirstLinks {
    pub light_list: usize,
    pub texture: usize,
}

impl Links {
    /// Those from there on.
    pub(super) fn from(&self, first: FirstLinks) -> Linked<'_> {
        Linked {
            light_lists: self.light_lists.get(first.light_list..).unwrap_or_default(),
            textures: self.textures.get(first.texture..).unwrap_or_default(),
        }
    }
}

impl Linked<'_> {
    /// A list of lights; none where links of something else were handed over.
    pub(super) fn light_list(self, list: LightListId) -> Option<LightList> {
        self.light_lists.get(list.index()).copied()
    }

    /// A texture; one that no renderer has where links of something else were handed over.
    pub(super) fn texture(self, texture: TexturePosition) -> TextureId {
        self.textures.get(texture.index()).copied().unwrap_or(TextureId::NONE)
    }
}
