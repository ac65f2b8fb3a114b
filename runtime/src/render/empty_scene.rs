//! A scene of nothing but textures.

use phenomenon_compiler::effects::{
    Answer, Lookup, NoScene, Ray, Renderer, Sampling, TextureId, Trace,
};
use phenomenon_compiler::engine::Shade;
use phenomenon_compiler::state::{Objects, Place, State};
use phenomenon_compiler::values::Texture;

use crate::texture::{TextureError, Textures};

/// Answers as [`NoScene`] does, but for textures, which can be read, and what is looked up of a place.
pub struct EmptyScene {
    textures: Textures,
    place: Place,
}

impl EmptyScene {
    /// With the textures that a shader may read; all points are in the place.
    ///
    /// # Errors
    /// One of them cannot be used.
    pub fn new(shader: &dyn Shade, place: Place) -> Result<Self, TextureError> {
        let mut textures = Textures::default();
        textures.open_those_of(shader)?;
        Ok(Self { textures, place })
    }
}

impl Renderer for EmptyScene {
    fn trace(&mut self, trace: Trace, states: &[State], rays: &[Ray], answers: &mut [Answer]) {
        NoScene.trace(trace, states, rays, answers);
    }

    fn objects(&self) -> Objects<'_> {
        Objects::of_place(&self.place)
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
