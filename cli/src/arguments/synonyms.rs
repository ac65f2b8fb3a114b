//! Flags as other renderers call them.

use clap::builder::StyledStr;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Command, Error};

/// What others call a flag of ours, and how it is written here.
const SYNONYMS: [(&str, &[&str], &str); 13] = [
    ("spp", &["samples", "sample", "sample-count", "aa", "aa-samples"], "--spp N"),
    ("o", &["output", "out", "outfile", "output-file"], "-o FILE"),
    (
        "size",
        &["resolution", "res", "width", "height", "dimensions", "w", "h", "r"],
        "--size WxH, such as --size 512x512",
    ),
    ("set", &["param", "parameter", "params", "override", "input"], "--set NAME=VALUE"),
    ("threads", &["thread", "jobs", "cores", "j", "t"], "--threads N"),
    ("engine", &["backend", "renderer", "mode"], "--engine NAME"),
    ("stats", &["statistics", "stat", "report"], "--stats FILE.json"),
    ("region", &["crop", "border", "window", "roi"], "--region X,Y,W,H"),
    ("scene", &["stage"], "--scene STAGE.json"),
    ("seed", &["random-seed", "rng-seed"], "--seed N"),
    ("quiet", &["silent", "q", "no-progress"], "--quiet"),
    ("tolerance", &["threshold", "epsilon", "max-rms"], "--tolerance RMS"),
    ("format", &["json", "output-format"], "--format, such as --format json"),
];

/// Puts a hint in the place of clap's to an unknown flag: it takes any flag it does not know for a
/// value that wants `--` before it. `arguments` are those of the program, without its name.
pub fn explained(mut error: Error, program: &Command, arguments: &[String]) -> Error {
    let Some(ContextValue::String(flag)) = error.get(ContextKind::InvalidArg).cloned() else {
        return error;
    };
    if error.kind() != ErrorKind::UnknownArgument || !flag.starts_with('-') || flag == "-" {
        return error;
    }
    // A value that begins with a dash is told of as before.
    if flag.trim_start_matches('-').starts_with(|c: char| c.is_ascii_digit() || c == '.') {
        return error;
    }
    error.remove(ContextKind::Suggested);
    if let Some(hint) = hint(&flag, command_of(program, arguments)) {
        error.remove(ContextKind::SuggestedArg);
        let hint: StyledStr = format!("write {hint}").into();
        error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![hint]));
    }
    error
}

/// The innermost command that is named.
fn command_of<'a>(program: &'a Command, arguments: &[String]) -> &'a Command {
    let mut command = program;
    for argument in arguments {
        if let Some(inner) = command.find_subcommand(argument) {
            command = inner;
        }
    }
    command
}

/// How a foreign flag is written for a command, where the command has it.
fn hint(flag: &str, command: &Command) -> Option<&'static str> {
    let name = flag.trim_start_matches('-').split('=').next()?.to_lowercase().replace('_', "-");
    let has = |ours: &str| {
        command.get_arguments().any(|argument| {
            argument.get_long() == Some(ours)
                || argument.get_short().is_some_and(|short| ours.chars().eq([short]))
        })
    };
    SYNONYMS
        .iter()
        .find(|(ours, theirs, _)| theirs.contains(&name.as_str()) && has(ours))
        .map(|(.., hint)| *hint)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_hint_names_a_flag_that_some_command_has() {
        let program = crate::grammar();
        for (ours, theirs, hint) in SYNONYMS {
            let commands = || program.get_subcommands();
            let known = commands().any(|command| super::hint(theirs[0], command) == Some(hint));
            assert!(known, "no command has {ours}");
            // A name of another program that some command of ours has is no foreign one there.
            for command in commands() {
                for name in theirs {
                    let taken = command.get_arguments().any(|it| it.get_long() == Some(name));
                    let told = super::hint(name, command);
                    assert!(!taken || told.is_none(), "{} --{name}", command.get_name());
                }
            }
        }
    }

    #[test]
    fn a_flag_the_command_lacks_is_not_suggested() {
        let program = crate::grammar();
        let command = |name: &str| program.find_subcommand(name).unwrap();
        assert_eq!(hint("--samples", command("render")), Some("--spp N"));
        assert_eq!(hint("--samples=4", command("render")), Some("--spp N"));
        assert_eq!(hint("--Resolution", command("render")).map(|hint| &hint[..6]), Some("--size"));
        assert_eq!(hint("--samples", command("compare")), None);
        assert_eq!(hint("--zzz", command("render")), None);
    }
}
