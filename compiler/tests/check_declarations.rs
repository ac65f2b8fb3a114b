//! Declarations of arrays, structs and the like: what is too much of them, and what is wrong.

use phenomenon_compiler::check::{MAX_PARTS, MAX_SHADERS, check_graph};
use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::document::read;
use phenomenon_compiler::nodes::NodeLibrary;

fn codes(text: &str) -> Vec<Code> {
    let document = read("a.json", text.as_bytes()).unwrap();
    let checked = check_graph(&document, &NodeLibrary::standard());
    checked.findings.iter().map(|finding| finding.code).collect()
}

#[test]
fn values_of_lists_are_bounded_before_they_are_made() {
    let ones = vec!["1"; 30_000].join(",");
    let nodes: Vec<String> = (0..300)
        .map(|at| format!(r#""n{at}":{{"type":"sum","inputs":{{"values":{{"interface":"a"}}}}}}"#))
        .collect();
    let text = format!(
        r#"{{"phenomenon":"p","interface":{{"a":{{"type":"array","of":{{"type":"scalar"}},"default":[{ones}]}}}},
           "nodes":{{{}}},"roots":{{"material":{{"node":"n0"}}}}}}"#,
        nodes.join(",")
    );
    assert_eq!(codes(&text), [Code::TOO_MANY_NODES]);
    let many = vec!["1"; 600_000].join(",");
    let text = format!(
        r#"{{"phenomenon":"p","interface":{{"i":{{"type":"integer","default":0}}}},"nodes":{{"n":{{"type":"element",
           "inputs":{{"index":{{"interface":"i"}},"values":[{many}]}}}}}},"roots":{{"material":{{"node":"n"}}}}}}"#
    );
    assert_eq!(codes(&text), [Code::TOO_MANY_NODES]);
}

#[test]
fn parts_and_lists_are_bounded() {
    let rows = vec!["0"; 300].join(",");
    let columns = vec![format!("[{rows}]"); 300].join(",");
    let text = format!(
        r#"{{ "phenomenon": "a", "interface": {{ "m": {{ "type": "array",
            "of": {{ "type": "array", "of": {{ "type": "scalar" }} }}, "default": [{columns}] }} }},
            "roots": {{ "material": {{ "interface": "m[0][0]" }} }} }}"#
    );
    const { assert!(MAX_PARTS < 300 * 300) };
    assert_eq!(codes(&text), [Code::TOO_MANY_PARTS]);
    let shaders = vec!["[0, 0, 0]"; MAX_SHADERS + 1].join(",");
    let list = format!(r#"{{ "phenomenon": "a", "roots": {{ "material": [{shaders}] }} }}"#);
    assert_eq!(codes(&list), [Code::NUMBER_OUT_OF_RANGE]);
    let few = list.replacen("[0, 0, 0],", "", 1);
    assert_eq!(codes(&few), []);
}

#[test]
fn a_mistake_in_a_declaration_is_one_mistake() {
    for (declaration, code) in [
        (
            r#""type": "struct", "members": { "x": { "type": "scaler", "default": 1 } }"#,
            Code::UNKNOWN_CHOICE,
        ),
        (r#""type": "struct", "members": []"#, Code::WRONG_KIND),
        (r#""type": "struct""#, Code::MISSING_KEY),
        (r#""type": "array", "default": [1]"#, Code::MISSING_KEY),
        (r#""type": "array", "of": "scalar", "default": [1]"#, Code::WRONG_KIND),
        (r#""type": "array", "of": { "type": "scalar" }, "default": 1"#, Code::WRONG_KIND),
        (
            r#""type": "array", "of": { "type": "scalar", "min": 2, "max": 1 }, "default": [1]"#,
            Code::EMPTY_RANGE,
        ),
        (
            r#""type": "struct", "members": { "x": { "type": "scalar", "default": 1 } }, "default": [1]"#,
            Code::WRONG_KIND,
        ),
        (
            r#""type": "struct", "members": { "x.y": { "type": "scalar", "default": 1 } }"#,
            Code::BAD_NAME,
        ),
        (r#""type": "texture", "default": { "texture": 1 }"#, Code::WRONG_KIND),
        (r#""type": "texture", "default": { "texture": "no.png" }"#, Code::UNREADABLE_FILE),
        (r#""type": "aray", "of": { "type": "scalar" }, "default": [1]"#, Code::UNKNOWN_CHOICE),
        (r#""type": "integer", "default": "a", "values": ["a"], "min": 5"#, Code::UNKNOWN_KEY),
        (r#""type": "string", "default": 1"#, Code::TYPE_MISMATCH),
        (r#""type": "string", "default": "a", "min": 0"#, Code::UNKNOWN_KEY),
        (r#""type": "shader", "default": 1"#, Code::TYPE_MISMATCH),
        (r#""type": "light", "default": null"#, Code::TYPE_MISMATCH),
        (r#""type": "light", "default": { "lihgt": "key" }"#, Code::TYPE_MISMATCH),
    ] {
        let text = format!(
            r#"{{ "phenomenon": "a", "interface": {{ "p": {{ {declaration} }} }},
                "nodes": {{ "s": {{ "type": "string_equal", "inputs": {{ "a": {{ "interface": "p.x" }} }} }} }},
                "roots": {{ "material": {{ "color": 1, "ok": {{ "node": "s" }} }} }} }}"#
        );
        let found = codes(&text);
        let about_p: Vec<Code> = found.iter().copied().filter(|of| *of == code).collect();
        assert_eq!(about_p, [code], "{declaration}: {found:?}");
    }
}
