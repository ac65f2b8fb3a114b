//! One graph in every engine: results and requests must be the same.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use crate::engine::jit::Generator;
use crate::engine::{Engine, Options, Shade, Shaded, Shader, Simd};
use crate::graph::{Graph, RootKind};
use crate::specialise::{SpecialiseError, expand};
use crate::state::State;
use crate::values::Literal;

use super::mock::{MockRenderer, Record};
use super::naive::Naive;
use super::random::{Random, canonical};

/// Graphs that specialise to more instances are not run: scopes can double them at each level.
const MOST_INSTANCES: usize = 3_000;

/// Most evaluations of the naive evaluator for a case.
const MOST_STEPS: usize = 40_000;

/// What shading yields, and what it asked for, in a canonical form.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Per point: colour bits with one NaN for all, and ok.
    pub results: Vec<([u32; 4], bool)>,
    /// Requests, sorted.
    pub log: Vec<Record>,
}

/// A graph to run, and how.
#[derive(Clone, Debug)]
pub struct Case {
    /// The graph.
    pub graph: Arc<Graph>,
    /// Values of parameters.
    pub values: Vec<(String, Literal)>,
    /// Points, of one ray type.
    pub points: Vec<State>,
    /// What is compared with the native walk.
    pub options: Vec<Options>,
    /// Whether the naive evaluator is run as well.
    pub naive: bool,
}

/// What came of a case in which nothing differed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Agreement {
    /// Whether it ran at all: the graph was not too large.
    pub ran: bool,
    /// Whether the naive evaluator finished.
    pub naive: bool,
    /// Number of requests.
    pub requests: usize,
}

fn canonical_result(shaded: &Shaded) -> ([u32; 4], bool) {
    (shaded.color.map(|x| canonical(x.to_bits())), shaded.ok)
}

/// Shades the points.
pub fn outcome(shader: &dyn Shade, root: RootKind, points: &[State]) -> Outcome {
    let mut renderer = MockRenderer::default();
    let mut results = vec![Shaded { color: [f32::NAN; 4], ok: false }; points.len()];
    shader.shade(root, points, &mut renderer, &mut results);
    let results = results.iter().map(canonical_result).collect();
    Outcome { results, log: renderer.sorted_log() }
}

impl Case {
    /// The case of a seed: `graph` with random points in random batches, engines and instructions.
    pub fn random(random: &mut Random, graph: Graph, values: Vec<(String, Literal)>) -> Self {
        let count = random.pick(&[1, 7, 8, 9, 33]);
        let points = random.states(count);
        let mut option = |engine| Options {
            engine,
            simd: random.pick(&[Simd::Native, Simd::Portable]),
            batch: random.pick(&[1, 7, 256]),
            ..Options::default()
        };
        let mut options = vec![option(Engine::Walk), option(Engine::Batch)];
        for generator in Generator::ALL {
            options.push(Options { generator: Some(generator), ..option(Engine::Jit) });
        }
        Self { graph: Arc::new(graph), values, points, options, naive: true }
    }

    /// Runs every engine. The error says what differed; a panic is an error.
    pub fn check(&self) -> Result<Agreement, String> {
        catch_unwind(AssertUnwindSafe(|| self.compare())).unwrap_or_else(|panic| {
            let message = panic.downcast_ref::<String>().map(String::as_str);
            let message = message.or(panic.downcast_ref::<&str>().copied()).unwrap_or("?");
            Err(format!("panic: {message}"))
        })
    }

    fn shader(&self, options: Options) -> Result<Shader, String> {
        Shader::new(Arc::clone(&self.graph), &self.values, options)
            .map_err(|error| format!("{options:?}: {error}"))
    }

    /// Whether the graph specialises to a size that can be run.
    fn fits(&self) -> Result<bool, String> {
        let mut values: Vec<Literal> =
            self.graph.parameters.iter().map(|parameter| parameter.default.clone()).collect();
        for (name, value) in &self.values {
            values[self.graph.parameter(name).ok_or("no such parameter")?] = value.clone();
        }
        for root in &self.graph.roots {
            let ray_type = self.points[0].ray_type;
            match expand(&self.graph, root, ray_type, &values) {
                Ok(specialised) if specialised.instances.len() <= MOST_INSTANCES => {}
                Ok(_) | Err(SpecialiseError::TooManyInstances { .. }) => return Ok(false),
                Err(error) => return Err(error.to_string()),
            }
        }
        Ok(true)
    }

    fn compare(&self) -> Result<Agreement, String> {
        if !self.fits()? {
            return Ok(Agreement::default());
        }
        let mut agreement = Agreement { ran: true, naive: self.naive, requests: 0 };
        let walk = Options { engine: Engine::Walk, ..Options::default() };
        let walk = self.shader(walk)?;
        let others: Vec<(Options, Shader)> = self
            .options
            .iter()
            .map(|&options| Ok((options, self.shader(options)?)))
            .collect::<Result<_, String>>()?;
        for root in &self.graph.roots {
            let expected = outcome(&walk, root.kind, &self.points);
            agreement.requests += expected.log.len();
            if self.naive {
                match self.naive_outcome(root.kind) {
                    Some(found) => self.same("walk", &expected, "naive", &found)?,
                    None => agreement.naive = false,
                }
            }
            for (options, shader) in &others {
                let found = outcome(shader, root.kind, &self.points);
                self.same("walk", &expected, &format!("{options:?}"), &found)?;
            }
        }
        Ok(agreement)
    }

    fn naive_outcome(&self, root: RootKind) -> Option<Outcome> {
        let naive = Naive::new(&self.graph, &self.values);
        let mut renderer = MockRenderer::default();
        let mut steps = MOST_STEPS;
        let root = self.graph.root(root)?;
        let mut results = Vec::new();
        for point in &self.points {
            let shaded = naive.shade(root, point, &mut renderer, &mut steps).ok()?;
            results.push(canonical_result(&shaded));
        }
        Some(Outcome { results, log: renderer.sorted_log() })
    }

    fn same(&self, a: &str, first: &Outcome, b: &str, second: &Outcome) -> Result<(), String> {
        let mut problems = String::new();
        let both = first.results.iter().zip(&second.results).enumerate();
        if let Some((point, (x, y))) = both.clone().find(|(_, (x, y))| x != y) {
            let text = |(bits, ok): &([u32; 4], bool)| {
                format!("{:?} ({bits:08x?}), ok {ok}", bits.map(f32::from_bits))
            };
            problems += &format!("point {point}: {a} {}\n          {b} {}\n", text(x), text(y));
        }
        let only = |these: &[Record], others: &[Record]| {
            let mut rest = others.to_vec();
            these.iter().filter(|record| remove(&mut rest, record)).cloned().collect::<Vec<_>>()
        };
        for (name, these, others) in [(a, &first.log, &second.log), (b, &second.log, &first.log)] {
            for record in only(these, others).iter().take(3) {
                problems += &format!("only {name} asks {record:08x?}\n");
            }
        }
        if problems.is_empty() { Ok(()) } else { Err(format!("{a} and {b} differ\n{problems}")) }
    }
}

/// Removes one such record; true if there was none.
fn remove(records: &mut Vec<Record>, record: &Record) -> bool {
    match records.binary_search(record) {
        Ok(at) => {
            records.remove(at);
            false
        }
        Err(_) => true,
    }
}
