//! The arguments of the command, and what it does.

use std::path::PathBuf;
use std::sync::Arc;

use phenomenon_compiler::check::{Checked, Files, OnDisk, check_graph_with};
use phenomenon_compiler::diagnostics::{Code, Finding, Severity, TellOnce};
use phenomenon_compiler::document::{self, Document};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_runtime::link::{check_with_graphs, uncompilable};
use phenomenon_runtime::scene_file::{Assets, is_scene};
use phenomenon_runtime::texture::DecodedPictures;

use super::mend;
use crate::arguments;
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
    #[arg(long, value_name = "CODE", value_parser = arguments::allowable)]
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
  2  wrong usage, a file that cannot be read, or nothing to check in the folders named

Errors cannot be allowed. JSON files of another kind that are met in folders are passed over, and
counted.";

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let library = NodeLibrary::standard();
    let mut findings = Vec::new();
    let mut omitted = 0;
    let mut once = TellOnce::default();
    let (mut looked_at, mut foreign) = (0_usize, 0_usize);
    // A picture that several files use is decoded once.
    let files = DecodedPictures::of(&OnDisk);
    let found = inputs::find(&arguments.paths).once();
    found.failures.iter().for_each(terminal::complain);
    for input in found.inputs {
        let Some(mut checked) = check_read(inputs::read(&input.path), &input, &library, &files)
        else {
            foreign += 1;
            continue;
        };
        looked_at += 1;
        if arguments.fix {
            checked = fix(&input, checked, &library, &files, arguments.diff)?;
        }
        omitted += checked.omitted;
        // A file that several others use is checked with each of them, but told of once.
        findings.extend(checked.findings.into_iter().filter(|finding| once.is_new(finding)));
    }
    tell_passed_over(foreign);
    if looked_at == 0 {
        return Err(inputs::nothing_in(&arguments.paths, "check"));
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

/// Says how many JSON files met in folders are of another kind.
fn tell_passed_over(foreign: usize) {
    match foreign {
        0 => {}
        1 => terminal::tell("note: 1 JSON file is no graph or scene and was passed over"),
        many => terminal::tell(&format!(
            "note: {many} JSON files are no graphs or scenes and were passed over"
        )),
    }
}

/// Writes the file anew with what surely mends it put in, and tells what that was; with `diff` it is
/// shown and not written. What is found then.
fn fix(
    input: &Input,
    checked: Checked,
    library: &NodeLibrary,
    files: &dyn Files,
    diff: bool,
) -> Result<Checked, Failure> {
    let name = input.path.display().to_string();
    let mut check = |text: &str| {
        let document = document::read(&name, text.as_bytes());
        check_read(document, input, library, files).unwrap_or_default()
    };
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

/// What is found in a document that was read, or in one that could not be; none for one met in a
/// folder that is of another kind.
fn check_read(
    document: Result<Document, Box<Finding>>,
    input: &Input,
    library: &NodeLibrary,
    files: &dyn Files,
) -> Option<Checked> {
    match document {
        Ok(document) if input.in_folder && !inputs::is_ours(&document) => None,
        Ok(document) if is_scene(&document) => {
            let (folder, assets) = (inputs::folder(&input.path), Assets::default());
            Some(check_with_graphs(&document, folder, library, files, &assets))
        }
        Ok(document) => {
            let mut checked = check_graph_with(&document, library, files);
            if let Some(graph) = checked.graph.take() {
                let graph = Arc::new(graph);
                checked.findings.extend(uncompilable(&graph, &[], &document));
            }
            Some(checked)
        }
        Err(finding) if input.in_folder && inputs::is_foreign_text(&finding) => None,
        Err(finding) => {
            Some(Checked { findings: document::all_mistakes(*finding), ..Checked::default() })
        }
    }
}
