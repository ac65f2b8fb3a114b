//! `phenomenon bench shade`.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::sync::Arc;

use clap::{Args, ValueHint};
use phenomenon_compiler::nodes::NodeLibrary;
use serde_json::{Value, json};

use super::column::Column;
use super::contender::{Contender, Points};
use super::generators;
use super::results::Results;
use super::workloads::{STATES, Workload};
use crate::arguments::{self, Precision};
use crate::failure::{Failure, Outcome};
use crate::terminal;

/// Shade the points of five workloads with every engine in turn and print the medians.
#[derive(Debug, Args)]
#[command(after_help = NOTES)]
pub struct Arguments {
    /// Measure this workload only; may be repeated
    #[arg(long, value_enum, value_name = "NAME")]
    workload: Vec<Workload>,

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

What is measured is CPU time of one thread, after everything is compiled and has run once. Engines
take turns of some 10 ms, so that a slow minute of the machine touches all of them. Ratios are medians
of the ratios of one turn, at the same number of points a call. \"spread\" is the distance between the
quartiles of all turns, over their median.";

/// Points of one call.
const BATCHES: [usize; 3] = [1, 16, 256];

/// All that shade one workload in calls of one number of points.
struct Race {
    workload: Workload,
    batch: usize,
    points: Points,
    contenders: Vec<Contender>,
}

/// Runs the command.
///
/// # Errors
/// A folder that cannot be written.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let folder = arguments.output.as_deref();
    let results = folder.map(|folder| Results::new(folder, "shade")).transpose()?;
    let library = NodeLibrary::standard();
    let columns = columns();
    let mut races = Vec::new();
    for workload in Workload::ALL {
        if arguments.workload.is_empty() || arguments.workload.contains(&workload) {
            for batch in BATCHES {
                races.push(race(workload, batch, &columns, &library)?);
            }
        }
    }
    let bar = terminal::progress("turns", false);
    bar.set_length(u64::from(arguments.runs) * races.len() as u64);
    for _ in 0..arguments.runs {
        for race in &mut races {
            for contender in &mut race.contenders {
                contender.take_turn(race.batch, &mut race.points);
            }
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    terminal::print(&table(arguments.runs, &races))?;
    if let Some(results) = results {
        results.write(&rows(&races))?;
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

fn race(
    workload: Workload,
    batch: usize,
    columns: &[Column],
    library: &NodeLibrary,
) -> Result<Race, Failure> {
    let mut points = Points::new(workload);
    let graph = Arc::new(workload.graph(library)?);
    let mut contenders = Vec::new();
    for &column in columns {
        if let Some(shader) = column.shader(workload, &graph, batch)? {
            contenders.push(Contender::new(column, shader, batch, &mut points));
        }
    }
    Ok(Race { workload, batch, points, contenders })
}

/// Those to whom ratios are given.
const BASES: [Column; 4] = [Column::Fused8, Column::Monolith, Column::Batch, Column::Walk];

fn table(runs: u8, races: &[Race]) -> String {
    let mut text = format!(
        "ns a point, CPU time of one thread, {STATES} points, median of {runs} turns\n\n\
         | workload | points a call | engine | ns | spread |"
    );
    BASES.iter().for_each(|base| text += &format!(" to {} |", base.name()));
    text += "\n| --- | ---: | --- | ---: | ---: |";
    text += &" ---: |".repeat(BASES.len());
    text.push('\n');
    for race in races {
        let to = |of: &Contender, column: Column| {
            let base = race.contenders.iter().find(|contender| contender.column == column);
            base.map_or_else(String::new, |base| format!("{:.2}", of.ratio(base)))
        };
        for of in &race.contenders {
            // Writing to a string cannot fail.
            let _ = write!(
                text,
                "| {} | {} | {} | {:.1} | {:.3} |",
                race.workload.name(),
                race.batch,
                of.column.name(),
                of.nanoseconds(),
                of.spread(),
            );
            BASES.iter().for_each(|&base| text += &format!(" {} |", to(of, base)));
            text.push('\n');
        }
    }
    text
}

fn rows(races: &[Race]) -> Vec<Value> {
    let row = |race: &Race, of: &Contender| {
        json!({
            "workload": race.workload.name(),
            "batch": race.batch,
            "engine": of.column.name(),
            "precision": Precision::default().name(),
            "ns_per_point": of.nanoseconds(),
            "spread": of.spread(),
        })
    };
    races.iter().flat_map(|race| race.contenders.iter().map(|of| row(race, of))).collect()
}
