//! Who shades a subject.

use std::sync::Arc;

use phenomenon_compiler::engine::jit::Generator;
use phenomenon_compiler::engine::{Engine, Options, Shade, Shader};
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::specialise::Asking;
use phenomenon_runtime::monoliths;

use super::subject::Subject;
use crate::commands::bench::generators;
use crate::commands::bench::workloads::Workload;
use crate::failure::Failure;

/// One of those that are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Column {
    /// The engine that walks the graph.
    Walk,
    /// The engine of kernels.
    Batch,
    /// The jit, by one of its generators.
    Jit(Generator),
    /// The jit, of a graph that leaves nothing out.
    Eager,
    /// By hand in scalar Rust.
    Monolith,
    /// The same by hand, over the arithmetic of the nodes.
    SameBits,
    /// By hand with the instructions of AVX2.
    Monolith8,
    /// The bodies of the nodes as one body, compiled by rustc.
    Fused8,
}

/// What shades in a column.
pub enum Shading {
    /// A graph.
    Compiled(Shader),
    /// No graph.
    ByHand(Box<dyn Shade>),
}

impl Shading {
    /// It as what it does.
    pub fn shader(&self) -> &dyn Shade {
        match self {
            Self::Compiled(shader) => shader,
            Self::ByHand(shader) => shader.as_ref(),
        }
    }

    /// Time spent compiling so far, machine code included, in milliseconds; none without a graph.
    pub fn compile_milliseconds(&self) -> Option<f64> {
        match self {
            Self::Compiled(shader) => Some(shader.compile_milliseconds()),
            Self::ByHand(_) => None,
        }
    }
}

impl Column {
    /// All of them, in the order of the table.
    pub fn all() -> Vec<Self> {
        let jit = Generator::ALL.map(Self::Jit);
        let mut all = vec![Self::Walk, Self::Batch];
        all.extend(jit);
        all.extend([Self::Eager, Self::Monolith, Self::SameBits]);
        all.extend([Self::Monolith8, Self::Fused8]);
        all
    }

    /// Name in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Walk => "walk",
            Self::Batch => "batch",
            Self::Jit(generator) => generators::engine_name(generator),
            Self::Eager => "jit_eager",
            Self::Monolith => "monolith",
            Self::SameBits => "monolith_same_bits",
            Self::Monolith8 => "monolith8",
            Self::Fused8 => "fused8",
        }
    }

    /// A subject, whose graph is given, ready to be shaded in calls of that many points; none where
    /// nobody wrote it.
    ///
    /// # Errors
    /// The graph cannot be compiled.
    pub fn shading(
        self,
        subject: Subject,
        graph: &Arc<Graph>,
        batch: usize,
    ) -> Result<Option<Shading>, Failure> {
        let options = match (self, subject) {
            (Self::Walk, _) => Options { engine: Engine::Walk, ..Options::default() },
            (Self::Batch, _) => Options { engine: Engine::Batch, ..Options::default() },
            (Self::Jit(generator), _) => generators::options(generator),
            (Self::Eager, Subject::Material(_)) => {
                // Where there is no jit there is no generator to choose.
                let Ok(generator) = Generator::chosen(None) else { return Ok(None) };
                Options { asking: Asking::All, ..generators::options(generator) }
            }
            (by_hand, Subject::Workload(workload)) => {
                return Ok(by_hand.of_workload(workload).map(Shading::ByHand));
            }
            (by_hand, Subject::Material(material)) => {
                return Ok(by_hand.of_material(material.name()).map(Shading::ByHand));
            }
        };
        let options = Options { batch, ..options };
        let shader = Shader::new(Arc::clone(graph), &[], options);
        Ok(Some(Shading::Compiled(shader.map_err(|error| Failure::new(error, ""))?)))
    }

    fn of_workload(self, workload: Workload) -> Option<Box<dyn Shade>> {
        match self {
            Self::Monolith => Some(workload.by_hand()),
            Self::Monolith8 => workload.by_eight(),
            Self::Fused8 => Some(workload.fused()),
            _ => None,
        }
    }

    fn of_material(self, name: &str) -> Option<Box<dyn Shade>> {
        match self {
            Self::Monolith => monoliths::find(name, &[])?.ok(),
            Self::SameBits => monoliths::find_same_bits(name, &[])?.ok(),
            _ => None,
        }
    }
}
