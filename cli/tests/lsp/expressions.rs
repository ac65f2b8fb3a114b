//! Within the text of expressions, and in what maps and folds are given.

use serde_json::{Value, json};

use crate::editor::{Editor, URI};

const GRAPH: &str = r#"{ "phenomenon": "g",
  "interface": { "tint": { "type": "color", "default": 1, "doc": "the paint" }, "look": { "type": "struct", "members": { "gloss": { "type": "scalar", "default": 1 } } } },
  "nodes": { "here": { "type": "state" },
    "grain": { "type": "perlin_noise", "inputs": { "position": { "expression": "here.point * half", "where": { "half": { "expression": "look.gloss / 2" } } } } } },
  "roots": { "material": { "expression": "\u00e9 * tint * half", "where": { "é": { "node": "grain" }, "half": { "expression": "é * grain" } } } } }"#;

/// Puts a bar behind the `nth` (from 0) of what stands in the graph.
fn bar(nth: usize, what: &str) -> String {
    let (at, _) = GRAPH.match_indices(what).nth(nth).unwrap();
    let at = at + what.len();
    format!("{}|{}", &GRAPH[..at], &GRAPH[at..])
}

/// The text of a root in a graph with names, ending where the cursor stands.
fn typed(text: &str) -> String {
    let (before, after) = GRAPH.split_once(r#""\u00e9 * tint * half""#).unwrap();
    format!("{before}\"{text}|\"{after}")
}

#[test]
fn names_functions_and_components_are_offered() {
    let mut editor = Editor::start();
    editor.open(GRAPH);
    let names = editor.labels(&typed("2 * "));
    for name in [
        "tint",
        "look",
        "here",
        "grain",
        "é",
        "half",
        "pi",
        "true",
        "smoothstep",
        "perlin_noise",
        "mix",
    ] {
        assert!(names.iter().any(|it| it == name), "{name}");
    }
    for no in ["light_loop", "sum", "roots", "node", "x"] {
        assert!(!names.iter().any(|it| it == no), "{no}");
    }
    let items = editor.at_bar("textDocument/completion", &typed("smo"));
    let item = items.as_array().unwrap().iter().find(|it| it["label"] == "smoothstep").unwrap();
    let types = "scalar | vector | color";
    assert_eq!(item["detail"], format!("(low: scalar, high: scalar, input: {types}) → {types}"));
    for (text, expected) in [
        ("tint.", &["r", "g", "b", "a", "xyz", "rgb"][..]),
        ("tint.r", &["r", "g", "b", "a", "xyz", "rgb"]),
        ("look.", &["gloss"]),
        ("(tint * 2).", &["x", "y", "z", "r", "g", "b", "a", "xyz", "rgb"]),
        ("nothing.", &[]),
    ] {
        let labels = editor.labels(&typed(text));
        assert!(
            expected.iter().all(|it| labels.iter().any(|label| label == it)),
            "{text} {labels:?}"
        );
        assert_eq!(labels.len(), expected.len(), "{text} {labels:?}");
    }
    let outputs = editor.labels(&typed("here."));
    assert!(outputs.iter().any(|it| it == "point") && outputs.iter().any(|it| it == "u"));
    let arguments = editor.labels(&typed("mix(weight: 1, "));
    assert_eq!(arguments[..3], ["weight", "a", "b"]);
    // What is bound later, or elsewhere, is not known.
    let inner = GRAPH.replace("\"é * grain\"", "\"|\"");
    let names = editor.labels(&inner);
    assert!(names.iter().any(|it| it == "é") && !names.iter().any(|it| it == "half"));
    editor.end();
}

#[test]
fn names_in_a_text_tell_what_they_are() {
    let mut editor = Editor::start();
    editor.open(GRAPH);
    for (nth, what, expected) in [
        (0, "* tint", "the paint"),
        (0, "\"here", "**state**"),
        (0, "here.point", "`point` vector"),
        (0, "point * half", "`look.gloss / 2`"),
        (0, "tint * half", "`é * grain`"),
        (0, "* grain", "**perlin_noise**"),
        (0, "\"look", "parameter `look`"),
    ] {
        let told = editor.hover(&bar(nth, what));
        assert!(told.contains(expected), "{what}: {told}");
    }
    let called =
        typed("smoothstep(0, 1, pi)").replace("smoothstep(0, 1, pi)|", "smooth|step(0, 1, pi)");
    assert!(editor.hover(&called).contains("**smooth_step**"));
    let called = typed("mix(weight: pi, a: 1, b: 2)")
        .replace("weight: pi, a: 1, b: 2)|", "wei|ght: pi, a: 1, b: 2)");
    assert!(editor.hover(&called).starts_with("`weight` scalar"));
    editor.end();
}

#[test]
fn names_in_a_text_lead_to_where_they_are_given() {
    let mut editor = Editor::start();
    editor.open(GRAPH);
    let line = |answer: &Value| answer["range"]["start"]["line"].as_u64();
    for (nth, what, given) in [
        (0, "* tint", 1),
        (0, "\"here", 2),
        (0, "point * half", 3),
        (0, "tint * half", 4),
        (0, "* grain", 3),
        (0, "\"look", 1),
    ] {
        let answer = editor.at_bar("textDocument/definition", &bar(nth, what));
        assert_eq!((answer["uri"].as_str(), line(&answer)), (Some(URI), Some(given)), "{what}");
    }
    let of_a_node = editor.at_bar("textDocument/prepareRename", &bar(0, "point"));
    assert!(of_a_node.is_null(), "an output of a node is renamed");
    // `grain`: its key, the text of `half`, and what `é` is; `half` is two names.
    for (nth, what, marks) in
        [(0, "* grain", 3), (0, "tint * half", 2), (0, "point * half", 2), (0, "* tint", 2)]
    {
        let answer = editor.at_bar("textDocument/documentHighlight", &bar(nth, what));
        assert_eq!(answer.as_array().map(Vec::len), Some(marks), "{what}");
    }
    editor.end();
}

#[test]
fn renaming_reaches_into_texts_and_keeps_what_they_mean() {
    let mut editor = Editor::start();
    editor.open(GRAPH);
    let mut rename = |what: &str, new: &str| {
        let text = bar(0, what);
        let at = text.find('|').unwrap();
        let line = text[..at].matches('\n').count();
        let start = text[..at].rfind('\n').map_or(0, |at| at + 1);
        let character = text[start..at].encode_utf16().count();
        let params = json!({ "textDocument": { "uri": URI }, "position": { "line": line, "character": character }, "newName": new });
        editor.ask("textDocument/rename", params)
    };
    let count =
        |answer: &Value| answer["result"]["documentChanges"][0]["edits"].as_array().map(Vec::len);
    assert_eq!(count(&rename("* tint", "paint")), Some(2));
    assert_eq!(count(&rename("* grain", "noise")), Some(3));
    assert_eq!(count(&rename("point * half", "quarter")), Some(2));
    for (what, new, why) in [
        ("* tint", "two-tone", "expressions name it"),
        ("* tint", "not", "expressions name it"),
        ("* tint", "grain", "`grain` is there already"),
        ("* grain", "half", "`half` is there already"),
    ] {
        let answer = rename(what, new);
        assert!(
            answer["error"]["message"].as_str().unwrap_or_default().starts_with(why),
            "{what} {new} {answer}"
        );
    }
    editor.end();
}

#[test]
fn maps_and_folds_have_the_inputs_of_their_bodies() {
    let graph = |inputs: &str| {
        format!(
            r#"{{ "phenomenon": "g", "phenomena": {{ "turn": {{ "interface": {{
                "item": {{ "type": "scalar", "default": 0 }}, "index": {{ "type": "integer", "default": 0 }},
                "accumulated": {{ "type": "color", "default": 0, "doc": "below" }},
                "gloss": {{ "type": "scalar", "default": 1, "doc": "how it shines" }} }},
                "outputs": {{ "y": {{ "type": "color", "from": {{ "expression": "accumulated * item * gloss" }} }} }} }} }},
            "nodes": {{ "all": {{ "type": {{ "fold": {{ "phenomenon": "turn" }} }}, "inputs": {{ {inputs} }} }} }},
            "roots": {{ "material": {{ "node": "all" }} }} }}"#
        )
    };
    let mut editor = Editor::start();
    editor.open(&graph(""));
    assert_eq!(editor.labels(&graph("\"|\"")), ["over", "initial", "gloss"]);
    assert!(
        editor
            .hover(&graph("\"over\": [1], \"initial\": 0, \"glo|ss\": 2"))
            .contains("how it shines")
    );
    assert!(editor.hover(&graph("\"over\": [1], \"ini|tial\": 0")).contains("below"));
    let answer = editor
        .at_bar("textDocument/definition", &graph("\"over\": [1], \"initial\": 0, \"glo|ss\": 2"));
    assert_eq!(answer["range"]["start"]["line"], 3);
    let name = graph("\"over\": [1], \"initial\": 0")
        .replace("{ \"phenomenon\": \"turn\"", "{ \"phenomenon\": \"tu|rn\"");
    assert_eq!(editor.at_bar("textDocument/definition", &name)["range"]["start"]["line"], 0);
    editor.end();
}
