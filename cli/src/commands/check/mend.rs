//! `--fix`: putting in what is surely meant, and only what mends without breaking.

use std::collections::{HashMap, HashSet};
use std::fmt;

use phenomenon_compiler::check::Checked;
use phenomenon_compiler::diagnostics::{Code, Finding, Severity, shortened};

/// Most times a text is checked while it is mended.
const MOST_CHECKS: usize = 128;
/// Most fixes that may follow from one: a mended type shows what is wrong with its inputs.
const LONGEST_CHAIN: usize = 4;

/// Errors that say where something stands or what its surroundings lack, not that it is another thing:
/// they were there before, unseen.
const SAYS_WHERE: [Code; 7] = [
    Code::OUTSIDE_LIGHT_LOOP,
    Code::MISPLACED_EFFECT,
    Code::UNKNOWN_LIGHT,
    Code::CONFLICTING_REQUIREMENTS,
    Code::UNREADABLE_FILE,
    Code::UNUSABLE_FILE,
    Code::UNUSABLE_OBJECT,
];

/// What was put in somewhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    file: String,
    line: usize,
    column: usize,
    from: String,
    to: String,
}

impl fmt::Display for Fix {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, line, column, from, to } = self;
        let (file, from, to) = (shown(file), shown(from), shown(to));
        write!(f, "{file}:{line}:{column}: ")?;
        match (from.is_empty(), to.is_empty()) {
            (true, _) => write!(f, "put in {to}"),
            (_, true) => write!(f, "removed {from}"),
            _ => write!(f, "{from} → {to}"),
        }
    }
}

fn shown(text: &str) -> String {
    phenomenon_compiler::diagnostics::escaped(text).into_owned()
}

/// A text in which something was mended.
pub struct Mended {
    /// The text as it was.
    pub before: String,
    /// The new text.
    pub text: String,
    /// What was put in, in the order in which it was.
    pub fixes: Vec<Fix>,
    /// What is found in it.
    pub checked: Checked,
}

/// Mends the text of the file `name`, in which `checked` was found; none where there is nothing that
/// surely mends it. A fix that leads to an error that was not there before is left out.
pub fn mend(
    name: &str,
    checked: &Checked,
    check: &mut dyn FnMut(&str) -> Checked,
) -> Option<Mended> {
    let first = checked.findings.iter().find(|finding| can_be_fixed(finding, name))?;
    let text = first.place.file.text.clone();
    let mut mender = Mender { name, check, checks: 0, refused: HashSet::new() };
    let before = text.clone();
    let mut mended = Mended { before, text, fixes: Vec::new(), checked: checked.clone() };
    while mender.checks < MOST_CHECKS {
        let fixable: Vec<Finding> = mender.fixable(&mended.checked.findings);
        match mender.some_of(&mended, &fixable) {
            Some((text, checked, fixes)) => {
                (mended.text, mended.checked) = (text, checked);
                mended.fixes.extend(fixes);
            }
            None if fixable.is_empty() => break,
            None => {}
        }
    }
    (!mended.fixes.is_empty()).then_some(mended)
}

fn can_be_fixed(finding: &Finding, name: &str) -> bool {
    finding.place.file.name == name && finding.fix.is_some()
}

type Tried = (String, Checked, Vec<Fix>);

struct Mender<'m> {
    name: &'m str,
    check: &'m mut dyn FnMut(&str) -> Checked,
    checks: usize,
    /// What does not mend, by what it is and where.
    refused: HashSet<(Code, String, String)>,
}

impl Mender<'_> {
    /// The findings to mend next, in file order; of those that overlap the first.
    fn fixable(&self, findings: &[Finding]) -> Vec<Finding> {
        let mut fixable: Vec<Finding> = findings
            .iter()
            .filter(|finding| can_be_fixed(finding, self.name))
            .filter(|finding| !self.refused.contains(&key(finding)))
            .cloned()
            .collect();
        fixable.sort_by_key(|finding| (finding.place.start, finding.place.end));
        let mut end = None;
        fixable.retain(|finding| {
            let apart = end.is_none_or(|end| finding.place.start >= end);
            if apart {
                // Two that put something in at one byte overlap too.
                end = Some(finding.place.end.max(finding.place.start + 1));
            }
            apart
        });
        fixable
    }

    /// Puts in as many of the fixes as do no harm together: all, or the first half of them, down to
    /// the one that is refused.
    fn some_of(&mut self, mended: &Mended, fixable: &[Finding]) -> Option<Tried> {
        let mut count = fixable.len();
        while count > 0 && self.checks < MOST_CHECKS {
            let tried = self.tried(mended, &fixable[..count]);
            if tried.is_some() {
                return tried;
            }
            if count == 1 {
                self.refused.insert(key(&fixable[0]));
                return None;
            }
            count /= 2;
        }
        None
    }

    /// The text with fixes put in, and those that follow from them; none where an error comes of it
    /// that was not there.
    fn tried(&mut self, mended: &Mended, fixes: &[Finding]) -> Option<Tried> {
        let mut text = mended.text.clone();
        let mut applied = apply(&mut text, fixes);
        let before = errors(&mended.checked.findings);
        let was_json = !mended.checked.findings.iter().any(|it| it.code == Code::SYNTAX);
        for _ in 0..=LONGEST_CHAIN {
            self.checks += 1;
            let checked = (self.check)(&text);
            let mut left = before.clone();
            let is_new = |finding: &&Finding| {
                // What is wrong in a file that was no JSON could not be seen before.
                finding.severity == Severity::Error
                    && !SAYS_WHERE.contains(&finding.code)
                    && (was_json || finding.code == Code::SYNTAX)
                    && match left.get_mut(&told(finding)) {
                        Some(count) if *count > 0 => {
                            *count -= 1;
                            false
                        }
                        _ => true,
                    }
            };
            let new: Vec<Finding> = checked.findings.iter().filter(is_new).cloned().collect();
            if new.is_empty() {
                return Some((text, checked, applied));
            }
            let follow = self.fixable(&new);
            if follow.len() < new.len() {
                return None;
            }
            applied.extend(apply(&mut text, &follow));
        }
        None
    }
}

/// What is told, wherever it stands.
fn told(finding: &Finding) -> (Code, String) {
    (finding.code, finding.message.clone())
}

fn key(finding: &Finding) -> (Code, String, String) {
    (finding.code, finding.message.clone(), finding.place.path.clone())
}

/// The errors, and how often each is told.
fn errors(findings: &[Finding]) -> HashMap<(Code, String), usize> {
    let mut errors = HashMap::new();
    for finding in findings.iter().filter(|finding| finding.severity == Severity::Error) {
        *errors.entry(told(finding)).or_default() += 1;
    }
    errors
}

/// Puts fixes that stand apart into a text, and tells of them.
fn apply(text: &mut String, fixes: &[Finding]) -> Vec<Fix> {
    let mut applied = Vec::with_capacity(fixes.len());
    for finding in fixes {
        let (line, column) = finding.place.line_column();
        let from = cut(finding.place.text());
        let to = cut(finding.fix.as_deref().unwrap_or_default());
        let file = finding.place.file.name.clone();
        applied.push(Fix { file, line, column, from, to });
    }
    // From the end, so that places stay right.
    for finding in fixes.iter().rev() {
        let fix = finding.fix.as_deref().unwrap_or_default();
        text.replace_range(finding.place.start..finding.place.end, fix);
    }
    applied
}

/// A text short enough to be told.
fn cut(text: &str) -> String {
    if text.chars().count() > 64 { shortened(text) } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use phenomenon_compiler::check::check_graph;
    use phenomenon_compiler::document::{all_mistakes, read};
    use phenomenon_compiler::nodes::NodeLibrary;

    fn check(text: &str) -> Checked {
        match read("a.json", text.as_bytes()) {
            Ok(document) => check_graph(&document, &NodeLibrary::standard()),
            Err(finding) => Checked { findings: all_mistakes(*finding), ..Checked::default() },
        }
    }

    fn mended(text: &str) -> Option<Mended> {
        mend("a.json", &check(text), &mut check)
    }

    fn graph(nodes: &str) -> String {
        format!(
            "{{ \"phenomenon\": \"a\",\n  \"nodes\": {{ \"here\": {{ \"type\": \"state\" }}, {nodes} }},\n  \
             \"roots\": {{ \"material\": {{ \"node\": \"m\" }} }} }}"
        )
    }

    #[test]
    fn nothing_becomes_another_thing() {
        for (nodes, changed) in [
            (
                r#""m": { "type": "max", "inputs": { "a": 0.5, "b": { "node": "here", "output": "u" } } }"#,
                Some(("\"max\"", "\"maximum\"")),
            ),
            (
                r#""m": { "type": "sub", "inputs": { "a": 0.5, "b": 0.25 } }"#,
                Some(("\"sub\"", "\"subtract\"")),
            ),
            // What `max` means may be sure; what is given to it is not `maximum`'s.
            (r#""m": { "type": "max", "inputs": { "a": 0.5, "weight": 1 } }"#, None),
            (
                r#""m": { "type": "add", "inputs": { "a": { "node": "here", "output": "point.y" } } }"#,
                None,
            ),
            (r#""m": { "type": "scalar", "inputs": { "input": 1 } }"#, None),
            (r#""m": { "type": "lens" }"#, None),
            (r#""m": { "type": "pow", "inputs": { "x": 0.5, "y": 2 } }"#, None),
        ] {
            let text = graph(nodes);
            let after = mended(&text);
            match changed {
                Some((from, to)) => {
                    let after = after.unwrap_or_else(|| panic!("{nodes}"));
                    assert_eq!(after.text, text.replace(from, to));
                    assert!(after.checked.graph.is_some());
                }
                None => assert!(after.is_none(), "{}", after.unwrap().text),
            }
        }
    }

    #[test]
    fn one_fix_shows_the_next() {
        let text = graph(r#""m": { "type": "mxi", "inputs": { "wieght": 0.5, "B": [1, 0, 0] } }"#);
        let after = mended(&text).unwrap();
        let expected =
            text.replace("mxi", "mix").replace("wieght", "weight").replace("\"B\"", "\"b\"");
        assert_eq!(after.text, expected);
        let told: Vec<String> = after.fixes.iter().map(ToString::to_string).collect();
        assert_eq!(told.len(), 3);
        assert_eq!(told[0], "a.json:2:58: \"mxi\" → \"mix\"");
    }

    #[test]
    fn a_fix_that_breaks_keeps_the_others_from_nothing() {
        // `mxi` would show that `gone` is no input, so it stays; the rest is mended.
        let text = graph(
            r#""m": { "type": "add", "inputs": { "a": { "node": "heer", "output": "u" } } }, "o": { "type": "mxi", "inputs": { "gone": 1 } }"#,
        );
        let after = mended(&text).unwrap();
        assert_eq!(after.text, text.replace("heer", "here"));
    }

    #[test]
    fn what_is_no_json_is_mended_whole() {
        let text = graph(r#""m": { "type": "add", 'inputs': { “a”: .5, "b": 01, } }"#);
        let after = mended(&text).unwrap();
        let expected = graph(r#""m": { "type": "add", "inputs": { "a": 0.5, "b": 1 } }"#);
        assert_eq!(after.text, expected);
        assert!(after.checked.graph.is_some());
        assert_eq!(after.fixes.len(), 5);
        // A comment is text of somebody's, and is kept.
        let text = format!("// a note\n{text}");
        assert!(mended(&text).unwrap().text.starts_with("// a note\n"));
    }

    #[test]
    fn no_edit_is_lost_where_two_meet() {
        let text = "{ \"phenomenon\": \"a\" \"roots\": { \"material\": [1 .5 +0] } }";
        let after = mended(text).unwrap();
        assert_eq!(
            after.text,
            "{ \"phenomenon\": \"a\", \"roots\": { \"material\": [1, 0.5, 0] } }"
        );
    }
}
