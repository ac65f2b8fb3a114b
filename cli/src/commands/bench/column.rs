//! Who shades a workload.

use std::sync::Arc;

use phenomenon_compiler::engine::jit::Generator;
use phenomenon_compiler::engine::{Engine, Options, Shade, Shader};
use phenomenon_compiler::graph::Graph;

use super::generators;
use super::workloads::Workload;
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
    /// By hand in scalar Rust.
    Monolith,
    /// By hand with the instructions of AVX2.
    Monolith8,
    /// The bodies of the nodes as one body, compiled by rustc.
    Fused8,
}

impl Column {
    /// All of them, in the order of the table.
    pub fn all() -> Vec<Self> {
        let jit = Generator::ALL.map(Self::Jit);
        let mut all = vec![Self::Walk, Self::Batch];
        all.extend(jit);
        all.extend([Self::Monolith, Self::Monolith8, Self::Fused8]);
        all
    }

    /// Name in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Walk => "walk",
            Self::Batch => "batch",
            Self::Jit(generator) => generators::engine_name(generator),
            Self::Monolith => "monolith",
            Self::Monolith8 => "monolith8",
            Self::Fused8 => "fused8",
        }
    }

    /// The workload, whose graph is given, ready to be shaded in calls of that many points; none where
    /// nobody wrote it.
    ///
    /// # Errors
    /// The graph cannot be compiled.
    pub fn shader(
        self,
        workload: Workload,
        graph: &Arc<Graph>,
        batch: usize,
    ) -> Result<Option<Box<dyn Shade>>, Failure> {
        let of_engine = |engine| Options { engine, ..Options::default() };
        let options = match self {
            Self::Walk => of_engine(Engine::Walk),
            Self::Batch => of_engine(Engine::Batch),
            Self::Jit(generator) => generators::options(generator),
            Self::Monolith => return Ok(Some(workload.by_hand())),
            Self::Monolith8 => return Ok(workload.by_eight()),
            Self::Fused8 => return Ok(Some(workload.fused())),
        };
        let options = Options { batch, ..options };
        let shader = Shader::new(Arc::clone(graph), &[], options);
        let shader = shader.map_err(|error| Failure::new(error, ""))?;
        Ok(Some(Box::new(shader)))
    }
}
