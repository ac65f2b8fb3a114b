//! What we have of the nodes of others: `docs/coverage.md` is made of the lists in `compiler/src/diagnostics/peers`, and
//! they are held to the library.
//!
//! `PHENOMENON_BLESS=1 cargo test --workspace --test coverage` writes the page.

mod page;

use std::collections::BTreeSet;

use phenomenon_compiler::diagnostics::peers::{Entry, Have, LISTS};
use phenomenon_compiler::nodes::NodeLibrary;

/// Groups of MaterialX whose nodes are no patterns: they shade, or light, or join what does.
const NO_PATTERNS: [&str; 7] = ["material", "shader", "pbr", "light", "translation", "npr", "-"];
/// Nodes of the group `pbr` that compute values all the same.
const PATTERNS: [&str; 6] = [
    "roughness_anisotropy",
    "roughness_dual",
    "glossiness_anisotropy",
    "open_pbr_anisotropy",
    "blackbody",
    "artistic_ior",
];
/// At most one in so many of MaterialX's patterns may be missing without a reason.
const ONE_IN: usize = 10;

fn is_pattern(entry: &Entry) -> bool {
    !NO_PATTERNS.contains(&entry.group) || PATTERNS.contains(&entry.name)
}

#[test]
fn nodes_that_are_named_exist() {
    let library = NodeLibrary::standard();
    let ours: BTreeSet<&str> =
        library.iter().map(|(_, definition)| &*definition.signature.name).collect();
    for list in LISTS {
        let mut names = BTreeSet::new();
        for entry in list.entries() {
            assert!(names.insert(entry.name), "{}: `{}` stands twice", list.title, entry.name);
            let quoted: Vec<&str> = entry.named().collect();
            for name in &quoted {
                let is_other = name.contains([' ', '/']);
                assert!(is_other || ours.contains(name), "{}: there is no `{name}`", entry.name);
            }
            match entry.have {
                Have::Node | Have::Made => assert!(
                    !quoted.is_empty() || entry.have == Have::Made,
                    "{}: no node is named",
                    entry.name
                ),
                Have::Other | Have::No | Have::Later => {
                    assert!(entry.what.len() > 3, "{}: no reason is given", entry.name);
                }
            }
        }
    }
}

#[test]
fn the_lists_are_whole() {
    let counts = LISTS.map(|list| list.entries().count());
    assert!(
        counts[0] >= 223 && counts[1] >= 180 && counts[2] >= 150 && counts[3] >= 180,
        "{counts:?}"
    );
    // The modes that Blender's documentation counts.
    let modes = |of: &str| LISTS[3].entries().filter(|entry| entry.name.starts_with(of)).count();
    assert_eq!([modes("Math:"), modes("Vector_Math:"), modes("Mix_Color:")], [41, 30, 19]);
}

#[test]
fn few_patterns_of_materialx_are_missing_without_a_reason() {
    let patterns: Vec<Entry> = LISTS[0].entries().filter(is_pattern).collect();
    let missing: Vec<&str> =
        patterns.iter().filter(|it| it.have == Have::Later).map(|it| it.name).collect();
    assert!(patterns.len() > 140, "{} patterns", patterns.len());
    assert!(
        missing.len() * ONE_IN <= patterns.len(),
        "{} of {}: {missing:?}",
        missing.len(),
        patterns.len()
    );
}

#[test]
fn the_page_shows_the_lists() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/coverage.md");
    let page = page::page();
    if std::env::var_os("PHENOMENON_BLESS").is_some() {
        std::fs::write(path, &page).expect("the page can be written");
    }
    let written = std::fs::read_to_string(path).unwrap_or_default();
    assert!(
        written == page,
        "docs/coverage.md is another: run `PHENOMENON_BLESS=1 cargo test --workspace --test coverage`"
    );
}
