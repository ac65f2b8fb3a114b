//! `phenomenon bench render`.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::{Args, ValueHint};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_runtime::render::{Settings, Statistics, render};
use serde_json::{Value, json};

use super::results::Results;
use super::statistics::median;
use crate::arguments::{self, EngineChoice, Precision, SimdChoice, Size};
use crate::failure::{Failure, Outcome};
use crate::graphs::EngineArguments;
use crate::inputs;
use crate::outputs;
use crate::scenes::{self, Flags, Picture};
use crate::terminal;

/// Render the same picture with every engine in turn, several times, and print the medians.
#[derive(Debug, Args)]
#[command(after_help = NOTES)]
pub struct Arguments {
    /// A graph or scene file
    #[arg(value_hint = ValueHint::FilePath)]
    file: PathBuf,

    /// Give parameters the values of this preset of the graph; --set counts before it; in a scene OBJECT:NAME, which
    /// may be repeated
    #[arg(long, value_name = "NAME")]
    preset: Vec<String>,

    /// Width and height in pixels; otherwise as the scene says
    #[arg(long, value_name = "WxH", value_parser = arguments::size)]
    size: Option<Size>,

    /// Samples of every pixel; otherwise as the scene says
    #[arg(long, value_name = "N", value_parser = arguments::samples)]
    spp: Option<u32>,

    /// Threads; otherwise as many as the machine has
    #[arg(long, value_name = "N", value_parser = arguments::threads)]
    threads: Option<usize>,

    /// Runs of each engine; the median is printed
    #[arg(long, value_name = "N", default_value = "5",
          value_parser = arguments::runs)]
    runs: u8,

    /// Write the rows to render.json in this folder
    #[arg(short, value_name = "DIR", value_hint = ValueHint::DirPath)]
    output: Option<PathBuf>,
}

const NOTES: &str = "\
Engines take turns, so that a slow minute of the machine touches all of them. Ratios are medians of
the ratios of one turn, to walk. \"shading\" is time inside shaders, without what they ask of the
renderer, measured on a part of the batches. Every engine renders once before the clock starts, with
which the jit's code is made.";

/// The engines that are compared; the first is the baseline.
const ENGINES: [EngineChoice; 4] =
    [EngineChoice::Walk, EngineChoice::Batch, EngineChoice::Jit, EngineChoice::Monolith];

struct Contender {
    engine: EngineChoice,
    picture: Picture,
    runs: Vec<Statistics>,
}

impl Contender {
    fn render(&self, arguments: &Arguments) -> Result<Statistics, Failure> {
        let settings = settings(arguments, &self.picture);
        let rendered = render(&self.picture.scene, &settings, &|_, _| ())
            .map_err(|error| Failure::new(error, "choose another size or number of samples"))?;
        Ok(rendered.statistics)
    }
}

/// Runs the command.
///
/// # Errors
/// A file that cannot be used or rendered, or a folder that cannot be written.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    if inputs::is_stream(&arguments.file) {
        return Err(Failure::new(
            "every engine reads the file, and standard input can be read once",
            "give the path of a file instead of `-`",
        ));
    }
    let folder = arguments.output.as_deref();
    let results = folder.map(|folder| Results::new(folder, "render")).transpose()?;
    let library = NodeLibrary::standard();
    let mut contenders = Vec::new();
    for engine in ENGINES {
        let run = EngineArguments {
            engine,
            jit: None,
            precision: Precision::default(),
            simd: SimdChoice::default(),
            batch: 256,
        };
        let flags = Flags { preset: &arguments.preset, ..Flags::default() };
        match scenes::load(&arguments.file, &library, &run, &flags) {
            Ok(picture) if engine == EngineChoice::Monolith && picture.compiles() => {
                terminal::tell("without monolith: some of the scene is not written by hand");
            }
            Ok(picture) => contenders.push(Contender { engine, picture, runs: Vec::new() }),
            // Not every graph is written by hand, and not every machine has the jit.
            Err(failure) if !contenders.is_empty() => {
                terminal::tell(&format!("without {}: {failure}", engine.name()));
            }
            Err(failure) => return Err(failure),
        }
    }
    let output = results.as_ref().map(Results::output);
    outputs::require_apart(output.as_slice())?;
    let bar = terminal::progress("renderings", false);
    bar.set_length(u64::from(arguments.runs) * contenders.len() as u64);
    // Code is made with the first points that need it: before the clock starts.
    for contender in &contenders {
        contender.render(arguments)?;
        contender.picture.require_jit()?;
    }
    for _ in 0..arguments.runs {
        for contender in &mut contenders {
            let statistics = contender.render(arguments)?;
            contender.runs.push(statistics);
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    terminal::print(&table(arguments, &contenders))?;
    if let Some(results) = results {
        results.write(&rows(arguments, &contenders))?;
    }
    Ok(Outcome::Fine)
}

fn settings(arguments: &Arguments, picture: &Picture) -> Settings {
    let options = &picture.options;
    Settings {
        width: arguments.size.map_or(options.width, |size| size.width),
        height: arguments.size.map_or(options.height, |size| size.height),
        samples: arguments.spp.unwrap_or(options.samples),
        seed: options.seed,
        threads: arguments.threads.unwrap_or(0),
        ..Settings::default()
    }
}

fn whole(run: &Statistics) -> f64 {
    run.whole_milliseconds
}

fn shading(run: &Statistics) -> f64 {
    run.shading_milliseconds
}

/// The median of one figure, and of its ratio to the baseline's in the same turn.
fn figure(of: &Contender, baseline: &Contender, figure: fn(&Statistics) -> f64) -> (f64, f64) {
    let turns = of.runs.iter().zip(&baseline.runs);
    let ratios = turns.map(|(run, base)| figure(run) / figure(base));
    (median(of.runs.iter().map(figure)), median(ratios))
}

fn rays(of: &Contender) -> u64 {
    of.runs.last().map_or(0, |run| {
        let rays = &run.rays;
        rays.eye + rays.reflection + rays.refraction + rays.transparent + rays.probe + rays.shadow
    })
}

fn table(arguments: &Arguments, contenders: &[Contender]) -> String {
    let baseline = &contenders[0];
    let settings = settings(arguments, &baseline.picture);
    let threads = baseline.runs.last().map_or(0, |run| run.threads);
    let mut text = format!(
        "{}: {}x{}, {} samples, {threads} threads, median of {} runs\n\n\
         | engine | shading ms | to walk | whole ms | to walk | rays |\n\
         | --- | ---: | ---: | ---: | ---: | ---: |\n",
        arguments.file.display(),
        settings.width,
        settings.height,
        settings.samples,
        arguments.runs,
    );
    for of in contenders {
        let (shading, shading_ratio) = figure(of, baseline, shading);
        let (whole, whole_ratio) = figure(of, baseline, whole);
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "| {} | {shading:.0} | {shading_ratio:.2} | {whole:.0} | {whole_ratio:.2} | {} |",
            of.engine.name(),
            rays(of),
        );
    }
    text
}

fn rows(arguments: &Arguments, contenders: &[Contender]) -> Vec<Value> {
    let material = arguments.file.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    contenders
        .iter()
        .map(|of| {
            json!({
                "material": material,
                "engine": of.engine.name(),
                "threads": of.runs.last().map_or(0, |run| run.threads),
                "whole_ms": figure(of, &contenders[0], whole).0,
                "shading_ms": figure(of, &contenders[0], shading).0,
                "rays": rays(of),
            })
        })
        .collect()
}
