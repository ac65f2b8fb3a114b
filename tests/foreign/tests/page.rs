//! `docs/adding-a-node.md` tells of nodes in another crate what this crate does.

const PAGE: &str = include_str!("../../../docs/adding-a-node.md");
const SHOWN: [(&str, &str, &str); 4] = [
    ("toml", "Cargo.toml", include_str!("../Cargo.toml")),
    ("rust", "src/posterize.rs", include_str!("../src/posterize.rs")),
    ("rust", "src/lib.rs", include_str!("../src/lib.rs")),
    ("rust", "tests/suite.rs", include_str!("suite.rs")),
];

#[test]
fn the_page_shows_what_is_compiled() {
    let (_, section) = PAGE.split_once("\n## Nodes in your own crate\n").expect("the section");
    let mut blocks = section.split("```").skip(1).step_by(2);
    for (language, file, text) in SHOWN {
        let block = blocks.next().unwrap_or_else(|| panic!("the page does not show {file}"));
        let (of, code) = block.split_once('\n').expect("a block of lines");
        assert_eq!(of, language, "{file}");
        assert!(text.contains(code), "{file} has another text than the page:\n{code}");
    }
    assert_eq!(blocks.next(), None, "a block of no file");
}
