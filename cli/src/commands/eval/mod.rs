//! `phenomenon eval`.

mod state_fields;
mod values;

use std::path::PathBuf;
use std::sync::Arc;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueHint};
use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::engine::{Engine, Options, Shade, Shaded};
use phenomenon_compiler::graph::{Binding, Graph, RootKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::state::State;
use phenomenon_compiler::values::Literal;
use phenomenon_runtime::link::{NodePath, ShowNodeError, TextValue};
use phenomenon_runtime::render::EmptyScene;

use self::values::Evaluation;
use crate::arguments::{self, EngineChoice, Format};
use crate::failure::{Failure, Outcome};
use crate::graphs::{self, EngineArguments, Told};
use crate::terminal;

/// Evaluate a graph, or one of its nodes, at one shading point.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A graph file, or `-` for standard input
    #[arg(value_hint = ValueHint::FilePath)]
    graph: PathBuf,

    /// Give a parameter another value than its default; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = arguments::assignment)]
    set: Vec<TextValue>,

    /// Give a field of the state a value; may be repeated
    #[arg(long, value_name = "FIELD=VALUE", value_parser = arguments::assignment)]
    state: Vec<TextValue>,

    /// Evaluate this node instead of a root: all of its outputs, or the one named
    #[arg(long, value_name = "NODE[.OUTPUT]", value_parser = NodePath::read)]
    node: Option<NodePath>,

    /// Which root to evaluate
    #[arg(long, value_name = "SHADER_TYPE", default_value = "material", conflicts_with = "node",
          value_parser = root_kind())]
    root: RootKind,

    #[command(flatten)]
    engine: EngineArguments,

    /// Say nothing of findings with this code that are no errors; may be repeated
    #[arg(long, value_name = "CODE", value_parser = arguments::allowable)]
    allow: Vec<Code>,

    /// How to print
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

const EXAMPLES: &str = "\
The state is that of a ray along -z which hits a plane at the origin from distance 1. Fields:
  vectors  origin direction point normal normal_geom
  numbers  dot_nd dist ior ior_in u v time raster_x raster_y
  others   inv_normal ray_type reflection_level refraction_level incoming
Directions and normals are brought to unit length; normal_geom follows normal, and dot_nd follows
normal and direction, where they are not given. The scene round the point is empty: rays hit
nothing and return black, not ok; there are no lights.

Examples:
  phenomenon eval graphs/glass/advanced_glass.json
  phenomenon eval graphs/glass/advanced_glass.json --set ior=1.3 --state direction=0.6,0,-0.8
  phenomenon eval graphs/rainbow/rainbow.json --node turn --state normal=0,0.6,0.8 --format json";

/// Runs the command.
///
/// # Errors
/// A graph that cannot be used, or a value that does not suit its name.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let Some(engine) = arguments.engine.engine.compiled() else {
        return Err(Failure::new(
            "--engine monolith: a monolith has no nodes to evaluate",
            "choose walk, batch or jit",
        ));
    };
    // One point is soon shaded by kernels; code that comes later would only be thrown away.
    let engine = if arguments.engine.engine == EngineChoice::Auto { Engine::Batch } else { engine };
    let (state, notes) = state_fields::state(&arguments.state)?;
    let library = Arc::new(NodeLibrary::standard());
    let graph = Told { allow: &arguments.allow }.read(&arguments.graph, &library)?;
    let values = graphs::bind(&graph, &arguments.set)?;
    notes.iter().for_each(|note| terminal::tell(note));
    let point = Point {
        library: &library,
        values: &values,
        options: arguments.engine.options(engine),
        state,
    };
    let evaluation = match &arguments.node {
        Some(path) => point.node(&graph, path)?,
        None => point.root(&graph, arguments.root)?,
    };
    match arguments.format {
        Format::Human => terminal::print(&evaluation.human()),
        Format::Json => terminal::print_exactly(&evaluation.json()),
    }?;
    Ok(Outcome::Fine)
}

/// The shader types by name.
fn root_kind() -> impl TypedValueParser<Value = RootKind> {
    let find = |name: String| RootKind::ALL.into_iter().find(|kind| kind.name() == name);
    PossibleValuesParser::new(RootKind::ALL.map(RootKind::name))
        .try_map(move |name| find(name).ok_or("there is no such shader type"))
}

/// What a graph is evaluated with.
struct Point<'a> {
    library: &'a Arc<NodeLibrary>,
    values: &'a [(String, Literal)],
    options: Options,
    state: State,
}

impl Point<'_> {
    fn root(&self, graph: &Graph, kind: RootKind) -> Result<Evaluation, Failure> {
        let Some(root) = graph.root(kind) else {
            let names: Vec<&str> = graph.roots.iter().map(|root| root.kind.name()).collect();
            return Err(Failure::new(
                format!("--root {}: `{}` has no such root", kind.name(), graph.name),
                format!("its roots: {}; `--node` evaluates a node", names.join(", ")),
            ));
        };
        let name = match &root.color {
            Binding::Node { node, output } => self.name(graph, *node, *output),
            _ => format!("root.{}", kind.name()),
        };
        let mut alone = graph.clone();
        alone.roots.retain(|root| root.kind == kind);
        let shaded = self.shade(alone, kind)?;
        let mut evaluation = Evaluation::default();
        evaluation.add(name, kind.value_type(), shaded.color);
        evaluation.ok = Some(shaded.ok);
        Ok(evaluation)
    }

    fn node(&self, graph: &Graph, path: &NodePath) -> Result<Evaluation, Failure> {
        let (node, output) = path.find(graph, self.library).map_err(|error| {
            graphs::not_shown(&ShowNodeError::Missing { path: path.clone(), error })
        })?;
        let signature = self.library.signature(graph.nodes[node].node_type);
        let outputs = match output {
            Some(output) => output..output + 1,
            None => 0..signature.outputs.len(),
        };
        let mut evaluation = Evaluation::default();
        for output in outputs {
            let mut alone = graph
                .with_root(self.library, node, output)
                .map_err(|error| graphs::not_shown(&error.into()))?;
            alone.roots.retain(|root| root.kind == RootKind::Material);
            let shaded = self.shade(alone, RootKind::Material)?;
            let value_type = graph.output_type(self.library, node, output);
            evaluation.add(self.name(graph, node, output), value_type, shaded.color);
        }
        Ok(evaluation)
    }

    fn name(&self, graph: &Graph, node: usize, output: usize) -> String {
        let node = &graph.nodes[node];
        let outputs = &self.library.signature(node.node_type).outputs;
        format!("{}.{}", node.name, outputs[output].name)
    }

    fn shade(&self, graph: Graph, kind: RootKind) -> Result<Shaded, Failure> {
        let shader = graphs::compile(graph, self.library, self.values, self.options)?;
        let mut results = [Shaded::default()];
        let mut scene = EmptyScene::new(&shader.textures())
            .map_err(|error| Failure::new(error, "mend the file, or name another"))?;
        shader.shade(kind, &[self.state], &mut scene, &mut results);
        Ok(results[0])
    }
}
