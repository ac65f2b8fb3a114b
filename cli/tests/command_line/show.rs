//! `phenomenon show`.

use std::fs;

use crate::program::{Folder, printed, refused};

const GRAPHS: [&str; 7] = [
    "graphs/coated/coated_glass.json",
    "graphs/constant/constant_simple.json",
    "graphs/floor/checker_floor.json",
    "graphs/glass/advanced_glass.json",
    "graphs/mirror/tinted_mirror.json",
    "graphs/rainbow/rainbow.json",
    "graphs/sky/gradient_sky.json",
];

#[test]
fn shipped_graphs_are_drawn_the_same_each_time() {
    let folder = Folder::new();
    for graph in GRAPHS {
        for name in ["drawing.svg", "drawing.dot"] {
            let path = folder.path(name);
            assert_eq!(printed(&["show", graph, "-o", &path]), "", "{graph}");
            let first = fs::read_to_string(&path).expect("it was written");
            assert_eq!(printed(&["show", graph, "-o", &path]), "", "{graph}");
            assert_eq!(first, fs::read_to_string(&path).expect("it was written"), "{graph}");
            let stem = graph.rsplit('/').next().and_then(|name| name.strip_suffix(".json"));
            assert!(first.contains(stem.expect("a JSON file")), "{graph}");
        }
    }
}

#[test]
fn what_cannot_be_drawn_or_written_is_refused() {
    let folder = Folder::new();
    let svg = folder.path("a.svg");
    let graph = "graphs/mirror/tinted_mirror.json";
    refused(&["show", graph], &["-o"]);
    refused(&["show", graph, "-o", "a.png"], &[".svg or .dot"]);
    refused(&["show", graph, "-o", &folder.path("none/a.svg")], &["there is no folder"]);
    refused(&["show", "graphs/none.json", "-o", &svg], &["graphs/none.json"]);
    let broken = folder.file("broken.json", "{");
    refused(&["show", &broken, "-o", &svg], &["add the missing `}`"]);
    let mut nodes = r#""n0": { "type": "add" }"#.to_owned();
    for at in 1..5_500 {
        let before = at - 1;
        nodes += &format!(
            r#", "n{at}": {{ "type": "add", "inputs": {{ "a": {{ "node": "n{before}" }} }} }}"#
        );
    }
    let text = format!(
        r#"{{ "phenomenon": "long", "version": 1, "nodes": {{ {nodes} }},
             "roots": {{ "material": {{ "node": "n5499" }} }} }}"#
    );
    let long = folder.file("long.json", text);
    refused(&["show", &long, "-o", &svg], &["5501 boxes", "5000", ".dot"]);
    assert!(!fs::exists(&svg).expect("the folder can be read"), "nothing is left behind");
    printed(&["show", &long, "-o", &folder.path("long.dot")]);
}
