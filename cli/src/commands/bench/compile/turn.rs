//! One graph on its way to machine code, and the clock.

use std::hint::black_box;
use std::sync::Arc;

use cpu_time::ThreadTime;
use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document::read;
use phenomenon_compiler::effects::NoScene;
use phenomenon_compiler::engine::jit::{Generator, JitCode, Pieces, lay_out};
use phenomenon_compiler::engine::{Shade, Shaded, Shader, ShaderError};
use phenomenon_compiler::graph::{Graph, RootKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::schedule::schedule;
use phenomenon_compiler::specialise::expand;
use phenomenon_compiler::state::{RayType, State};
use phenomenon_compiler::storage::{FileShape, stride};

use crate::commands::bench::generators;
use crate::failure::Failure;

/// Points of the first batch.
const POINTS: usize = 256;

/// A graph that is measured.
pub struct Subject {
    /// Its kind.
    pub name: &'static str,
    /// Nodes it has.
    pub nodes: usize,
    text: String,
}

/// Milliseconds of CPU time, stage by stage.
#[derive(Clone, Copy, Debug)]
pub struct Turn {
    /// Reading and checking its file.
    pub check: f64,
    /// Names become words.
    pub specialise: f64,
    /// Evaluations in order.
    pub schedule: f64,
    /// Operations, folded and cut.
    pub record: f64,
    /// Machine code of them.
    pub generate: f64,
    /// `Shader::new` and a first point, with which the code is made.
    pub compile: f64,
    /// That, and the first batch.
    pub first_batch: f64,
}

/// What `work` yields, and the milliseconds it took.
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = ThreadTime::now();
    let result = work();
    (result, start.elapsed().as_secs_f64() * 1e3)
}

impl Subject {
    /// A graph with that text.
    ///
    /// # Errors
    /// It has errors: a mistake of ours.
    pub fn new(name: &'static str, text: String, library: &NodeLibrary) -> Result<Self, Failure> {
        let nodes = checked(name, &text, library)?.nodes.len();
        Ok(Self { name, nodes, text })
    }

    /// Takes it from its file to code once, stage by stage, and as `Shader::new` does.
    ///
    /// # Errors
    /// The generator does not run here.
    pub fn turn(&self, library: &NodeLibrary, generator: Generator) -> Result<Turn, Failure> {
        let (graph, check) = timed(|| checked(self.name, &self.text, library));
        let graph = Arc::new(graph?);
        let unusable = || Failure::new(format!("the graph {} has no material", self.name), "");
        let root = graph.root(RootKind::Material).ok_or_else(unusable)?;
        let failed = |error: &dyn std::fmt::Display| Failure::new(error, "");
        let options = generators::options(generator);

        let (specialised, specialise) = timed(|| expand(&graph, root, RayType::Eye, &[]));
        let specialised = specialised.map_err(|error| failed(&error))?;
        let (schedule, in_order) = timed(|| schedule(&specialised));
        let uniforms = specialised.uniforms.values().len();
        let ((pieces, layout), record) = timed(|| {
            let mut pieces = Pieces::of(&schedule, uniforms, options.batch, generator, &[]);
            let layout = lay_out(&schedule, &mut pieces);
            (pieces, layout)
        });
        let (words, slots) = (layout.uniforms.len(), stride(layout.schedule.slots));
        let shape = FileShape { uniforms: words, slots };
        let (code, generate) = timed(|| JitCode::compile(generator, &pieces.functions, shape));
        drop(black_box(code.map_err(|error| failed(&error))?));

        let points = [State::default(); POINTS];
        let mut results = [Shaded::default(); POINTS];
        let mut shade = |shader: &Shader, points: &[State]| {
            shader.shade(RootKind::Material, points, &mut NoScene, &mut results[..points.len()]);
        };
        let (shader, compile) = timed(|| {
            let shader = Shader::new(Arc::clone(&graph), &[], options)?;
            shade(&shader, &points[..1]);
            Ok(shader)
        });
        let shader = shader.map_err(|error: ShaderError| failed(&error))?;
        if let Some(error) = shader.jit_failure() {
            return Err(failed(error));
        }
        let ((), batch) = timed(|| shade(&shader, &points));
        let first_batch = compile + batch;
        let schedule = in_order;
        Ok(Turn { check, specialise, schedule, record, generate, compile, first_batch })
    }
}

fn checked(name: &str, text: &str, library: &NodeLibrary) -> Result<Graph, Failure> {
    let checked = read(name, text.as_bytes()).map(|it| check_graph(&it, library));
    let graph = checked.ok().and_then(|checked| checked.graph);
    graph.ok_or_else(|| Failure::new(format!("the graph {name} cannot be used"), ""))
}
