//! A shader that notes the points it is called for.

use std::collections::BTreeSet;
use std::sync::{Arc, Mutex, PoisonError};

use phenomenon_compiler::effects::{EffectSet, Renderer};
use phenomenon_compiler::engine::{Links, Shade, Shaded};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::{FieldSet, State};
use phenomenon_compiler::values::Texture;

/// Shades as another does, and notes the points of its material.
pub struct Listening {
    shader: Arc<dyn Shade>,
    heard: Mutex<Vec<State>>,
}

impl Listening {
    /// Listens to what a shader is asked.
    pub fn to(shader: Arc<dyn Shade>) -> Self {
        Self { shader, heard: Mutex::default() }
    }

    /// The points so far, in the order they came in.
    pub fn heard(&self) -> Vec<State> {
        self.heard.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

impl Shade for Listening {
    fn has_root(&self, root: RootKind) -> bool {
        self.shader.has_root(root)
    }

    fn effects(&self, root: RootKind) -> EffectSet {
        self.shader.effects(root)
    }

    fn fields(&self, root: RootKind) -> FieldSet {
        self.shader.fields(root)
    }

    fn textures(&self) -> BTreeSet<Texture> {
        self.shader.textures()
    }

    fn filtered_textures(&self) -> BTreeSet<Texture> {
        self.shader.filtered_textures()
    }

    fn link(&self, renderer: &mut dyn Renderer) -> Links {
        self.shader.link(renderer)
    }

    fn shade_linked(
        &self,
        root: RootKind,
        points: &[State],
        links: &Links,
        renderer: &mut dyn Renderer,
        results: &mut [Shaded],
    ) {
        if root == RootKind::Material {
            self.heard.lock().unwrap_or_else(PoisonError::into_inner).extend_from_slice(points);
        }
        self.shader.shade_linked(root, points, links, renderer, results);
    }
}
