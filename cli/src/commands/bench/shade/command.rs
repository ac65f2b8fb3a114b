//! The arguments of the command, and what it does.

use std::path::PathBuf;

use clap::{Args, ValueEnum, ValueHint};
use phenomenon_compiler::nodes::NodeLibrary;

use super::column::Column;
use super::race::{self, Race};
use super::subject::Subject;
use super::tables;
use crate::arguments;
use crate::commands::bench::generators;
use crate::commands::bench::results::Results;
use crate::commands::bench::workloads::STATES;
use crate::failure::{Failure, Outcome};
use crate::terminal;

/// Shade points of five workloads and eight materials with every engine in turn and print the medians.
#[derive(Debug, Args)]
#[command(after_help = NOTES)]
pub struct Arguments {
    /// Measure this workload or material only; may be repeated
    #[arg(long, value_enum, value_name = "NAME")]
    workload: Vec<Subject>,

    /// Turns of each engine; the median is printed
    #[arg(long, value_name = "N", default_value = "9", value_parser = arguments::runs)]
    runs: u8,

    /// Write the rows to shade.json in this folder
    #[arg(short, value_name = "DIR", value_hint = ValueHint::DirPath)]
    output: Option<PathBuf>,
}

const NOTES: &str = "\
A workload is a graph that asks nothing of a renderer, shaded at 1024 points in calls of 1, 16 and
256. The monolith is the same by hand: scalar Rust with the functions of its standard library; monolith8
is written with the instructions of AVX2, for \"ten\" and \"mixed\". fused8 is what rustc makes of the
bodies of all nodes as one body, eight lanes wide: the bound for the jit.

A material is one of the thesis, at 1024 points of it that a picture of the default scene shades, mirror
images and what is seen through glass among them. Its rays and lights are answered from a table that was
recorded before, the same for all: shading alone is measured. monolith_same_bits is the monolith over the
arithmetic of the nodes, which gives the bits of the graph; jit_eager is the jit of a graph that leaves
nothing out. The last table counts what laziness saves: rays, colours of light samples, and evaluations of nodes.

What is measured is CPU time of one thread, after everything is compiled and has run once. Engines
take turns of some 10 ms, so that a slow minute of the machine touches all of them. Ratios are medians
of the ratios of one turn, at the same number of points a call. \"spread\" is the distance between the
quartiles of all turns, over their median.";

/// Runs the command.
///
/// # Errors
/// A folder that cannot be written.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let folder = arguments.output.as_deref();
    let results = folder.map(|folder| Results::new(folder, "shade")).transpose()?;
    let library = NodeLibrary::standard();
    let columns = columns();
    let (mut races, mut saved) = (Vec::new(), Vec::new());
    for &subject in Subject::value_variants() {
        if !arguments.workload.is_empty() && !arguments.workload.contains(&subject) {
            continue;
        }
        match subject {
            Subject::Workload(workload) => {
                races.extend(race::of_workload(workload, &columns, &library)?);
            }
            Subject::Material(material) => {
                let (of_material, by_laziness) = race::of_material(material, &columns, &library)?;
                races.extend(of_material);
                saved.push((subject, by_laziness));
            }
        }
    }
    let bar = terminal::progress("turns", false);
    bar.set_length(u64::from(arguments.runs) * races.len() as u64);
    for _ in 0..arguments.runs {
        for race in &mut races {
            race.take_turn();
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    races.iter().try_for_each(Race::require_answers)?;
    let runs = arguments.runs;
    let head =
        format!("ns a point, CPU time of one thread, {STATES} points, median of {runs} turns\n");
    let tables = [tables::workloads(&races), tables::materials(&races), tables::laziness(&saved)];
    let tables = tables.iter().filter(|table| !table.is_empty());
    let text = tables.fold(head, |text, table| text + "\n" + table);
    terminal::print(&text)?;
    if let Some(results) = results {
        results.write(&tables::rows(&races))?;
    }
    Ok(Outcome::Fine)
}

/// Those that run here: not every machine has the jit.
fn columns() -> Vec<Column> {
    let here = generators::here();
    let mut columns = Column::all();
    columns.retain(|column| !matches!(column, Column::Jit(generator) if !here.contains(generator)));
    columns
}
