//! The engines: walk, batch and jit, behind one trait that hand-written shaders share.

mod batch;
pub mod execute;
pub mod jit;
mod memory;
mod shader;
pub mod walk;

pub use batch::Runner;
pub use shader::{Shader, ShaderError};

use std::collections::BTreeSet;

use crate::effects::{Effect, Renderer};
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
    fn effects(&self, root: RootKind) -> BTreeSet<Effect>;

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

/// Which engine runs a graph.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Engine {
    /// Batch at once, jit as soon as its code is ready.
    #[default]
    Auto,
    /// A tree walk with a cache, one point at a time, as mi_eval does it.
    Walk,
    /// A schedule run by kernels compiled from the node bodies, eight points wide.
    Batch,
    /// The same schedule with its light parts fused to machine code by Cranelift.
    Jit,
}

/// Which forms of the node bodies run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Simd {
    /// The best the CPU has.
    #[default]
    Native,
    /// Portable code, whatever the CPU has: the same bits, slower.
    Portable,
}

/// How a graph is run. No choice changes a bit of the result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Which engine.
    pub engine: Engine,
    /// Which forms of the node bodies.
    pub simd: Simd,
    /// Most points shaded at once, at least 1.
    pub batch: usize,
    /// Which roots are compiled; the others are as if the graph had none.
    pub roots: &'static [RootKind],
}

impl Default for Options {
    fn default() -> Self {
        Self { engine: Engine::Auto, simd: Simd::Native, batch: 256, roots: &RootKind::ALL }
    }
}
