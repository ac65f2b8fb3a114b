//! How large the textures of a scene are together.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::diagnostics::{Code, Finding};
use phenomenon_compiler::engine::{Engine, Options, Shade, Shader};
use phenomenon_compiler::graph::{Binding, Graph};
use phenomenon_compiler::values::{Literal, Texture, Type};

use crate::render::CALLED_ROOTS;
use crate::scene_file::{Assets, MaterialRef};
use crate::texture::PixelSum;

/// The textures a renderer would open for the graphs of a scene, summed by their headers.
pub(super) struct TextureSum<'a> {
    assets: &'a Assets,
    known: BTreeSet<Texture>,
    /// None once they were too many, which is told once.
    sum: Option<PixelSum>,
}

impl<'a> TextureSum<'a> {
    /// Of no graph yet.
    pub fn new(assets: &'a Assets) -> Self {
        Self { assets, known: BTreeSet::new(), sum: Some(PixelSum::default()) }
    }

    /// Adds the textures of a graph with these values, used by a material; a finding where they are too much.
    pub fn add(
        &mut self,
        graph: &Arc<Graph>,
        values: &[(String, Literal)],
        material: &MaterialRef,
    ) -> Option<Finding> {
        let sum = self.sum.as_mut().filter(|_| names_textures(graph))?;
        for texture in opened(graph, values) {
            // What cannot be read was told of.
            let Some(pixels) = self.assets.pixels(Path::new(&texture.file)) else { continue };
            let file = texture.file.clone();
            if self.known.insert(texture)
                && let Err(error) = sum.add(&file, pixels)
            {
                self.sum = None;
                let (message, help) = (error.to_string(), "use fewer or smaller pictures");
                let place = material.place.clone();
                return Some(Finding::new(Code::UNUSABLE_FILE, place, message, help));
            }
        }
        None
    }
}

/// Whether a graph can have textures at all.
fn names_textures(graph: &Graph) -> bool {
    let is_texture =
        |binding: &Binding| matches!(binding, Binding::Literal(Literal::Texture(Some(_))));
    graph.parameters.iter().any(|parameter| parameter.value_type == Type::Texture)
        || graph.nodes.iter().any(|node| node.inputs.iter().any(is_texture))
}

/// The textures of what a renderer compiles of a graph; none where it cannot be compiled, which is told of elsewhere.
fn opened(graph: &Arc<Graph>, values: &[(String, Literal)]) -> BTreeSet<Texture> {
    // Every engine starts from what the walk runs.
    let options = Options {
        engine: Engine::Walk,
        roots: CALLED_ROOTS,
        called_rays_only: true,
        ..Options::default()
    };
    let shader = Shader::new(Arc::clone(graph), values, options);
    shader.map(|shader| shader.textures()).unwrap_or_default()
}
