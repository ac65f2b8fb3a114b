//! A scene of nothing but textures.

use std::collections::BTreeSet;

use phenomenon_compiler::effects::{Answer, NoScene, Ray, Renderer, TextureId, Trace};
use phenomenon_compiler::state::State;
use phenomenon_compiler::values::Texture;

use crate::texture::{TextureError, Textures};

/// Answers as [`NoScene`] does, but for textures, which can be read.
pub struct EmptyScene {
    textures: Textures,
}

impl EmptyScene {
    /// With these textures.
    ///
    /// # Errors
    /// One of them cannot be used.
    pub fn new(textures: &BTreeSet<Texture>) -> Result<Self, TextureError> {
        let mut opened = Textures::default();
        textures.iter().try_for_each(|texture| opened.open(texture))?;
        Ok(Self { textures: opened })
    }
}

impl Renderer for EmptyScene {
    fn trace(&mut self, trace: Trace, states: &[State], rays: &[Ray], answers: &mut [Answer]) {
        NoScene.trace(trace, states, rays, answers);
    }

    fn texture(&mut self, texture: &Texture) -> TextureId {
        self.textures.number(texture)
    }

    fn read_texture(
        &mut self,
        texture: TextureId,
        coordinates: &[[f32; 2]],
        colors: &mut [Option<[f32; 4]>],
    ) {
        self.textures.read(texture, coordinates, colors);
    }
}
