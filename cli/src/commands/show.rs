//! `phenomenon show`.

use std::path::{Path, PathBuf};

use clap::{Args, ValueHint};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::show::{ShowError, draw_dot, draw_svg};

use crate::failure::{Failure, Outcome};
use crate::graphs;
use crate::outputs::{self, Output};

/// Draw a graph.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A graph file, or `-` for standard input
    #[arg(value_hint = ValueHint::FilePath)]
    graph: PathBuf,

    /// Where to write: SVG to look at, or DOT for Graphviz
    #[arg(short, value_name = "FILE.svg|dot", value_parser = drawing,
          value_hint = ValueHint::FilePath)]
    output: Drawing,

    /// Draw the nodes that expressions became, not one box with the text of each
    #[arg(long)]
    open: bool,
}

const EXAMPLES: &str = "\
Parameters stand at the left, roots and outputs at the right. Colour and shape of a socket tell its type, a
hollow socket is evaluated only where needed, a double one in the scope of its node. A pill is
a default that is evaluated: a field of the state, or a node without a box. What is never evaluated
is faded, with a cross where constants rule an input out. An expression is one box with its text,
which a click opens where the SVG is looked at; `--open` draws its nodes. An SVG is drawn of up to 5,000 boxes; DOT has no limit.

Examples:
  phenomenon show graphs/glass/advanced_glass.json -o glass.svg
  phenomenon show graphs/glass/advanced_glass.json -o glass.dot && dot -Tpdf glass.dot -o glass.pdf";

/// `-o`.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Drawing {
    Svg(PathBuf),
    Dot(PathBuf),
}

impl Drawing {
    fn path(&self) -> &Path {
        match self {
            Drawing::Svg(path) | Drawing::Dot(path) => path,
        }
    }
}

/// Reads a path whose extension is that of a drawing.
fn drawing(text: &str) -> Result<Drawing, String> {
    let path = PathBuf::from(text);
    let extension = path.extension().and_then(|extension| extension.to_str());
    match extension.map(str::to_ascii_lowercase).as_deref() {
        Some("svg") => Ok(Drawing::Svg(path)),
        Some("dot" | "gv") => Ok(Drawing::Dot(path)),
        _ => Err("end the name in .svg or .dot".into()),
    }
}

/// Runs the command.
///
/// # Errors
/// A graph that cannot be used or is too large for an SVG, or a file that cannot be written.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let output = Output { flag: "-o", path: arguments.output.path() };
    output.require_writable()?;
    let library = NodeLibrary::standard();
    let mut graph = graphs::read(&arguments.graph, &library)?;
    if arguments.open {
        graph.expressions.clear();
    }
    outputs::require_apart(&[output])?;
    let text = match arguments.output {
        Drawing::Svg(_) => draw_svg(&graph),
        Drawing::Dot(_) => draw_dot(&graph),
    };
    let text = text.map_err(|error| refusal(&arguments.graph, &error))?;
    output.write(text)?;
    Ok(Outcome::Fine)
}

fn refusal(graph: &Path, error: &ShowError) -> Failure {
    let help = match error {
        ShowError::TooManyBoxes { .. } => "name the output .dot; Graphviz draws large graphs",
        ShowError::Inconsistent { .. } => "please report this: the checker should have found it",
    };
    Failure::new(format!("{}: {error}", graph.display()), help)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extension_names_the_format() {
        assert_eq!(drawing("a.SVG"), Ok(Drawing::Svg("a.SVG".into())));
        assert_eq!(drawing("b/c.dot"), Ok(Drawing::Dot("b/c.dot".into())));
        assert_eq!(drawing("c.gv"), Ok(Drawing::Dot("c.gv".into())));
        for text in ["", "a", "svg", ".svg", "a.png", "a.svg.gz", "-"] {
            assert!(drawing(text).is_err(), "{text}");
        }
    }
}
