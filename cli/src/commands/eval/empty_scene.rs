//! A scene of nothing but textures: rays hit nothing, the environment is black and not ok, no light
//! shines.

use std::collections::BTreeSet;

use phenomenon_compiler::effects::{Answer, Ray, Renderer, TextureId, Trace};
use phenomenon_compiler::values::Texture;
use phenomenon_runtime::texture::{TextureError, Textures};

/// See the module.
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
    fn trace(&mut self, _: Trace, _: &[Ray], answers: &mut [Answer]) {
        answers.fill(Answer::default());
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
        let picture = self.textures.picture(texture);
        for (at, color) in coordinates.iter().zip(colors) {
            *color = picture.and_then(|picture| picture.color(*at));
        }
    }
}
