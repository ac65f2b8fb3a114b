//! The arguments of the command, and what it does.

use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueHint};
use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::engine::Engine;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_runtime::link::{NodePath, TextValue};

use super::point::Point;
use super::state_fields;
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

    /// Give parameters the values of this preset of the graph; --set counts before it
    #[arg(long, value_name = "NAME")]
    preset: Option<String>,

    /// Give a parameter another value than its default; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = arguments::assignment)]
    set: Vec<TextValue>,

    /// Give a field of the state a value; may be repeated
    #[arg(long, value_name = "FIELD=VALUE", value_parser = arguments::assignment)]
    state: Vec<TextValue>,

    /// Evaluate this node instead of a root: all of its outputs, or the one named; or an output of the graph
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
  surface  derivative_u derivative_v vertex_color second_u second_v dp_dx dp_dy du_dx dv_dx
           du_dy dv_dy
  object   object_id object_random object_to_world world_to_object
  camera   camera_to_world world_to_camera camera_height
Directions and normals are brought to unit length; normal_geom follows normal, dot_nd follows normal
and direction, second_u and second_v follow u and v, and a transform follows the one that undoes it,
where they are not given. The scene round the point is empty: rays hit
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
    let (place, notes) = state_fields::place(&arguments.state)?;
    let graph = Told { allow: &arguments.allow, errors_only: false }
        .read(&arguments.graph, &NodeLibrary::standard())?;
    let values = graphs::bind(&graph, arguments.preset.as_deref(), &arguments.set)?;
    notes.iter().for_each(|note| terminal::tell(note));
    let point = Point { values: &values, options: arguments.engine.options(engine), place };
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
