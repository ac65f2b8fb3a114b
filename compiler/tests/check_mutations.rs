//! Valid files, mutated: whatever comes of it, the checker says where and never panics.

use std::path::Path;

use phenomenon_compiler::check::{Checked, check_graph};
use phenomenon_compiler::diagnostics::Severity;
use phenomenon_compiler::document::{all_mistakes, canonical, read};
use phenomenon_compiler::nodes::NodeLibrary;
use proptest::prelude::*;

fn seeds() -> Vec<String> {
    let graphs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../graphs");
    ["mirror/tinted_mirror.json", "glass/advanced_glass.json", "rainbow/rainbow.json"]
        .into_iter()
        .map(|path| std::fs::read_to_string(graphs.join(path)).unwrap())
        .collect()
}

/// Pieces that mean something somewhere in a graph.
const PIECES: [&str; 30] = [
    "{",
    "}",
    "[",
    "]",
    ",",
    ":",
    "\"",
    "\\",
    "\u{0}",
    "é",
    "1e400",
    "-0.0",
    "null",
    "true",
    "\"node\"",
    "\"interface\"",
    "\"output\"",
    "\"inputs\"",
    "\"type\"",
    "\"roots\"",
    "\"material\"",
    "{\"node\": \"shade\"}",
    "{\"interface\": \"tint\"}",
    "[0, 1]",
    "[0, 1, 2, 3]",
    "\"file\"",
    "\"mix\"",
    "\"light_color\"",
    "1.5",
    "{}",
];

#[derive(Clone, Debug)]
enum Edit {
    Delete(prop::sample::Index, usize),
    Insert(prop::sample::Index, usize),
    Replace(prop::sample::Index, usize, usize),
    Repeat(prop::sample::Index, usize, prop::sample::Index),
}

fn edit() -> impl Strategy<Value = Edit> {
    let index = any::<prop::sample::Index>;
    prop_oneof![
        (index(), 1_usize..40).prop_map(|(at, length)| Edit::Delete(at, length)),
        (index(), 0..PIECES.len()).prop_map(|(at, piece)| Edit::Insert(at, piece)),
        (index(), 1_usize..12, 0..PIECES.len())
            .prop_map(|(at, length, piece)| Edit::Replace(at, length, piece)),
        (index(), 1_usize..200, index())
            .prop_map(|(from, length, to)| Edit::Repeat(from, length, to)),
    ]
}

fn apply(bytes: &mut Vec<u8>, edit: &Edit) {
    if bytes.is_empty() {
        return;
    }
    let end = |at: usize, length: usize| (at + length).min(bytes.len());
    match edit {
        Edit::Delete(at, length) => {
            let at = at.index(bytes.len());
            bytes.drain(at..end(at, *length));
        }
        Edit::Insert(at, piece) => {
            let at = at.index(bytes.len());
            bytes.splice(at..at, PIECES[*piece].bytes());
        }
        Edit::Replace(at, length, piece) => {
            let at = at.index(bytes.len());
            bytes.splice(at..end(at, *length), PIECES[*piece].bytes());
        }
        Edit::Repeat(from, length, to) => {
            let from = from.index(bytes.len());
            let piece = bytes[from..end(from, *length)].to_vec();
            let to = to.index(bytes.len());
            bytes.splice(to..to, piece);
        }
    }
}

/// A token of the file replaced by a piece: most of what comes of it is still JSON.
fn swap_token(text: &str, at: prop::sample::Index, piece: usize) -> String {
    let tokens: Vec<(usize, &str)> =
        text.match_indices(|c: char| c == '"' || c.is_ascii_digit()).collect();
    let (start, _) = tokens[at.index(tokens.len())];
    let rest = &text[start..];
    let length = match rest.strip_prefix('"') {
        Some(inner) => inner.find('"').map_or(rest.len(), |at| at + 2),
        None => rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len()),
    };
    format!("{}{}{}", &text[..start], PIECES[piece], &rest[length..])
}

fn holds(bytes: &[u8], library: &NodeLibrary) -> Result<(), TestCaseError> {
    let checked = match read("mutated.json", bytes) {
        Ok(document) => {
            let once = canonical(&document);
            let again = read("again.json", once.as_bytes());
            prop_assert_eq!(again.ok().map(|it| canonical(&it)), Some(once));
            check_graph(&document, library)
        }
        Err(finding) => {
            let first = (*finding).clone();
            let findings = all_mistakes(*finding);
            prop_assert_eq!(findings.first(), Some(&first));
            Checked { findings, ..Checked::default() }
        }
    };
    let wrong = checked.findings.iter().any(|finding| finding.severity == Severity::Error);
    prop_assert_eq!(checked.graph.is_none(), wrong);
    for finding in &checked.findings {
        let places =
            std::iter::once(&finding.place).chain(finding.related.iter().map(|it| &it.place));
        for place in places {
            prop_assert!(place.start <= place.end && place.end <= place.file.text.len());
            prop_assert!(place.file.text.is_char_boundary(place.start));
            prop_assert!(place.file.text.is_char_boundary(place.end));
            prop_assert!(place.line_column() <= place.end_line_column());
        }
        prop_assert!(!finding.message.is_empty() && !finding.help.is_empty(), "{}", finding.code);
        prop_assert!(finding.message.len() < 4000);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_edits_are_survived(seed in 0_usize..3, edits in prop::collection::vec(edit(), 1..6)) {
        let mut bytes = seeds()[seed].clone().into_bytes();
        for edit in &edits {
            apply(&mut bytes, edit);
        }
        holds(&bytes, &NodeLibrary::standard())?;
    }

    #[test]
    fn swapped_tokens_are_survived(
        seed in 0_usize..3,
        swaps in prop::collection::vec((any::<prop::sample::Index>(), 0..PIECES.len()), 1..4),
    ) {
        let mut text = seeds()[seed].clone();
        for (at, piece) in swaps {
            text = swap_token(&text, at, piece);
        }
        holds(text.as_bytes(), &NodeLibrary::standard())?;
    }

    #[test]
    fn any_bytes_are_survived(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        holds(&bytes, &NodeLibrary::standard())?;
    }
}

/// Every prefix of a shipped file, and every character of it left out, doubled, or another one: the strict
/// parser takes it, or the scan says where it is no JSON, in few words.
#[test]
fn every_single_slip_is_told() {
    let graphs = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut counts = [0_usize; 32];
    for path in ["graphs/mirror/tinted_mirror.json", "scenes/default.json"] {
        let text = std::fs::read_to_string(graphs.join(path)).unwrap();
        let mut slip = |slipped: String| {
            let Err(first) = read("slip.json", slipped.as_bytes()) else { return };
            let findings = all_mistakes((*first).clone());
            assert_eq!(findings.first(), Some(&*first), "{slipped}");
            assert!(findings.len() < counts.len(), "{} findings in\n{slipped}", findings.len());
            counts[findings.len()] += 1;
            for finding in &findings {
                let (start, end) = (finding.place.start, finding.place.end);
                assert!(start <= end && slipped.get(start..end).is_some(), "{slipped}");
                assert!(!finding.message.is_empty() && !finding.help.is_empty());
            }
        };
        for (at, c) in text.char_indices() {
            let (before, after) = (&text[..at], &text[at + c.len_utf8()..]);
            slip(before.to_owned());
            slip(format!("{before}{after}"));
            slip(format!("{before}{c}{c}{after}"));
            for other in "{}[](),:;=\"'“\\/#x1.\n\u{0}é\u{feff}".chars() {
                slip(format!("{before}{other}{after}"));
                slip(format!("{before}{other}{c}{after}"));
            }
        }
    }
    // One slip is mostly one finding, and hardly ever more than three.
    let all: usize = counts.iter().sum();
    assert_eq!(counts[0], 0);
    assert!(counts[1] * 2 > all, "{counts:?}");
    assert!(counts[4..].iter().sum::<usize>() * 20 < all, "{counts:?}");
}
