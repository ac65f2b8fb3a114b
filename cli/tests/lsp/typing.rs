//! Findings, completion and docs while one types.

use serde_json::{Value, json};

use crate::GRAPH;
use crate::editor::{Editor, URI};

#[test]
fn findings_live_while_one_types() {
    let mut editor = Editor::start();
    assert!(editor.open(GRAPH).is_empty());
    let found = editor
        .change(&GRAPH.replace("\"doc\": \"the é😀 colour\"", "\"doc\": \"é😀\", \"mni\": 0"));
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0]["code"], "unknown-key");
    assert_eq!(found[0]["severity"], 1);
    // Characters of the protocol are UTF-16: é is one of them, 😀 two.
    assert_eq!(
        found[0]["range"],
        json!({ "start": { "line": 2, "character": 80 }, "end": { "line": 2, "character": 85 } })
    );
    assert!(found[0]["message"].as_str().unwrap().contains("did you mean `min`?"));
    let found = editor.change(&GRAPH[..GRAPH.len() - 3]);
    assert_eq!(found[0]["code"], "syntax");
    // All mistakes of a file that is no JSON are told.
    let found = editor.change(&GRAPH.replace("\"doc\": \"the", "doc: \"the").replace("0.5", ".5"));
    assert!(found.len() >= 2 && found.iter().all(|it| it["code"] == "syntax"), "{found:?}");
    assert!(editor.change(GRAPH).is_empty());
    editor.tell("textDocument/didClose", json!({ "textDocument": { "uri": URI } }));
    assert!(editor.findings().is_empty());
    editor.end();
}

#[test]
fn names_are_completed_in_unfinished_files() {
    let mut editor = Editor::start();
    editor.open(GRAPH);
    let types = editor.labels(&GRAPH.replace("\"trace_reflection\"", "\"tra|"));
    assert!(types.iter().any(|it| it == "trace_refraction") && types.len() > 40, "{types:?}");
    let inputs = editor.labels(&GRAPH.replace("\"weight\": 0.5", "\"|"));
    assert_eq!(inputs, ["weight", "a", "b"]);
    let nodes = editor.labels(&GRAPH.replace("\"node\": \"mirror\"", "\"node\": \"|"));
    assert_eq!(nodes, ["mirror", "shade"]);
    let outputs = editor.labels(&GRAPH.replace("\"output\": \"color\"", "\"output\": \"|"));
    assert_eq!(outputs, ["color", "ok", "hit", "distance"]);
    let parameters =
        editor.labels(&GRAPH.replace("{ \"interface\": \"tint\" }", "{ \"interface\": |"));
    assert_eq!(parameters, ["tint"]);
    let roots = editor.labels(&GRAPH.replace("\"material\"", "\"|"));
    assert!(roots.contains(&"shadow".to_owned()));
    // Outside of a string the quotes are put in, within one they are there.
    let item = |editor: &mut Editor, written: &str| {
        let text = GRAPH.replace("\"node\": \"mirror\"", &format!("\"node\": {written}"));
        editor.at_bar("textDocument/completion", &text)[0].clone()
    };
    let bare = item(&mut editor, "|");
    assert_eq!(
        (&bare["insertText"], &bare["detail"]),
        (&json!("\"mirror\""), &json!("trace_reflection"))
    );
    assert_eq!(item(&mut editor, "\"mi|")["insertText"], "mirror");
    let keys = editor.labels("{ \"|");
    assert!(keys.contains(&"phenomenon".to_owned()));
    assert!(editor.labels("|").is_empty());
    editor.end();
}

/// Whatever a parameter may be is offered, at any depth, and the keys of that type.
#[test]
fn declarations_are_completed() {
    let mut editor = Editor::start();
    editor.open(GRAPH);
    let mut labels = |written: &str| {
        let mut labels =
            editor.labels(&format!(r#"{{ "phenomenon": "a", "interface": {{ {written}"#));
        labels.sort_unstable();
        labels
    };
    let types = labels(r#""a": { "type": "|"#);
    assert_eq!(types.len(), 13, "{types:?}");
    for of in ["scalar", "transform", "string", "texture", "light", "shader", "array", "struct"] {
        assert!(types.iter().any(|it| it == of), "{of} in {types:?}");
    }
    assert_eq!(labels(r#""a": { "type": "array", "of": { "type": "|"#), types);
    assert_eq!(labels(r#""a": { "type": "struct", "members": { "b": { "type": "|"#), types);
    let of_arrays = labels(r#""a": { "type": "array", "|"#);
    assert_eq!(of_arrays, ["default", "doc", "editor", "of", "type"]);
    let of_structs = labels(r#""a": { "type": "array", "of": { "type": "struct", "|"#);
    assert_eq!(of_structs, ["default", "doc", "editor", "members", "type"]);
    let of_numbers = labels(r#""a": { "type": "scalar", "|"#);
    assert!(of_numbers.contains(&"soft_max".to_owned()) && !of_numbers.contains(&"of".to_owned()));
    assert!(labels(r#""a": { "default": { "|"#).is_empty());
    editor.end();
}

#[test]
fn docs_are_told_where_the_pointer_is() {
    let mut editor = Editor::start();
    editor.open(GRAPH);
    let mix = editor.hover(&GRAPH.replace("\"mix\"", "\"m|ix\""));
    for part in [
        "**mix** (color)",
        "Linear mix `a (1 - weight) + b weight`",
        "Inputs: `weight` scalar, `a` scalar | vector | color",
        "Outputs: `result`",
        "Source: mental ray base shaders, mib_color_mix",
    ] {
        assert!(mix.contains(part), "{part} is missing in {mix}");
    }
    let weight = editor.hover(&GRAPH.replace("\"weight\"", "\"wei|ght\""));
    assert!(weight.starts_with("`weight` scalar") && weight.contains("Range: 0 to 1"), "{weight}");
    assert!(editor.hover(&GRAPH.replace("\"weight\"", "\"wei|ght\"")).contains("Share of `b`"));
    assert!(
        editor
            .hover(&GRAPH.replace("\"node\": \"mirror\"", "\"node\": \"mir|ror\""))
            .contains("**trace_reflection**")
    );
    assert!(
        editor
            .hover(&GRAPH.replace("\"interface\": \"tint\"", "\"interface\": \"ti|nt\""))
            .contains("the é😀 colour")
    );
    assert_eq!(editor.hover(&GRAPH.replace("\"roots\"", "\"ro|ots\"")), "");
    editor.end();
}

/// Characters of the protocol are UTF-16, whatever stands before them on the line.
#[test]
fn places_count_in_utf_16_on_lines_that_are_not_ascii() {
    let mut editor = Editor::start();
    let graph = |name: &str, shade: &str| {
        format!(
            "{{ \"phenomenon\": \"a\", \"doc\": \"é😀語\", \"nodes\": {{ \"{name}\": {{ \"type\": \"mix\" }} }}, \"roots\": {{ \"material\": {shade} }} }}"
        )
    };
    editor.open(&graph("n", "1"));
    let shade = "{ \"node\": \"n|\" }";
    assert!(editor.hover(&graph("n", shade)).contains("**mix**"));
    assert_eq!(editor.labels(&graph("n", "{ \"node\": \"|")), ["n"]);
    let text = graph("n", "{ \"node\": \"m\" }");
    let found = editor.change(&text);
    let place = &found[0]["range"];
    let utf_16: Vec<u16> = text.encode_utf16().collect();
    let at = |end: &str| place[end]["character"].as_u64().unwrap() as usize;
    assert_eq!(String::from_utf16(&utf_16[at("start")..at("end")]).unwrap(), "\"m\"");
    // A position within a character, past a line, past the file or none at all is survived.
    for position in [
        json!({ "line": 0, "character": 31 }),
        json!({ "line": 0, "character": u64::MAX }),
        json!({ "line": u64::MAX, "character": 0 }),
        json!({ "line": -1, "character": -1 }),
        json!({ "line": "0" }),
        Value::Null,
    ] {
        for method in ["textDocument/hover", "textDocument/completion"] {
            let params = json!({ "textDocument": { "uri": URI }, "position": position });
            assert!(editor.ask(method, params)["error"].is_null(), "{position}");
        }
    }
    editor.end();
}

#[test]
fn an_input_that_is_a_choice_offers_its_names() {
    let mut editor = Editor::start();
    let node = |input: &str| {
        format!(
            r#"{{ "phenomenon": "p", "nodes": {{ "n": {{ "type": "perlin_noise", "inputs": {{ {input} }} }} }}, "roots": {{ "material": {{ "node": "n" }} }} }}"#
        )
    };
    assert_eq!(editor.labels(&node(r#""kind": "|""#)), ["noise", "turbulence"]);
    assert!(editor.labels(&node(r#""octaves": |"#)).is_empty());
}
