//! Strings, textures and transforms.

use std::sync::Arc;

use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::engine::{Options, Shade, Shaded, Shader};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::State;
use phenomenon_compiler::values::{Literal, Space, Texture, Type};

use super::files::{codes, graph};
use super::shading::{Asked, shaded};

#[test]
fn strings_are_compared_before_shading() {
    let text = r#"{ "phenomenon": "finish",
        "interface": { "finish": { "type": "string", "default": "mirror" } },
        "nodes": {
            "is_mirror": { "type": "string_equal", "inputs": { "a": { "interface": "finish" }, "b": "mirror" } },
            "mirror": { "type": "trace_reflection" },
            "shade": { "type": "select", "inputs": { "condition": { "node": "is_mirror" },
                "if_true": { "node": "mirror" }, "if_false": [0, 0, 1] } } },
        "roots": { "material": { "node": "shade" } } }"#;
    let graph = graph(&[("finish.json", text)]);
    let with = |finish: &str| {
        let value = graph.bind("finish", finish).unwrap();
        let (color, asked) =
            shaded(&graph, RootKind::Material, &[("finish", value)], State::default());
        (color, asked.rays)
    };
    assert_eq!(with("mirror"), ([1.0; 4], 1));
    assert_eq!(with("Mirror"), ([0.0, 0.0, 1.0, 1.0], 0));
    assert_eq!(with("").1, 0);
    // A new value of a parameter turns the choice.
    let mut shader = Shader::new(Arc::new(graph), &[], Options::default()).unwrap();
    shader.set("finish", &Literal::String("matte".into())).unwrap();
    let mut asked = Asked::default();
    let mut results = [Shaded::default()];
    shader.shade(RootKind::Material, &[State::default()], &mut asked, &mut results);
    assert_eq!((results[0].color, asked.rays), ([0.0, 0.0, 1.0, 1.0], 0));
}

const PAPERED: &str = r#"{ "phenomenon": "papered",
    "interface": { "paper": { "type": "texture", "default": { "texture": "wood.png" } } },
    "nodes": { "read": { "type": "texture_lookup", "inputs": { "texture": { "interface": "paper" }, "v": 0.75 } } },
    "roots": { "material": { "color": { "node": "read" }, "ok": { "node": "read", "output": "ok" } } } }"#;

#[test]
fn textures_are_resolved_beside_their_file_and_read_once() {
    let graph = graph(&[("folder/papered.json", PAPERED), ("folder/wood.png", "")]);
    let state = State { uv: [0.125, 0.5], ..State::default() };
    let (color, asked) = shaded(&graph, RootKind::Material, &[], state);
    assert_eq!(color, [0.125, 0.75, 0.25, 0.5]);
    assert_eq!(asked.lookups, 1);
    let wood = Texture { file: "folder/wood.png".into(), space: Space::Srgb };
    assert_eq!(asked.textures, std::slice::from_ref(&wood));
    let data = graph.bind("paper", "bump.png,linear").unwrap();
    let (_, asked) = shaded(&graph, RootKind::Material, &[("paper", data)], state);
    assert_eq!(asked.textures, [Texture { file: "bump.png".into(), space: Space::Linear }]);
    // Without a texture nothing is asked, and nothing is there.
    let none = graph.bind("paper", "").unwrap();
    let (color, asked) = shaded(&graph, RootKind::Material, &[("paper", none)], state);
    assert_eq!((color, asked.lookups, asked.textures.len()), ([0.0; 4], 0, 0));
    // Nor is there where a coordinate is not finite.
    let state = State { uv: [f32::NAN, 0.0], ..State::default() };
    assert_eq!(shaded(&graph, RootKind::Material, &[], state).0, [0.0; 4]);

    let mut shader = Shader::new(Arc::new(graph), &[], Options::default()).unwrap();
    assert_eq!(shader.textures(), [wood].into());
    shader.set("paper", &Literal::Texture(None)).unwrap();
    assert!(shader.textures().is_empty());
}

#[test]
fn transforms_are_values_like_others() {
    let text = r#"{ "phenomenon": "placed",
        "interface": { "place": { "type": "transform", "default": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1] } },
        "nodes": {
            "state": { "type": "state" },
            "moved": { "type": "transform_point", "inputs": { "transform": { "interface": "place" }, "point": { "node": "state", "output": "point" } } },
            "parts": { "type": "split_vector", "inputs": { "vector": { "node": "moved" } } },
            "shade": { "type": "combine_color", "inputs": { "r": { "node": "parts", "output": "x" }, "g": { "node": "parts", "output": "y" }, "b": { "node": "parts", "output": "z" } } } },
        "roots": { "material": { "node": "shade" } } }"#;
    let graph = graph(&[("placed.json", text)]);
    assert_eq!(graph.parameters[0].value_type, Type::Transform);
    let state = State { point: [1.0, 2.0, 3.0], ..State::default() };
    assert_eq!(shaded(&graph, RootKind::Material, &[], state).0, [6.0, 8.0, 10.0, 1.0]);
    let value = graph.bind("place", "0,1,0,0, 1,0,0,0, 0,0,2,0, 0,0,0,1").unwrap();
    assert_eq!(
        shaded(&graph, RootKind::Material, &[("place", value)], state).0,
        [2.0, 1.0, 6.0, 1.0]
    );
    for wrong in ["1", "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,2", "x,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1"] {
        assert!(graph.bind("place", wrong).unwrap_err().to_string().contains("sixteen"), "{wrong}");
    }
    let nan = graph.bind("place", "NaN,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1").unwrap_err();
    assert!(nan.to_string().contains("not finite"), "{nan}");
}

#[test]
fn what_is_called_texture_doc_or_editor_is_no_texture_by_that() {
    let inner = r#"{ "phenomenon": "inner", "interface": { "texture": { "type": "string", "default": "wood" } },
        "nodes": { "editor": { "type": "string_equal", "inputs": { "a": { "interface": "texture" }, "b": "stone" } },
                   "s": { "type": "select", "inputs": { "condition": { "node": "editor" } } } },
        "roots": { "material": { "node": "s" } } }"#;
    let outer = r#"{ "phenomenon": "outer", "nodes": { "n": { "type": { "file": "inner.json" }, "inputs": { "texture": "stone" } } },
        "roots": { "material": { "node": "n" } } }"#;
    graph(&[("outer.json", outer), ("inner.json", inner)]);
    let missing = r#"{ "phenomenon": "a", "nodes": { "doc": { "type": "texture_lookup", "inputs": { "texture": { "texture": "no.png" } } } },
        "roots": { "material": { "node": "doc" } } }"#;
    assert_eq!(codes(missing), [Code::UNREADABLE_FILE]);
    let text = missing.replace(r#"{ "texture": "no.png" }"#, r#""no.png""#);
    assert_eq!(codes(&text), [Code::TYPE_MISMATCH]);
}
