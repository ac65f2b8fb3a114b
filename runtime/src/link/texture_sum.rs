//! How large the textures of a scene are together.

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::Arc;

use phenomenon_compiler::diagnostics::{Code, Finding};
use phenomenon_compiler::engine::{Engine, Options, Shade, Shader};
use phenomenon_compiler::graph::{Binding, Graph};
use phenomenon_compiler::values::{Literal, Texture, TilePattern, Type};

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
        for texture in shader.textures() {
            if !self.known.contains(&texture) {
                for (file, size) in sizes(self.assets, &texture) {
                    sum.add(&file, size)?;
                }
                self.known.insert(texture);
            }
        }
        for texture in shader.filtered_textures() {
            if !self.known_filtered.contains(&texture) {
                for (file, size) in sizes(self.assets, &texture) {
                    sum.add_levels(&file, size)?;
                }
                self.known_filtered.insert(texture);
            }
        }
        Ok(())
    }
}

/// The files a texture is of, with columns and rows of each. What cannot be read was told of.
fn sizes(assets: &Assets, texture: &Texture) -> Vec<(String, [u32; 2])> {
    let path = PathBuf::from(&texture.file);
    let files = match TilePattern::of(&path) {
        None => vec![path],
        Some(pattern) => {
            let tiles = pattern.files().unwrap_or_default();
            tiles.into_iter().map(|(_, path)| path).collect()
        }
    };
    let files = files.into_iter();
    files.filter_map(|path| Some((path.display().to_string(), assets.size(&path)?))).collect()
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
