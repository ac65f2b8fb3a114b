//! The arguments of the command, and what it does.

use std::path::PathBuf;
use std::time::Instant;

use clap::{Args, ValueHint};
use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::specialise::Asking;
use phenomenon_runtime::film;
use phenomenon_runtime::link::{NodePath, TextValue};
use phenomenon_runtime::render::{Region, RenderError, Rendered, Settings, render_region};
use phenomenon_runtime::scene_file::SceneOptions;

use super::cost::Cost;
use super::named;
use crate::arguments::{self, Size};
use crate::failure::{Failure, Outcome};
use crate::graphs::{self, EngineArguments};
use crate::outputs::{self, Output};
use crate::scenes::{self, Flags, Picture};
use crate::terminal;

/// Render a picture of a scene, or of a graph in the default scene.
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

    /// Width and height in pixels; otherwise as the scene says
    #[arg(long, value_name = "WxH", value_parser = arguments::size)]
    size: Option<Size>,

    /// Render this part alone: the same pixels, in a file of its size
    #[arg(long, value_name = "X,Y,W,H", value_parser = arguments::region)]
    region: Option<Region>,

    /// Samples of every pixel; otherwise as the scene says
    #[arg(long, value_name = "N", value_parser = arguments::samples)]
    spp: Option<u32>,

    /// Threads; otherwise as many as the machine has
    #[arg(long, value_name = "N", value_parser = arguments::threads)]
    threads: Option<usize>,

    /// Seed of all random numbers; otherwise as the scene says
    #[arg(long, value_name = "N", value_parser = arguments::seed)]
    seed: Option<u64>,

    /// Give parameters the values of this preset of the graph; --set counts before it; in a scene OBJECT:NAME, which
    /// may be repeated
    #[arg(long, value_name = "NAME")]
    preset: Vec<String>,

    /// Give a parameter another value; in a scene OBJECT:NAME=VALUE; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = arguments::assignment)]
    set: Vec<TextValue>,

    /// Show this node of the graph, or this output of it, a vector as red, green and blue, a truth value as white or black;
    /// in a scene OBJECT:NODE
    #[arg(long, value_name = "NODE[.OUTPUT]", value_parser = NodePath::read)]
    node: Option<NodePath>,

    /// Where the picture goes; otherwise NAME.png here, for a file called NAME.json, where no other
    /// file is called so
    #[arg(short, value_name = "FILE.png|exr|hdr", value_parser = arguments::picture,
          value_hint = ValueHint::FilePath)]
    output: Option<PathBuf>,

    /// Multiply the colours of a PNG by this
    #[arg(long, value_name = "FACTOR", default_value = "1", value_parser = arguments::exposure)]
    exposure: f32,

    /// Write counts of rays, points and evaluations of nodes, and times, as JSON; counting takes time
    #[arg(long, value_name = "FILE.json", value_hint = ValueHint::FilePath)]
    stats: Option<PathBuf>,

    /// Do all that shaders could ask for at every point, whether their weights want it or not, and throw it away: no bit
    /// of the picture changes. It is what `phenomenon effects` measures savings against, and takes much longer
    #[arg(long)]
    all_effects: bool,

    /// Say nothing of findings with this code that are no errors; may be repeated
    #[arg(long, value_name = "CODE", value_parser = arguments::allowable)]
    allow: Vec<Code>,

    /// Say nothing but what is wrong
    #[arg(long)]
    quiet: bool,
}

const EXAMPLES: &str = "\
PNG is sRGB-encoded; EXR and HDR keep scene-linear values. The picture depends on the file, size,
samples, seed and parameters alone: engine (but monolith), threads, batch and simd change no bit.

Values count in this order: --set, --preset, `set` in the scene, its `preset`, the default of the parameter. In a scene,
OBJECT is the name of an object, `objects[2]`, or `environment`. Numbers are written as in files
(0.5, not .5), arrays and structs as well: --set 'layers=[…]', or part by part: layers[2].tint=1,0,0.

--stats counts evaluations of nodes by engine: those that are wanted, by a point and what its colour depends
on, and those that are done. walk does what is wanted. batch and jit evaluate nodes that ask nothing for
eight points at once, and leave out what is heavy where none of the eight wants it.

Examples:
  phenomenon render graphs/glass/advanced_glass.json
  phenomenon render graphs/glass/advanced_glass.json --set ior=1.3 --size 256x256 --spp 64 -o glass.exr
  phenomenon render graphs/glass/advanced_glass.json --node fresnel --engine walk -o fresnel.png
  phenomenon render scenes/teapot.json --threads 2 --stats teapot-stats.json
  phenomenon render scenes/teapot.json --set floor:size=2 --node teapot:cosine --region 128,128,64,64
  phenomenon render graphs/glass/advanced_glass.json --scene scenes/default.json";

/// Runs the command.
///
/// # Errors
/// A graph or scene that cannot be used, a value that does not suit its name, or a file that
/// cannot be written; the last is found out before rendering.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let output = match &arguments.output {
        Some(path) => path.clone(),
        None => named::name(&arguments.file)?,
    };
    let picture_file = Output { flag: "-o", path: &output };
    let stats = arguments.stats.as_deref().map(|path| Output { flag: "--stats", path });
    let outputs: Vec<Output<'_>> = std::iter::once(picture_file).chain(stats).collect();
    outputs.iter().try_for_each(|output| output.require_writable())?;
    if arguments.all_effects {
        graphs::require_nodes(&arguments.engine, "--all-effects")?;
    }
    let library = NodeLibrary::standard();
    let flags = Flags {
        set: &arguments.set,
        preset: &arguments.preset,
        node: arguments.node.as_ref(),
        stage: arguments.scene.as_deref(),
        allow: &arguments.allow,
        count: arguments.stats.is_some(),
        asking: if arguments.all_effects { Asking::All } else { Asking::Guarded },
        silent: false,
    };
    let picture = scenes::load(&arguments.file, &library, &arguments.engine, &flags)?;
    outputs::require_apart(&outputs)?;
    let is_named = arguments.output.is_none();
    if is_named {
        named::require_replaceable(&output)?;
    }
    let settings = settings(arguments, &picture);
    let start = Instant::now();
    let rendered = render(&picture, &settings, arguments)?;
    picture.require_jit()?;
    let cost = Cost {
        engine: arguments.engine.engine,
        settings,
        region: arguments.region,
        statistics: rendered.statistics,
        points: picture.points(arguments.engine.engine, rendered.statistics.points),
        evaluations: picture.evaluations(),
        check_milliseconds: picture.check_milliseconds,
        compile_milliseconds: picture.compile_milliseconds(),
        render_milliseconds: start.elapsed().as_secs_f64() * 1e3,
    };
    let bytes = film::encode(&rendered.film, &output, arguments.exposure).map_err(|error| {
        let help = error.help();
        Failure::new(error, help)
    })?;
    if is_named {
        // Rendering takes long enough for something else to get the name.
        named::require_replaceable(&output)?;
    }
    picture_file.write(if is_named { named::marked(bytes) } else { bytes })?;
    if let Some(stats) = stats {
        stats.write(cost.json())?;
    }
    if !arguments.quiet {
        terminal::tell(&format!("{}: {}", output.display(), cost.summary()));
    }
    Ok(Outcome::Fine)
}

fn settings(arguments: &Arguments, picture: &Picture) -> Settings {
    let SceneOptions { width, height, samples, seed, .. } = picture.options;
    let size = arguments.size.unwrap_or(Size { width, height });
    Settings {
        width: size.width,
        height: size.height,
        samples: arguments.spp.unwrap_or(samples),
        seed: arguments.seed.unwrap_or(seed),
        threads: arguments.threads.unwrap_or(0),
        batch: arguments.engine.batch as usize,
        ..Settings::default()
    }
}

fn render(
    picture: &Picture,
    settings: &Settings,
    arguments: &Arguments,
) -> Result<Rendered, Failure> {
    let bar = terminal::progress("tiles", arguments.quiet);
    let progress = |done: usize, total: usize| {
        bar.set_length(total as u64);
        bar.set_position(done as u64);
    };
    let rendered = match arguments.region {
        Some(region) => render_region(&picture.scene, settings, region, &progress),
        None => phenomenon_runtime::render::render(&picture.scene, settings, &progress),
    };
    bar.finish_and_clear();
    rendered.map_err(|error| match error {
        RenderError::Region { .. } => {
            let help = format!(
                "X + W is at most {}, and Y + H at most {}; --size changes that",
                settings.width, settings.height
            );
            Failure::new(format!("--region: {error}"), help)
        }
        error @ RenderError::Threads { .. } => {
            Failure::new(error, "give a smaller number of them by --threads, such as --threads 1")
        }
        error => Failure::new(error, "choose other values for --size or --spp"),
    })
}
