//! Phenomena within a file: names mean what they mean there.

use crate::editor::Editor;

const GRAPH: &str = r#"{ "phenomenon": "g",
  "interface": { "outer": { "type": "scalar", "default": 1 } },
  "phenomena": { "wave": {
    "interface": { "height": { "type": "scalar", "default": 0.5, "doc": "how high" } },
    "phenomena": { "deep": { "outputs": { "o": { "type": "scalar", "from": 1 } } } },
    "nodes": { "n": { "type": "sine", "inputs": { "input": { "interface": "height" } } },
      "d": { "type": { "phenomenon": "deep" } } },
    "outputs": { "crest": { "type": "scalar", "from": { "node": "n" }, "doc": "its top" },
      "low": { "type": "scalar", "from": { "node": "d" } } } } },
  "nodes": { "n": { "type": { "phenomenon": "wave" }, "inputs": { "height": { "interface": "outer" } } } },
  "outputs": { "all": { "type": "scalar", "from": { "node": "n", "output": "crest" } } },
  "presets": { "calm": { "outer": 0 } } }"#;

/// The graph with a part replaced, a bar in it.
fn with(old: &str, new: &str) -> String {
    assert!(GRAPH.contains(old), "{old}");
    GRAPH.replacen(old, new, 1)
}

#[test]
fn what_is_offered_is_what_is_known_there() {
    let mut editor = Editor::start();
    assert!(editor.open(GRAPH).is_empty());
    let mut labels = |old: &str, new: &str| editor.labels(&with(old, new));
    assert_eq!(labels(r#"{ "interface": "height" }"#, r#"{ "interface": "|" }"#), ["height"]);
    assert_eq!(labels(r#"{ "interface": "outer" }"#, r#"{ "interface": "|" }"#), ["outer"]);
    assert_eq!(labels(r#""from": { "node": "n" }"#, r#""from": { "node": "|" }"#), ["n", "d"]);
    assert_eq!(labels(r#""output": "crest""#, r#""output": "|""#), ["crest", "low"]);
    assert_eq!(labels(r#"{ "phenomenon": "deep" }"#, r#"{ "phenomenon": "|" }"#), ["deep", "wave"]);
    assert_eq!(labels(r#"{ "phenomenon": "wave" }"#, r#"{ "phenomenon": "|" }"#), ["wave"]);
    assert_eq!(labels(r#""calm": { "outer""#, r#""calm": { "|""#), ["outer"]);
    let keys = labels(r#""phenomena": { "wave": {"#, r#""phenomena": { "wave": { "|": 1,"#);
    assert!(keys.contains(&"outputs".to_owned()) && !keys.contains(&"presets".to_owned()));
    let types = labels(r#""all": { "type": "scalar""#, r#""all": { "type": "|""#);
    assert!(types.contains(&"vector".to_owned()) && !types.contains(&"shader".to_owned()));
    editor.end();
}

#[test]
fn names_lead_to_their_own_scope() {
    let mut editor = Editor::start();
    editor.open(GRAPH);
    let mut line_of = |old: &str, new: &str| {
        let given = editor.at_bar("textDocument/definition", &with(old, new));
        given["range"]["start"]["line"].as_u64()
    };
    assert_eq!(line_of(r#""from": { "node": "n" }"#, r#""from": { "node": "|n" }"#), Some(5));
    assert_eq!(line_of(r#"{ "node": "n", "output""#, r#"{ "node": "|n", "output""#), Some(9));
    assert_eq!(line_of(r#"{ "phenomenon": "deep" }"#, r#"{ "phenomenon": "d|eep" }"#), Some(4));
    assert_eq!(line_of(r#"{ "phenomenon": "wave" }"#, r#"{ "phenomenon": "w|ave" }"#), Some(2));
    assert_eq!(line_of(r#""output": "crest""#, r#""output": "c|rest""#), Some(7));
    assert_eq!(
        line_of(
            r#"{ "height": { "interface": "outer" }"#,
            r#"{ "he|ight": { "interface": "outer" }"#
        ),
        Some(3)
    );
    assert_eq!(line_of(r#""calm": { "outer""#, r#""calm": { "o|uter""#), Some(1));
    let told = editor.hover(&with(r#"{ "interface": "height" }"#, r#"{ "interface": "h|eight" }"#));
    assert!(told.contains("how high"), "{told}");
    editor.end();
}
