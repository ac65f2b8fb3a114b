//! The arguments of the command, and what it does.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::specialise::Asking;
use phenomenon_runtime::link::TextValue;
use phenomenon_runtime::render::Settings;

use super::measured::Measured;
use super::{human, json};
use crate::arguments::{self, Format, Size};
use crate::failure::{Failure, Outcome};
use crate::graphs::{self, EngineArguments};
use crate::inputs;
use crate::scenes::{self, Flags};
use crate::terminal;

/// Tell which effects a scene calls for, why, and what they cost.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A graph or scene file, or `-` for standard input
    #[arg(value_hint = ValueHint::FilePath)]
    file: PathBuf,

    #[command(flatten)]
    engine: EngineArguments,

    /// Show the graph in this scene, in place of its `{ "subject": true }`, and not in the default one
    #[arg(long, value_name = "STAGE.json")]
    scene: Option<PathBuf>,

    /// Width and height in pixels of the picture that is rendered to measure
    #[arg(long, value_name = "WxH", default_value = "96x96", value_parser = arguments::size)]
    size: Size,

    /// Samples of every pixel of it
    #[arg(long, value_name = "N", default_value = "4", value_parser = arguments::samples)]
    spp: u32,

    /// Give parameters the values of this preset of the graph; --set counts before it; in a scene OBJECT:NAME, which
    /// may be repeated
    #[arg(long, value_name = "NAME")]
    preset: Vec<String>,

    /// Give a parameter another value; in a scene OBJECT:NAME=VALUE; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = arguments::assignment)]
    set: Vec<TextValue>,

    /// Do not render with all effects on, which may take many times as long: nothing is told of what is saved
    #[arg(long)]
    no_savings: bool,

    /// Most rays of the picture with all effects on: where it takes more, what is saved is not measured
    #[arg(long, value_name = "N", default_value = "10000000", value_parser = arguments::rays)]
    most_rays: u64,

    /// Say nothing of findings with this code that are no errors; may be repeated
    #[arg(long, value_name = "CODE", value_parser = arguments::allowable)]
    allow: Vec<Code>,

    /// How to print
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

const EXAMPLES: &str = "\
An effect is on where a node may ask for it once the graphs are specialised to their parameters and to the type of
ray; the row names that node. Where it is off, the row says what rules it out: a condition that is decided before
shading, with the input, the parameter and its value, or a fact about the scene. Costs are those of a small picture,
rendered on one thread; savings are held against the same picture with all effects on (`render --all-effects`). Time
that goes into shading what a ray meets counts for that ray, and reading the clock that often takes time itself.

Examples:
  phenomenon effects graphs/glass/advanced_glass.json
  phenomenon effects graphs/glass/advanced_glass.json --set opacity=1
  phenomenon effects scenes/teapot.json --size 64x64 --spp 1 --format json";

/// Runs the command.
///
/// # Errors
/// A graph or scene that cannot be used, or a value that does not suit its name.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    graphs::require_nodes(&arguments.engine, "effects")?;
    let library = NodeLibrary::standard();
    let with_savings = !arguments.no_savings;
    if with_savings && inputs::is_stream(&arguments.file) {
        return Err(Failure::new(
            "what is saved is measured by reading the file twice, and standard input can be read once",
            "give the path of a file instead of `-`, or --no-savings",
        ));
    }
    let flags = |asking| Flags {
        set: &arguments.set,
        preset: &arguments.preset,
        stage: arguments.scene.as_deref(),
        allow: &arguments.allow,
        asking,
        ..Flags::default()
    };
    let load = |flags| scenes::load(&arguments.file, &library, &arguments.engine, &flags);
    let picture = load(flags(Asking::Guarded))?;
    let settings = Settings {
        width: arguments.size.width,
        height: arguments.size.height,
        samples: arguments.spp,
        seed: picture.options.seed,
        threads: 1,
        batch: arguments.engine.batch as usize,
        every_queue_timed: true,
        ..Settings::default()
    };
    let mut measured = Measured::of(&picture, settings)?;
    // One of the two scenes is held at a time.
    drop(picture);
    if with_savings {
        let all = load(Flags { silent: true, ..flags(Asking::All) }).map_err(|error| {
            let message = format!("with all effects on: {error}");
            Failure::new(message, "mend it, or leave out what is saved: --no-savings")
        })?;
        measured.compare(&all, arguments.most_rays)?;
    }
    match arguments.format {
        Format::Human => {
            let what = arguments.file.display().to_string();
            terminal::print(&human::text(&what, &measured))?;
        }
        Format::Json => terminal::print_exactly(&json::text(&measured))?,
    }
    Ok(Outcome::Fine)
}
