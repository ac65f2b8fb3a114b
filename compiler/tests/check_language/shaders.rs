//! Shaders as values, lists of them, and roots.

use std::sync::Arc;

use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::engine::{Options, Shade, Shader};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::state::State;

use super::files::{check_files, graph};
use super::shading::{color, shaded};

#[test]
fn a_shader_is_called_in_the_loop_of_the_phenomenon_it_is_given_to() {
    let lit = r#"{ "phenomenon": "lit",
        "interface": { "of_light": { "type": "shader" }, "lamps": { "type": "lights" } },
        "nodes": { "call": { "type": "call_shader", "inputs": { "shader": { "interface": "of_light" } } },
                   "all": { "type": "light_loop", "inputs": { "lights": { "interface": "lamps" }, "body": { "node": "call" } } } },
        "roots": { "material": { "node": "all" } } }"#;
    let user = r#"{ "phenomenon": "user",
        "interface": { "key": { "type": "light", "default": { "light": "key" } } },
        "nodes": {
            "diffuse": { "type": "lambert" },
            "one": { "type": { "file": "lit.json" }, "inputs": { "of_light": { "node": "diffuse" }, "lamps": { "interface": "key" } } },
            "three": { "type": { "file": "lit.json" }, "inputs": { "of_light": { "node": "diffuse" },
                "lamps": [{ "light": "a" }, { "light": "b" }, { "light": "c" }] } },
            "none": { "type": { "file": "lit.json" }, "inputs": { "of_light": null } },
            "s": { "type": "sum", "inputs": { "values": [{ "node": "one" }, { "node": "three" }, { "node": "none" }] } } },
        "roots": { "material": { "node": "s" } } }"#;
    let graph = graph(&[("user.json", user), ("lit.json", lit)]);
    // Four lamps of light (1, 2, 4) straight on a white surface.
    assert_eq!(color(&graph, &[]), [4.0, 8.0, 16.0, 1.0]);
    // A parameter that is read outside of a loop as well still may not come from a light.
    let both =
        lit.replace("\"material\": { \"node\": \"all\" }", "\"material\": { \"node\": \"call\" }");
    let checked = check_files(&[("user.json", user), ("lit.json", &both)]);
    let found: Vec<Code> = checked.findings.iter().map(|finding| finding.code).collect();
    assert!(found.contains(&Code::OUTSIDE_LIGHT_LOOP), "{found:?}");
}

#[test]
fn shaders_of_a_list_hand_their_color_on() {
    let text = r#"{ "phenomenon": "list",
        "nodes": {
            "state": { "type": "state" },
            "mirror": { "type": "trace_reflection" },
            "half": { "type": "multiply", "inputs": { "a": { "node": "state", "output": "incoming" }, "b": 0.5 } },
            "plus": { "type": "add", "inputs": { "a": { "node": "state", "output": "incoming" }, "b": { "node": "mirror" } } } },
        "roots": {
            "material": [[8, 4, 2], { "node": "half" }, { "node": "plus" }, { "node": "half" }, { "node": "plus" }],
            "volume": { "color": [{ "node": "half" }, { "node": "half" }], "ok": true },
            "shadow": [{ "node": "half" }] } }"#;
    let graph = graph(&[("list.json", text)]);
    let (color, asked) = shaded(&graph, RootKind::Material, &[], State::default());
    assert_eq!(color, [3.5, 2.5, 2.0, 1.0]);
    assert_eq!(asked.rays, 1, "what does not read the color handed on is shared");
    let state = State { incoming: [4.0, 8.0, 16.0, 0.5], ..State::default() };
    assert_eq!(shaded(&graph, RootKind::Volume, &[], state).0, [1.0, 2.0, 4.0, 0.5]);
    assert_eq!(shaded(&graph, RootKind::Shadow, &[], state).0, [2.0, 4.0, 8.0, 0.5]);
}

#[test]
fn roots_of_every_shader_type_are_kept_and_run() {
    for kind in RootKind::ALL {
        let text = format!(r#"{{ "phenomenon": "a", "roots": {{ "{}": 0.5 }} }}"#, kind.name());
        let graph = graph(&[("a.json", &text)]);
        assert_eq!(graph.roots[0].kind, kind);
        assert_eq!(shaded(&graph, kind, &[], State::default()).0, [0.5, 0.5, 0.5, 1.0]);
        let only: &[RootKind] = &[RootKind::Material];
        let options = Options { roots: only, ..Options::default() };
        let shader = Shader::new(Arc::new(graph), &[], options).unwrap();
        assert_eq!(shader.has_root(kind), kind == RootKind::Material);
    }
}

#[test]
fn a_phenomenon_of_a_number_is_a_grey_shader() {
    let inner = r#"{ "phenomenon": "inner", "interface": { "x": { "type": "scalar", "default": 0.25 } },
        "nodes": { "f": { "type": "square_root", "inputs": { "x": { "interface": "x" } } } },
        "roots": { "material": { "node": "f" } } }"#;
    let inner = inner.replace(
        "\"x\": { \"interface\"",
        &format!("\"{}\": {{ \"interface\"", {
            let library = NodeLibrary::standard();
            library.signature(library.find("square_root").unwrap()).inputs[0].name.clone()
        }),
    );
    let outer = r#"{ "phenomenon": "outer",
        "nodes": { "x": { "type": { "file": "inner.json" } },
                   "n": { "type": "call_shader", "inputs": { "shader": { "node": "x" } } } },
        "roots": { "material": { "node": "n" } } }"#;
    let graph = graph(&[("outer.json", outer), ("inner.json", &inner)]);
    assert_eq!(color(&graph, &[]), [0.5, 0.5, 0.5, 1.0]);
    // So is one whose root is the parameter itself.
    let plain = r#"{ "phenomenon": "inner", "interface": { "x": { "type": "integer", "default": 3 } },
        "roots": { "material": { "interface": "x" } } }"#;
    let given = outer.replace("\"inner.json\" }", "\"inner.json\" }, \"inputs\": { \"x\": 2 }");
    let files = [("outer.json", given.as_str()), ("inner.json", plain)];
    assert_eq!(color(&self::graph(&files), &[]), [2.0, 2.0, 2.0, 1.0]);
}
