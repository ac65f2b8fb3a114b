//! Every code's wrong example has that one mistake, and its right example none.

use phenomenon_compiler::check::{Checked, check_graph};
use phenomenon_compiler::diagnostics::{Explanation, Severity};
use phenomenon_compiler::document::read;
use phenomenon_compiler::nodes::NodeLibrary;

fn check(text: &str) -> Checked {
    match read("example.json", text.as_bytes()) {
        Ok(document) => check_graph(&document, &NodeLibrary::standard()),
        Err(finding) => Checked { findings: vec![*finding], ..Checked::default() },
    }
}

#[test]
fn examples_of_codes_are_what_they_say() {
    let mut graphs = 0;
    for explanation in Explanation::ALL {
        let Explanation { code, wrong, right, .. } = explanation;
        assert!(!wrong.is_empty() && !right.is_empty() && wrong != right, "{code}");
        if !is_graph(wrong) {
            continue;
        }
        graphs += 1;
        let checked = check(wrong);
        let codes: Vec<_> = checked.findings.iter().map(|finding| finding.code).collect();
        assert_eq!(codes, [*code], "{wrong}\n{:#?}", checked.findings);
        assert_eq!(
            checked.graph.is_none(),
            explanation.severity == Severity::Error,
            "an error leaves no graph: {wrong}"
        );
        let checked = check(right);
        assert!(checked.findings.is_empty(), "{right}\n{:#?}", checked.findings);
        assert!(checked.graph.is_some());
    }
    // What needs other files or very large ones is abridged, and there are a few scenes, which
    // `tests/tests/scene_examples.rs` reads.
    assert!(graphs + 13 >= Explanation::ALL.len(), "{graphs} of {}", Explanation::ALL.len());
}

/// Whether an example is a whole graph, not a scene, a command or a part of a file.
fn is_graph(example: &str) -> bool {
    example.starts_with('{') && !example.contains("\"camera\"")
}

#[test]
fn codes_are_unique_and_told() {
    let mut names: Vec<_> = Explanation::ALL.iter().map(|explanation| explanation.code.0).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), Explanation::ALL.len());
    for explanation in Explanation::ALL {
        assert!(explanation.story.len() > 40, "{}", explanation.code);
        assert!(!explanation.title.ends_with('.'));
    }
}

/// `PHENOMENON_BLESS=1 cargo test -p phenomenon-compiler --test check_examples` writes it anew.
#[test]
fn the_page_of_diagnostics_is_in_sync() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/diagnostics.md");
    let page = phenomenon_compiler::diagnostics::documentation();
    if std::env::var_os("PHENOMENON_BLESS").is_some() {
        std::fs::write(&path, &page).unwrap();
    }
    let checked_in = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(checked_in == page, "docs/diagnostics.md differs; write it anew as this test says");
}
