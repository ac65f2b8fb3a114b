//! How a graph is run.

use super::jit::Generator;
use crate::graph::RootKind;
use crate::specialise::Asking;

/// Which engine runs a graph.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Engine {
    /// Batch at once, jit as soon as its code is ready; it is made when the first point of a root and ray
    /// type is shaded.
    #[default]
    Auto,
    /// A tree walk with a cache, one point at a time, as mi_eval does it.
    Walk,
    /// A schedule run by kernels compiled from the node bodies, eight points wide.
    Batch,
    /// The same schedule compiled to machine code, when the first point of a root and ray type is shaded.
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
    /// Who makes the machine code; none: the best there is on the machine.
    pub generator: Option<Generator>,
    /// Most points shaded at once, at least 1.
    pub batch: usize,
    /// Which roots are compiled; the others are as if the graph had none.
    pub roots: &'static [RootKind],
    /// Whether a root that looks at the ray type is compiled only for [`RootKind::ray_types`]; points of
    /// other types may not be shaded then.
    pub called_rays_only: bool,
    /// Whether evaluations of nodes are counted; see [`Shader::evaluations`](crate::engine::Shader::evaluations).
    /// Takes time.
    pub count: bool,
    /// Which inputs are asked for: with [`Asking::All`] points also ask what no value depends on.
    pub asking: Asking,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            engine: Engine::Auto,
            simd: Simd::Native,
            generator: None,
            batch: 256,
            roots: &RootKind::ALL,
            called_rays_only: false,
            count: false,
            asking: Asking::Guarded,
        }
    }
}
