//! The arguments, the race and its table.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::Args;
use phenomenon_compiler::engine::jit::Generator;
use phenomenon_compiler::nodes::NodeLibrary;
use serde_json::{Value, json};

use super::layers::Layers;
use super::turn::{Subject, Turn};
use crate::arguments;
use crate::commands::bench::generators;
use crate::commands::bench::results::Results;
use crate::commands::bench::statistics::median;
use crate::commands::bench::workloads::Workload;
use crate::failure::{Failure, Outcome};
use crate::terminal;

/// Compile graphs of several sizes with every code generator in turn and print the medians, by stage.
#[derive(Debug, Args)]
#[command(after_help = NOTES)]
pub struct Arguments {
    /// Nodes of the graphs that are made up; may be repeated
    #[arg(long, value_name = "N", default_values = ["150", "5000"], value_parser = arguments::nodes)]
    nodes: Vec<u32>,

    /// Turns of each graph; the median is printed
    #[arg(long, value_name = "N", default_value = "9", value_parser = arguments::runs)]
    runs: u8,

    /// Write the rows to compile.json in this folder
    #[arg(short, value_name = "DIR", value_hint = clap::ValueHint::DirPath)]
    output: Option<PathBuf>,
}

const NOTES: &str = "\
\"ten\" is the workload of `bench shade`; \"light\" and \"mixed\" are layers like those of the workloads, as
many as fit the number of nodes. What is measured is CPU milliseconds of one thread.

check: reading and checking the file. specialise, schedule, record (operations, folded and cut),
generate (machine code): the stages alone. compile: `Shader::new` and a first point, with which the code is
made: all stages but the check. first batch: that, and 256 points.";

/// A stage: its column, its key, and its time.
type Stage = (&'static str, &'static str, fn(&Turn) -> f64);

const STAGES: [Stage; 7] = [
    ("check", "check_ms", |turn| turn.check),
    ("specialise", "specialise_ms", |turn| turn.specialise),
    ("schedule", "schedule_ms", |turn| turn.schedule),
    ("record", "record_ms", |turn| turn.record),
    ("generate", "generate_ms", |turn| turn.generate),
    ("compile", "compile_ms", |turn| turn.compile),
    ("first batch", "first_batch_ms", |turn| turn.first_batch),
];

/// A graph on its way through one generator.
struct Row {
    subject: usize,
    generator: Generator,
    turns: Vec<Turn>,
}

impl Row {
    fn milliseconds(&self, stage: fn(&Turn) -> f64) -> f64 {
        median(self.turns.iter().map(stage))
    }
}

/// Runs the command.
///
/// # Errors
/// A folder that cannot be written, or a machine for which no code can be generated.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let generators = some(generators::here())?;
    let folder = arguments.output.as_deref();
    let results = folder.map(|folder| Results::new(folder, "compile")).transpose()?;
    let library = NodeLibrary::standard();
    let subjects = subjects(&arguments.nodes, &library)?;
    let mut rows = Vec::new();
    for subject in 0..subjects.len() {
        rows.extend(generators.iter().map(|&generator| Row {
            subject,
            generator,
            turns: Vec::new(),
        }));
    }
    // Bodies are recorded once in the life of a process: before the clock starts.
    for row in &rows {
        subjects[row.subject].turn(&library, row.generator)?;
    }
    let bar = terminal::progress("turns", false);
    bar.set_length(u64::from(arguments.runs) * rows.len() as u64);
    for _ in 0..arguments.runs {
        for row in &mut rows {
            row.turns.push(subjects[row.subject].turn(&library, row.generator)?);
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    terminal::print(&table(arguments.runs, &subjects, &rows))?;
    if let Some(results) = results {
        results.write(&json_rows(&subjects, &rows))?;
    }
    Ok(Outcome::Fine)
}

/// The generators, of which there must be one: an empty table would look like a measurement.
fn some(generators: Vec<Generator>) -> Result<Vec<Generator>, Failure> {
    match generators.is_empty() {
        true => Err(Failure::new(
            "no code can be generated for this machine, so there is nothing to measure",
            "run it on an x86-64 machine with AVX2 and FMA; `bench shade` measures the other engines here",
        )),
        false => Ok(generators),
    }
}

fn subjects(nodes: &[u32], library: &NodeLibrary) -> Result<Vec<Subject>, Failure> {
    let ten = Workload::Ten;
    let mut subjects = vec![Subject::new(ten.name(), ten.text().to_owned(), library)?];
    for &nodes in nodes {
        for layers in Layers::ALL {
            subjects.push(Subject::new(layers.name(), layers.text(nodes as usize), library)?);
        }
    }
    Ok(subjects)
}

fn table(runs: u8, subjects: &[Subject], rows: &[Row]) -> String {
    let mut text = format!("ms, CPU time of one thread, median of {runs} turns\n\n");
    text += "| graph | nodes | generator |";
    STAGES.iter().for_each(|(column, ..)| text += &format!(" {column} |"));
    text += "\n| --- | ---: | --- |";
    text += &" ---: |".repeat(STAGES.len());
    text.push('\n');
    for row in rows {
        let Subject { name, nodes, .. } = &subjects[row.subject];
        // Writing to a string cannot fail.
        let _ = write!(text, "| {name} | {nodes} | {} |", row.generator.name());
        for (_, _, stage) in STAGES {
            let _ = write!(text, " {:.3} |", row.milliseconds(stage));
        }
        text.push('\n');
    }
    text
}

fn json_rows(subjects: &[Subject], rows: &[Row]) -> Vec<Value> {
    let row = |row: &Row| {
        let Subject { name, nodes, .. } = &subjects[row.subject];
        let mut value = json!({ "graph": name, "nodes": nodes, "generator": row.generator.name() });
        for (_, key, stage) in STAGES {
            value[key] = json!(row.milliseconds(stage));
        }
        value
    };
    rows.iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_machine_without_generators_is_refused() {
        let failure = some(Vec::new()).unwrap_err();
        assert!(failure.to_string().contains("no code can be generated"), "{failure}");
        assert!(failure.help().contains("x86-64") && failure.help().contains("bench shade"));
        let all = some(Generator::ALL.to_vec()).unwrap();
        assert_eq!(all, Generator::ALL);
    }
}
