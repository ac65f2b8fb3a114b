//! A scene of nothing but textures.

use phenomenon_compiler::effects::{
    Answer, Lookup, NoScene, Ray, Renderer, Sampling, TextureId, Trace,
};
use phenomenon_compiler::engine::Shade;
use phenomenon_compiler::state::State;
use phenomenon_compiler::values::Texture;

use crate::texture::{TextureError, Textures};

/// Answers as [`NoScene`] does, but for textures, which can be read.
pub struct EmptyScene {
    textures: Textures,
}

impl EmptyScene {
    /// With the textures that a shader may read.
    ///
    /// # Errors
    /// One of them cannot be used.
    pub fn new(shader: &dyn Shade) -> Result<Self, TextureError> {
        let mut textures = Textures::default();
        textures.open_those_of(shader)?;
        Ok(Self { textures })
    }
}

impl Renderer for EmptyScene {
    fn trace(&mut self, trace: Trace, states: &[State], rays: &[Ray], answers: &mut [Answer]) {
        NoScene.trace(trace, states, rays, answers);
    }

    fn texture(&mut self, texture: &Texture) -> TextureId {
        self.textures.number(texture)
    }

    fn texture_size(&mut self, texture: TextureId) -> Option<[u32; 2]> {
        self.textures.size(texture)
    }

    fn read_texture(
        &mut self,
        texture: TextureId,
        sampling: Sampling,
        lookups: &[Lookup],
        colors: &mut [Option<[f32; 4]>],
    ) {
        self.textures.read(texture, sampling, lookups, colors);
    }
}
