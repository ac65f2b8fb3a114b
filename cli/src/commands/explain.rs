//! `phenomenon explain`: the story behind a code.

use std::fmt::Write;

use phenomenon_compiler::diagnostics::{Code, Explanation, nearest};

use crate::failure::{Failure, Outcome};
use crate::terminal;

/// Tells the story of a finding's code, with a wrong and a right example.
#[derive(Debug, clap::Args)]
pub struct Arguments {
    /// The code, such as `type-mismatch`; without it all codes are listed.
    #[arg(value_name = "CODE")]
    code: Option<String>,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let Some(name) = &arguments.code else {
        terminal::print(&list())?;
        return Ok(Outcome::Fine);
    };
    let explanation = Code::from_name(name).and_then(Code::explanation);
    let Some(explanation) = explanation else {
        let names = Explanation::ALL.iter().map(|explanation| explanation.code.0);
        let help = match nearest(name, names) {
            Some(near) => near.help(),
            None => "`phenomenon explain` lists the codes".into(),
        };
        return Err(Failure::new(format!("there is no code `{name}`"), help));
    };
    terminal::print(&story(explanation))?;
    Ok(Outcome::Fine)
}

fn list() -> String {
    let width = Explanation::ALL.iter().map(|it| it.code.0.len()).max().unwrap_or(0);
    let mut text = String::new();
    for Explanation { code, severity, title, .. } in Explanation::ALL {
        let _ = writeln!(text, "{:width$}  {:7}  {title}", code.0, severity.to_string());
    }
    text
}

fn story(explanation: &Explanation) -> String {
    let Explanation { code, severity, title, story, wrong, right, .. } = explanation;
    let mut text = format!("{code} ({severity}): {title}\n\n{story}\n");
    if !wrong.is_empty() {
        let _ = write!(text, "\nWrong:\n  {wrong}\n\nRight:\n  {right}\n");
    }
    text
}
