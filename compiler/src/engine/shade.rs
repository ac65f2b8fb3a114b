//! The trait of what shades points.

use std::collections::BTreeSet;

use crate::effects::{EffectSet, Renderer};
use crate::graph::RootKind;
use crate::state::State;
use crate::values::Texture;

/// What shading a point yields.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shaded {
    /// Colour r, g, b, a.
    pub color: [f32; 4],
    /// False for mental ray's miFALSE: nothing was shaded.
    pub ok: bool,
}

/// Something that shades points: a compiled graph, or a monolith written by hand.
pub trait Shade: Send + Sync {
    /// Whether it has a root of this kind; [`Shade::shade`] may be called for those only.
    fn has_root(&self, root: RootKind) -> bool;

    /// The effects a root may ask for; the renderer need not provide others.
    fn effects(&self, root: RootKind) -> EffectSet;

    /// The textures it may read, whatever the root: a renderer opens them before it renders.
    fn textures(&self) -> BTreeSet<Texture> {
        BTreeSet::new()
    }

    /// Shades `points`, all of one ray type, and writes one result each. Requests go to `renderer`,
    /// which may call back into this or other shaders before it answers.
    fn shade(
        &self,
        root: RootKind,
        points: &[State],
        renderer: &mut dyn Renderer,
        results: &mut [Shaded],
    );
}
