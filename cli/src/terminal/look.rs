//! What the terminal that text goes to can show.

use std::io::{self, IsTerminal};

/// Columns of text that goes to no terminal.
const USUAL_WIDTH: usize = 100;
/// Fewest columns that are reckoned with.
const LEAST_WIDTH: usize = 20;

/// Where text goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stream {
    /// Standard output.
    Output,
    /// Standard error.
    Error,
}

/// What can be shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// Whether in colours.
    pub color: bool,
    /// Whether in ASCII alone.
    pub ascii: bool,
    /// Whether the cursor only ever moves on.
    pub dumb: bool,
    /// In how many columns.
    pub width: usize,
    /// Whether that width is the terminal's, not a usual one, so that lines are broken to it.
    pub wraps: bool,
}

impl Look {
    /// What the environment and the terminal say of a stream.
    pub fn of(stream: Stream) -> Self {
        let size = match stream {
            Stream::Output => terminal_size::terminal_size_of(io::stdout()),
            Stream::Error => terminal_size::terminal_size_of(io::stderr()),
        };
        let is_terminal = match stream {
            Stream::Output => io::stdout().is_terminal(),
            Stream::Error => io::stderr().is_terminal(),
        };
        let columns = size.map(|(width, _)| usize::from(width.0)).filter(|_| is_terminal);
        Self::from(&|name| std::env::var(name).ok(), is_terminal, columns)
    }

    /// The same from variables and what is known of the stream. A variable that is empty counts as not given.
    fn from(
        variable: &dyn Fn(&str) -> Option<String>,
        is_terminal: bool,
        columns: Option<usize>,
    ) -> Self {
        let given = |name: &str| variable(name).filter(|value| !value.is_empty());
        let dumb = given("TERM").is_some_and(|terminal| terminal == "dumb");
        let forced = given("CLICOLOR_FORCE").is_some_and(|force| force != "0");
        let declined = given("CLICOLOR").is_some_and(|color| color == "0");
        let color = given("NO_COLOR").is_none() && (forced || is_terminal && !dumb && !declined);
        // The first that is given decides, as for the C library.
        let locale = ["LC_ALL", "LC_CTYPE", "LANG"].into_iter().find_map(given);
        let ascii = locale.is_some_and(|locale| {
            let locale = locale.to_ascii_lowercase();
            !locale.contains("utf-8") && !locale.contains("utf8")
        });
        let told = given("COLUMNS").and_then(|columns| columns.trim().parse::<usize>().ok());
        let known = told.filter(|columns| *columns > 0).or(columns.filter(|columns| *columns > 0));
        let width = known.unwrap_or(USUAL_WIDTH).max(LEAST_WIDTH);
        Self { color, ascii, dumb, width, wraps: known.is_some() }
    }

    /// The text, its lines broken between words where they are longer than the terminal is wide; lines that follow
    /// start with `indent`. Where no width is known it stays as it is.
    pub fn wrapped(&self, text: &str, indent: &str) -> String {
        if !self.wraps {
            return text.to_owned();
        }
        let mut wrapped = String::with_capacity(text.len() + 16);
        for (number, line) in text.split('\n').enumerate() {
            wrapped.push_str(if number > 0 { "\n" } else { "" });
            let mut used = 0;
            for word in line.split_inclusive(' ') {
                let width = unicode_width::UnicodeWidthStr::width(word.trim_end());
                if used > indent.len() && used + width > self.width {
                    wrapped.truncate(wrapped.trim_end_matches(' ').len());
                    wrapped.push('\n');
                    wrapped.push_str(indent);
                    used = indent.len();
                }
                wrapped.push_str(word);
                used += unicode_width::UnicodeWidthStr::width(word);
            }
        }
        wrapped
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn look(variables: &[(&str, &str)], is_terminal: bool) -> Look {
        let variable = |name: &str| {
            let found = variables.iter().find(|(known, _)| *known == name);
            found.map(|(_, value)| (*value).to_owned())
        };
        Look::from(&variable, is_terminal, is_terminal.then_some(64))
    }

    #[test]
    fn colours_are_for_terminals_that_want_them() {
        for (variables, is_terminal, color) in [
            (&[][..], true, true),
            (&[], false, false),
            (&[("NO_COLOR", "1")], true, false),
            (&[("NO_COLOR", "")], true, true),
            (&[("TERM", "dumb")], true, false),
            (&[("TERM", "xterm-256color")], true, true),
            (&[("CLICOLOR", "0")], true, false),
            (&[("CLICOLOR", "1")], false, false),
            (&[("CLICOLOR_FORCE", "1")], false, true),
            (&[("CLICOLOR_FORCE", "0")], false, false),
            (&[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")], true, false),
        ] {
            assert_eq!(look(variables, is_terminal).color, color, "{variables:?} {is_terminal}");
        }
    }

    #[test]
    fn the_locale_says_whether_more_than_ascii_can_be_shown() {
        for (variables, ascii) in [
            (&[][..], false),
            (&[("LANG", "C")], true),
            (&[("LANG", "en_US.UTF-8")], false),
            (&[("LANG", "C.utf8")], false),
            (&[("LANG", "en_US.UTF-8"), ("LC_ALL", "C")], true),
            (&[("LANG", "C"), ("LC_CTYPE", "de_DE.UTF-8")], false),
            (&[("LANG", "de_DE.UTF-8"), ("LC_ALL", "")], false),
            (&[("LC_ALL", "de_DE.ISO-8859-1")], true),
        ] {
            assert_eq!(look(variables, true).ascii, ascii, "{variables:?}");
        }
    }

    #[test]
    fn the_width_is_what_is_said_or_that_of_the_terminal() {
        for (variables, is_terminal, width) in [
            (&[][..], true, 64),
            (&[], false, USUAL_WIDTH),
            (&[("COLUMNS", "40")], true, 40),
            (&[("COLUMNS", "200")], false, 200),
            (&[("COLUMNS", "0")], true, 64),
            (&[("COLUMNS", "-7")], false, USUAL_WIDTH),
            (&[("COLUMNS", "wide")], true, 64),
            (&[("COLUMNS", "3")], true, LEAST_WIDTH),
        ] {
            assert_eq!(look(variables, is_terminal).width, width, "{variables:?} {is_terminal}");
        }
    }

    #[test]
    fn long_lines_break_between_words() {
        let narrow = look(&[("COLUMNS", "20")], false);
        let text = "error: a word and another, averyveryverylongone and more\nnext";
        let wrapped = narrow.wrapped(text, "    ");
        assert_eq!(
            wrapped,
            "error: a word and\n    another,\n    averyveryverylongone\n    and more\nnext"
        );
        assert_eq!(look(&[], false).wrapped(text, ""), text);
        assert_eq!(narrow.wrapped("", "  "), "");
    }
}
