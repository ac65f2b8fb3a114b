//! What README.md shows works.

use crate::program::{Folder, printed};

#[test]
fn the_graph_in_the_readme_evaluates() {
    let readme = concat!(env!("CARGO_MANIFEST_DIR"), "/../README.md");
    let readme = std::fs::read_to_string(readme).unwrap();
    let (_, rest) = readme.split_once("```json\n").expect("README shows a graph");
    let (graph, _) = rest.split_once("```").expect("the graph ends");
    let folder = Folder::new();
    let graph = folder.file("tinted_mirror.json", graph);
    for ior in ["1", "1.5", "4"] {
        let json = printed(&["eval", &graph, "--set", &format!("ior={ior}"), "--format", "json"]);
        assert!(json.contains("shade.result"), "{json}");
    }
}
