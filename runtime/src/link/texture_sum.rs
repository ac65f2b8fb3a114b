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
use crate::texture::{PixelSum, TextureError};

/// The textures a renderer would open for the graphs of a scene, summed by their headers.
pub(super) struct TextureSum<'a> {
    assets: &'a Assets,
    known: BTreeSet<Texture>,
    /// Those with coarser versions.
    known_filtered: BTreeSet<Texture>,
    /// None once they were too many, which is told once.
    sum: Option<PixelSum>,
}

impl<'a> TextureSum<'a> {
    /// Of no graph yet.
    pub fn new(assets: &'a Assets) -> Self {
        Self {
            assets,
            known: BTreeSet::new(),
            known_filtered: BTreeSet::new(),
            sum: Some(PixelSum::default()),
        }
    }

    /// Adds the textures of a graph with these values, used by a material; a finding where they are too much.
    pub fn add(
        &mut self,
        graph: &Arc<Graph>,
        values: &[(String, Literal)],
        material: &MaterialRef,
    ) -> Option<Finding> {
        if self.sum.is_none() || !names_textures(graph) {
            return None;
        }
        let shader = compiled(graph, values)?;
        let error = self.count(&shader).err()?;
        self.sum = None;
        let (message, help) = (error.to_string(), "use fewer or smaller pictures");
        let place = material.place.clone();
        Some(Finding::new(Code::UNUSABLE_FILE, place, message, help))
    }

    /// Adds what was not added before.
    fn count(&mut self, shader: &Shader) -> Result<(), TextureError> {
        let Some(sum) = &mut self.sum else { return Ok(()) };
        // What cannot be read was told of.
        let size = |texture: &Texture| self.assets.size(Path::new(&texture.file));
        for texture in shader.textures() {
            if let Some(size) = size(&texture)
                && self.known.insert(texture.clone())
            {
                sum.add(&texture.file, size)?;
            }
        }
        for texture in shader.filtered_textures() {
            if let Some(size) = size(&texture)
                && self.known_filtered.insert(texture.clone())
            {
                sum.add_levels(&texture.file, size)?;
            }
        }
        Ok(())
    }
}

/// Whether a graph can have textures at all.
fn names_textures(graph: &Graph) -> bool {
    let is_texture =
        |binding: &Binding| matches!(binding, Binding::Literal(Literal::Texture(Some(_))));
    graph.parameters.iter().any(|parameter| parameter.value_type == Type::Texture)
        || graph.nodes.iter().any(|node| node.inputs.iter().any(is_texture))
}

/// What a renderer compiles of a graph; none where it cannot be compiled, which is told of elsewhere.
fn compiled(graph: &Arc<Graph>, values: &[(String, Literal)]) -> Option<Shader> {
    // Every engine starts from what the walk runs.
    let options = Options {
        engine: Engine::Walk,
        roots: CALLED_ROOTS,
        called_rays_only: true,
        ..Options::default()
    };
    Shader::new(Arc::clone(graph), values, options).ok()
}
