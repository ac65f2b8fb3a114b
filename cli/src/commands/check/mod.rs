//! `phenomenon check`: everything that is wrong in graphs and scenes.

mod mend;
mod scene;

pub use scene::check_with as check_scene;

use std::collections::HashSet;
use std::path::PathBuf;

use phenomenon_compiler::check::{Checked, OnDisk, check_graph};
use phenomenon_compiler::diagnostics::{Code, Finding, Severity};
use phenomenon_compiler::document::{self, Document};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_runtime::scene::is_scene;

use crate::difference;
use crate::failure::{Failure, Outcome};
use crate::inputs::{self, Input};
use crate::outputs;
use crate::report::{Format, Report};
use crate::terminal;

/// Says all that is wrong in graphs and scenes.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// Files, folders (every .json file in them that is a graph or a scene), or `-` for standard
    /// input.
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// How findings are written.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    /// Treat warnings as errors.
    #[arg(long, value_name = "WHAT", value_parser = ["warnings"])]
    deny: Option<String>,
    /// Say nothing of findings with this code that are no errors; may be given many times.
    #[arg(long, value_name = "CODE", value_parser = code)]
    allow: Vec<Code>,
    /// Put in what can only be meant, as far as nothing new is wrong then, and tell what it was.
    #[arg(long)]
    fix: bool,
    /// With --fix, show what would change, and write nothing.
    #[arg(long, requires = "fix", conflicts_with = "format")]
    diff: bool,
}

const EXAMPLES: &str = "\
Examples:
  phenomenon check graphs
  phenomenon check glass.json --deny warnings --format sarif
  cat glass.json | phenomenon check -

Exit codes:
  0  no errors
  1  errors
  2  wrong usage, or a file that cannot be read";

fn code(name: &str) -> Result<Code, String> {
    Code::from_name(name).ok_or_else(|| {
        let codes = phenomenon_compiler::diagnostics::Explanation::ALL;
        let names = codes.iter().map(|explanation| explanation.code.0);
        match document::nearest(name, names) {
            Some(near) => near.help(),
            None => "`phenomenon explain` lists the codes".into(),
        }
    })
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let library = NodeLibrary::standard();
    let mut findings = Vec::new();
    let mut omitted = 0;
    let mut told = HashSet::new();
    let found = inputs::find(&arguments.paths);
    found.failures.iter().for_each(terminal::complain);
    for input in found.inputs {
        let mut checked = check_input(&input, &library)?;
        if arguments.fix {
            checked = fix(&input, checked, &library, arguments.diff)?;
        }
        omitted += checked.omitted;
        // A file that several others use is checked with each of them, but told of once.
        findings.extend(checked.findings.into_iter().filter(|finding| {
            let place = &finding.place;
            told.insert((
                place.file.name.clone(),
                place.start,
                finding.code,
                finding.message.clone(),
            ))
        }));
    }
    findings.retain(|finding| {
        finding.severity == Severity::Error || !arguments.allow.contains(&finding.code)
    });
    if arguments.deny.is_some() {
        for finding in &mut findings {
            if finding.severity == Severity::Warning {
                finding.severity = Severity::Error;
            }
        }
    }
    // A file that is named in another one has its place there; it is a finding like any other.
    let unreadable = findings
        .iter()
        .any(|finding| finding.code == Code::UNREADABLE_FILE && finding.place.file.text.is_empty());
    // What is omitted is no error unless as many errors are kept.
    let wrong = findings.iter().any(|finding| finding.severity == Severity::Error);
    Report::new(findings, omitted).print(arguments.format)?;
    Ok(match (unreadable || !found.failures.is_empty(), wrong) {
        (true, _) => Outcome::Unreadable,
        (_, true) => Outcome::Found,
        _ => Outcome::Fine,
    })
}

/// Writes the file anew with what surely mends it put in, and tells what that was; with `diff` it is
/// shown and not written. What is found then.
fn fix(
    input: &Input,
    checked: Checked,
    library: &NodeLibrary,
    diff: bool,
) -> Result<Checked, Failure> {
    let name = input.path.display().to_string();
    let mut check = |text: &str| check_read(document::read(&name, text.as_bytes()), input, library);
    let Some(mended) = mend::mend(&name, &checked, &mut check) else { return Ok(checked) };
    if diff {
        terminal::print_exactly(&difference::unified(&name, &mended.before, &mended.text))?;
        return Ok(checked);
    }
    if inputs::is_stream(&input.path) {
        return Err(Failure::new(
            "--fix cannot change standard input",
            "give the path of a file instead of `-`, or add `--diff` to see what would change",
        ));
    }
    outputs::rewrite(&input.path, &mended.text)?;
    for fix in &mended.fixes {
        terminal::tell(&format!("fixed {fix}"));
    }
    Ok(mended.checked)
}

fn check_input(input: &Input, library: &NodeLibrary) -> Result<Checked, Failure> {
    Ok(check_read(inputs::read(&input.path), input, library))
}

/// What is found in a document that was read, or in one that could not be.
fn check_read(
    document: Result<Document, Box<Finding>>,
    input: &Input,
    library: &NodeLibrary,
) -> Checked {
    match document {
        Ok(document) if input.in_folder && !inputs::is_ours(&document) => Checked::default(),
        Ok(document) if is_scene(&document) => {
            scene::check(&document, inputs::folder(&input.path), library, &OnDisk)
        }
        Ok(document) => check_graph(&document, library),
        Err(finding) => {
            Checked { findings: document::all_mistakes(*finding), ..Checked::default() }
        }
    }
}
