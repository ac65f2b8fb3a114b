//! The trait of what shades points.

use std::collections::BTreeSet;

use crate::effects::{EffectSet, Renderer};
use crate::graph::RootKind;
use crate::state::{Field, FieldSet, State};
use crate::values::Texture;

use super::links::Links;

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

    /// The fields of the state that a root may read; the renderer need not work out others.
    fn fields(&self, _root: RootKind) -> FieldSet {
        Field::ALL.iter().copied().collect()
    }

    /// The textures it may read, whatever the root: a renderer opens them before it renders.
    fn textures(&self) -> BTreeSet<Texture> {
        BTreeSet::new()
    }

    /// Those of [`Shade::textures`] that may be read by footprints.
    fn filtered_textures(&self) -> BTreeSet<Texture> {
        BTreeSet::new()
    }

    /// Looks up the lights and textures it names, whatever the root.
    fn link(&self, _renderer: &mut dyn Renderer) -> Links {
        Links::default()
    }

    /// Shades `points`, all of one ray type, and writes one result each. Requests go to `renderer`,
    /// which may call back into this or other shaders before it answers. `links` are what
    /// [`Shade::link`] made with that renderer; with others there may be no lights or textures.
    fn shade_linked(
        &self,
        root: RootKind,
        points: &[State],
        links: &Links,
        renderer: &mut dyn Renderer,
        results: &mut [Shaded],
    );

    /// Links and shades; who shades often links once.
    fn shade(
        &self,
        root: RootKind,
        points: &[State],
        renderer: &mut dyn Renderer,
        results: &mut [Shaded],
    ) {
        let links = self.link(renderer);
        self.shade_linked(root, points, &links, renderer, results);
    }
}
