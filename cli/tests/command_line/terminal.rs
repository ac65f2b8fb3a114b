//! What is written for people suits the terminal it goes to, and no file can command it.

use crate::program::{Folder, program};

/// Runs the program with these variables and nothing else of the environment; all it wrote.
fn told(arguments: &[&str], variables: &[(&str, &str)]) -> String {
    let mut command = program(arguments);
    command.env_clear().envs(variables.iter().copied());
    let output = command.output().unwrap();
    assert!(output.status.code().is_some_and(|code| code <= 2), "{output:?}");
    [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap()).concat()
}

fn columns(line: &str) -> usize {
    unicode_width::UnicodeWidthStr::width(line)
}

/// Characters a terminal acts on, or shows nothing of.
fn commands(text: &str) -> Vec<char> {
    let hidden = "\u{200b}\u{200d}\u{2060}\u{feff}\u{202e}\u{2066}\u{2069}\u{61c}\u{ad}\u{2028}";
    text.chars().filter(|it| (it.is_control() && *it != '\n') || hidden.contains(*it)).collect()
}

/// A mistake far to the right of a long line, with something to say of another place.
fn long_lines() -> String {
    let doc = "a long story of no end ".repeat(20);
    format!(
        "{{ \"phenomenon\": \"long\",\n  \"doc\": \"{doc}\",\n  \"nodes\": {{\n    \"shade\": {{ \"type\": \"mix\", \"doc\": \"{doc}\", \"inputs\": {{ \"wieght\": 0.5, \"a\": [1, 0, 0], \"b\": [0, 1, 0], \"b\": [0, 1, 1] }}, \"editor\": \"{doc}\" }}\n  }},\n  \"roots\": {{ \"material\": {{ \"node\": \"shade\" }} }}\n}}\n"
    )
}

#[test]
fn reports_are_as_wide_as_the_terminal() {
    let folder = Folder::new();
    let file = folder.file("long.json", long_lines());
    for width in [40, 72, 100, 200] {
        let text = told(&["check", &file], &[("COLUMNS", &width.to_string())]);
        assert!(text.contains("wieght") && text.contains("2 errors"), "{text}");
        for line in text.lines() {
            // The path of the file is one word.
            assert!(columns(line) <= width || line.contains(&file), "{width}: {line}");
        }
        // The mark stands under the key.
        let lines: Vec<&str> = text.lines().collect();
        let at = lines.iter().position(|line| line.contains("\"wieght\"")).unwrap();
        let key = columns(&lines[at][..lines[at].find("\"wieght\"").unwrap()]);
        let mark = columns(&lines[at + 1][..lines[at + 1].find('─').unwrap()]);
        assert_eq!(key, mark, "{text}");
        assert!(lines[at].contains('…'), "{text}");
    }
}

#[test]
fn a_file_of_one_line_gives_a_report_of_sane_size() {
    let folder = Folder::new();
    let nodes: String =
        (0..40_000).map(|at| format!("\"n{at}_é\": {{ \"type\": \"mix\" }}, ")).collect();
    let file = folder.file(
        "line.json",
        format!(
            "{{ \"phenomenon\": \"a\", \"nodes\": {{ {nodes} \"last\": {{ \"type\": \"mxi\" }} }}, \"roots\": {{ \"material\": {{ \"node\": \"last\" }} }} }}"
        ),
    );
    let text = told(&["check", &file, "--allow", "unreachable-node"], &[]);
    assert!(text.contains("\"mxi\"") && text.contains("did you mean"), "{text}");
    assert!(text.len() < 3_000, "{} bytes", text.len());
    let text = told(&["check", &file, "--allow", "unreachable-node"], &[("COLUMNS", "60")]);
    assert!(text.contains("\"mxi\"") && text.len() < 1_500, "{text}");
    assert!(text.lines().all(|line| columns(line) <= 60 || line.contains(&file)), "{text}");
}

#[test]
fn what_a_file_holds_cannot_command_the_terminal() {
    let folder = Folder::new();
    let evil = "\u{202e}\u{200b}\u{feff}\u{2066}\u{9b}31m\u{7f}x";
    let graph = folder.file(
        "e\u{1b}[31mvil\u{202e}.json",
        format!(
            "{{ \"phenomenon\": \"a\", \"{evil}\": 1, \"doc\": \"é\u{ad}\", \"esc\\u001b[2J\\u0007\": 2,\r\n \"nodes\": {{ \"n\": {{ \"type\": \"{evil}\", \"inputs\": {{ \"{evil}\": {{ \"node\": \"{evil}\" }} }} }} }},\r\n \"roots\": {{ \"material\": {{ \"node\": \"n\" }}, \"{evil}\": 1 }} }}"
        ),
    );
    let set = format!("{evil}=\u{1b}[31m");
    for arguments in [
        &["check", &graph][..],
        &["check", "--format", "github", &graph],
        &["render", &graph],
        &["eval", &graph],
        &["eval", "graphs/mirror/tinted_mirror.json", "--set", &set],
        &["eval", "graphs/mirror/tinted_mirror.json", "--node", &set],
        &["show", &graph, "-o", "\u{1b}.svg"],
        &["nodes", evil],
        &["explain", evil],
        &["check", "absent\u{1b}[31m.json"],
        &["check", "--format", evil, "x"],
        &["fmt", "--check", &graph],
        &[evil],
    ] {
        let text = told(arguments, &[]);
        assert!(commands(&text).is_empty(), "{arguments:?}: {text:?}");
        assert!(text.contains("\\u"), "{arguments:?}: {text}");
    }
    // The mark stands under what is written, however wide its escapes are.
    let text = told(&["check", &graph], &[("COLUMNS", "300")]);
    let lines: Vec<&str> = text.lines().collect();
    let at = lines.iter().position(|line| line.contains("\"\\u{202e}")).unwrap();
    let key = columns(&lines[at][..lines[at].find("\"\\u{202e}").unwrap()]);
    assert_eq!(key, columns(&lines[at + 1][..lines[at + 1].find('─').unwrap()]), "{text}");
    // Programs get what is there.
    let text = told(&["check", "--format", "json", &graph], &[]);
    let report: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert!(report["findings"][0]["file"].as_str().unwrap().contains('\u{1b}'));
}

#[test]
fn terminals_of_ascii_get_ascii() {
    let file = "graphs/broken/mixed_four_mistakes.json";
    let text = told(&["check", file], &[("LC_ALL", "C")]);
    assert!(text.is_ascii() && text.contains("^^^^") && text.contains("did you mean"), "{text}");
    assert!(!told(&["check", file], &[("LC_ALL", "C.UTF-8")]).is_ascii());
    let folder = Folder::new();
    let file = folder.file("é.json", "{ \"phenomenon\": \"é\", \"rôots\": 1 }");
    let text = told(&["check", &file], &[("LANG", "POSIX")]);
    assert!(text.is_ascii() && text.contains("r\\u{f4}ots"), "{text}");
}

#[test]
fn colours_are_for_those_who_want_them() {
    let file = "graphs/broken/mixed_four_mistakes.json";
    let colours = |variables: &[(&str, &str)]| told(&["check", file], variables).contains('\u{1b}');
    assert!(!colours(&[]));
    assert!(colours(&[("CLICOLOR_FORCE", "1"), ("TERM", "xterm")]));
    assert!(!colours(&[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")]));
    assert!(!colours(&[("TERM", "dumb")]));
    // In colours too, what is in the file commands nothing.
    let folder = Folder::new();
    let file = folder.file("a.json", "{ \"phenomenon\": \"a\", \"\u{202e}\\u001b[2J\": 1 }");
    let text = told(&["check", &file], &[("CLICOLOR_FORCE", "1")]);
    assert!(text.contains("\\u001b[2J") && !text.contains("\u{1b}[2J"), "{text:?}");
}
