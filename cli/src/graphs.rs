//! Graph files, parameters and engines, as every command that shades needs them.

use std::path::Path;
use std::sync::Arc;

use clap::Args;
use phenomenon_compiler::check::{Checked, check_graph};
use phenomenon_compiler::diagnostics::{Code, Finding, Severity};
use phenomenon_compiler::document::all_mistakes;
use phenomenon_compiler::engine::jit::JitError;
use phenomenon_compiler::engine::{Engine, Options, Shader, ShaderError};
use phenomenon_compiler::graph::{Graph, NoSuchPreset};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::values::Literal;
use phenomenon_runtime::link::{ShowNodeError, TextValue, ValueError, ValueFault, bind_texts};

use crate::arguments::{self, EngineChoice, GeneratorChoice, Precision, SimdChoice};
use crate::failure::Failure;
use crate::inputs;
use crate::report;

/// The flags that say how a graph is run.
#[derive(Debug, Args)]
pub struct EngineArguments {
    /// What runs the graph; no choice but monolith changes a bit of the result
    #[arg(long, value_enum, default_value_t)]
    pub engine: EngineChoice,

    /// What makes the machine code of the engines auto and jit; without it the best there is on this machine
    #[arg(long, value_enum, value_name = "GENERATOR")]
    pub jit: Option<GeneratorChoice>,

    /// How exactly
    #[arg(long, value_enum, default_value_t)]
    pub precision: Precision,

    /// Forms of the node bodies, for tests: the same bits
    #[arg(long, value_enum, default_value_t)]
    pub simd: SimdChoice,

    /// Most points shaded at once, for tests: the same bits
    #[arg(long, value_name = "N", default_value = "256", value_parser = arguments::batch)]
    pub batch: u32,
}

impl EngineArguments {
    /// Options of the compiler for one of its engines.
    pub fn options(&self, engine: Engine) -> Options {
        Options {
            engine,
            simd: self.simd.into(),
            generator: self.jit.map(Into::into),
            batch: self.batch as usize,
            ..Options::default()
        }
    }
}

/// What is told of findings that are no errors.
#[derive(Clone, Copy, Debug, Default)]
pub struct Told<'a> {
    /// `--allow`: codes of which nothing is said.
    pub allow: &'a [Code],
    /// Whether errors alone are told.
    pub errors_only: bool,
}

impl Told<'_> {
    /// Writes findings to standard error, but for what is allowed.
    pub fn tell(self, findings: &[Finding], omitted: usize) {
        let told = findings.iter().filter(|finding| {
            let allowed = self.errors_only || self.allow.contains(&finding.code);
            finding.severity == Severity::Error || !allowed
        });
        let omitted = if self.errors_only { 0 } else { omitted };
        report::tell(&told.cloned().collect::<Vec<_>>(), omitted);
    }

    /// Reads and checks a graph, from standard input for `-`; what was found goes to standard error.
    ///
    /// # Errors
    /// The file cannot be read, or has errors.
    pub fn read(self, path: &Path, library: &NodeLibrary) -> Result<Graph, Failure> {
        let checked = match inputs::read(path) {
            Ok(document) => check_graph(&document, library),
            Err(finding) => Checked { findings: all_mistakes(*finding), ..Checked::default() },
        };
        self.checked(path, checked)
    }

    /// The graph that was checked; what was found goes to standard error.
    ///
    /// # Errors
    /// There were errors.
    pub fn checked(self, path: &Path, checked: Checked) -> Result<Graph, Failure> {
        self.tell(&checked.findings, checked.omitted);
        checked.graph.ok_or_else(|| unusable(path))
    }
}

/// Reads and checks a graph, from standard input for `-`; what was found goes to standard error.
///
/// # Errors
/// The file cannot be read, or has errors.
pub fn read(path: &Path, library: &NodeLibrary) -> Result<Graph, Failure> {
    Told::default().read(path, library)
}

/// The failure after findings that were shown.
pub fn unusable(path: &Path) -> Failure {
    Failure::new(
        format!("{} cannot be used", path.display()),
        "mend the errors above; `phenomenon check` shows them all",
    )
}

/// The values of `--set`, and those of `--preset` for the other parameters of a graph.
///
/// # Errors
/// There is no such parameter, it is set twice, or the value does not suit it; or no such preset.
pub fn bind(
    graph: &Graph,
    preset: Option<&str>,
    set: &[TextValue],
) -> Result<Vec<(String, Literal)>, Failure> {
    let set = bind_texts(graph, set).map_err(|error| bad_value("", &error))?;
    let Some(preset) = preset else { return Ok(set) };
    match graph.preset(preset) {
        Ok(preset) => Ok(preset.with(set)),
        Err(error) => Err(no_preset("", &error)),
    }
}

/// The failure of a `--preset`; `object` stands before the name on the command line.
pub fn no_preset(object: &str, error: &NoSuchPreset) -> Failure {
    Failure::new(format!("--preset {object}{}: {error}", error.name), &error.advice.help)
}

/// Fails where monoliths are to run instead of graphs, for something that looks at nodes.
///
/// # Errors
/// They are.
pub fn require_nodes(engine: &EngineArguments, what: &str) -> Result<(), Failure> {
    match engine.engine {
        EngineChoice::Monolith => Err(Failure::new(
            format!("{what} with --engine monolith: what a monolith asks for is written into it"),
            "choose walk, batch or jit",
        )),
        _ => Ok(()),
    }
}

/// The failure of a `--set`; `object` stands before the name on the command line: `floor:`, or nothing.
pub fn bad_value(object: &str, error: &ValueError) -> Failure {
    let help = match error.fault {
        ValueFault::Twice(_) => "leave one of them out",
        ValueFault::Unsuitable(_) => "",
    };
    Failure::new(format!("--set {object}{error}"), help)
}

/// The failure of a `--node`.
pub fn not_shown(error: &ShowNodeError) -> Failure {
    match error {
        ShowNodeError::ByHand => {
            Failure::new(format!("--engine monolith: {error}"), "choose walk, batch or jit")
        }
        ShowNodeError::Missing { error: missing, .. } => {
            Failure::new(format!("--node {error}"), missing.help())
        }
        ShowNodeError::NoValue(_) => Failure::new(format!("--node: {error}"), ""),
    }
}

/// Compiles a graph.
///
/// # Errors
/// It is too large for the engine, or the engine does not run here.
pub fn compile(
    graph: Graph,
    values: &[(String, Literal)],
    options: Options,
) -> Result<Shader, Failure> {
    let name = graph.name.clone();
    let shader = Shader::new(Arc::new(graph), values, options);
    shader.map_err(|error| not_compiled(&name, &error))
}

/// The failure of the jit to make the code of a graph that is shaded already.
pub fn jit_failed(error: &JitError) -> Failure {
    Failure::new(format!("the jit cannot run this graph: {error}"), "use `--engine batch`")
}

/// The failure of a graph that cannot be compiled.
pub fn not_compiled(graph: &str, error: &ShaderError) -> Failure {
    let help = if matches!(error, ShaderError::Jit(_)) { "use `--engine batch`" } else { "" };
    Failure::new(format!("`{graph}`: {error}"), help)
}
