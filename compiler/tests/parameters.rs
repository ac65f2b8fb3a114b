//! Parameters of a compiled graph: proofs rest on their ranges, so no way in leads past them.

use std::sync::Arc;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document;
use phenomenon_compiler::effects::NoScene;
use phenomenon_compiler::engine::{Engine, Options, Shade, Shaded, Shader, ShaderError};
use phenomenon_compiler::graph::{BindError, Graph, RootKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::state::State;
use phenomenon_compiler::values::Literal;

const GRAPH: &str = r#"{
    "phenomenon": "ranged", "version": 1,
    "interface": {
        "ior": { "type": "scalar", "default": 1.5, "min": 1, "max": 4 },
        "layers": { "type": "integer", "default": 2, "min": 0, "max": 8 },
        "tint": { "type": "color", "default": [0.5, 0.5, 0.5], "min": 0, "max": 1 }
    },
    "nodes": {
        "point": { "type": "state" },
        "scaled": { "type": "multiply", "inputs": { "a": { "interface": "ior" }, "b": { "interface": "layers" } } },
        "shade": { "type": "mix", "inputs": {
            "a": { "interface": "tint" }, "b": [1, 1, 1], "weight": { "node": "seen" } } },
        "seen": { "type": "multiply", "inputs": {
            "a": { "node": "scaled" }, "b": { "node": "point", "output": "u" } } }
    },
    "roots": { "material": { "node": "shade" } }
}"#;

fn graph(library: &NodeLibrary) -> Arc<Graph> {
    let document = document::read("ranged.json", GRAPH.as_bytes()).expect("it is JSON");
    let checked = check_graph(&document, library);
    Arc::new(checked.graph.unwrap_or_else(|| panic!("{:?}", checked.findings)))
}

/// Values no parameter of the graph takes, each with what is wrong.
fn refused() -> Vec<(&'static str, Literal, &'static str)> {
    vec![
        ("ior", Literal::Scalar(-1.0), "range"),
        ("ior", Literal::Scalar(1.0_f32.next_down()), "range"),
        ("ior", Literal::Scalar(4.0_f32.next_up()), "range"),
        ("ior", Literal::Integer(5), "range"),
        ("ior", Literal::Scalar(f32::NAN), "finite"),
        ("ior", Literal::Scalar(f32::INFINITY), "finite"),
        ("ior", Literal::Vector([2.0; 3]), "type"),
        ("layers", Literal::Integer(-1), "range"),
        ("layers", Literal::Integer(i32::MAX), "range"),
        ("layers", Literal::Scalar(2.0), "type"),
        ("tint", Literal::Color([0.5, 0.5, 1.5, 1.0]), "range"),
        ("tint", Literal::Color([0.5, f32::NEG_INFINITY, 0.5, 1.0]), "finite"),
        ("tint", Literal::Scalar(-0.5), "range"),
        ("sheen", Literal::Scalar(0.5), "unknown"),
    ]
}

fn kind(error: &ShaderError) -> &'static str {
    match error {
        ShaderError::Bind(BindError::Range { .. }) => "range",
        ShaderError::Bind(BindError::NotFinite { .. }) => "finite",
        ShaderError::Bind(BindError::Type { .. }) => "type",
        ShaderError::Bind(BindError::Unknown { .. }) => "unknown",
        ShaderError::Jit(_) | ShaderError::Specialise(_) => "another",
    }
}

#[test]
fn ranges_hold_when_a_shader_is_made_and_when_it_is_set() {
    let library = NodeLibrary::standard();
    let graph = graph(&library);
    for engine in [Engine::Walk, Engine::Batch] {
        let options = Options { engine, ..Options::default() };
        let compile =
            |values: &[(String, Literal)]| Shader::new(Arc::clone(&graph), values, options);
        let mut shader = compile(&[]).expect("it compiles");
        for (name, value, expected) in refused() {
            let error = compile(&[(name.to_owned(), value.clone())]).expect_err("it is refused");
            assert_eq!(kind(&error), expected, "{name} = {value}: {error}");
            let before = shader.print();
            let error = shader.set(name, &value).expect_err("it is refused");
            assert_eq!(kind(&error), expected, "{name} = {value}: {error}");
            assert_eq!(shader.print(), before, "a refusal changes nothing");
        }
        // The ends themselves, and what is converted.
        for (name, value) in [
            ("ior", Literal::Scalar(1.0)),
            ("ior", Literal::Scalar(4.0)),
            ("ior", Literal::Integer(3)),
            ("layers", Literal::Integer(0)),
            ("tint", Literal::Scalar(1.0)),
        ] {
            shader.set(name, &value).unwrap_or_else(|error| panic!("{name} = {value}: {error}"));
        }
    }
}

/// A thread lends its shaders the same memory, where the words of the one before still lie.
#[test]
fn shaders_that_take_turns_see_their_own_words() {
    let library = NodeLibrary::standard();
    let graph = graph(&library);
    for engine in [Engine::Batch, Engine::Jit] {
        let options = Options { engine, ..Options::default() };
        let tinted = |tint: [f32; 4]| {
            let values = [("tint".to_owned(), Literal::Color(tint))];
            Shader::new(Arc::clone(&graph), &values, options).expect("it compiles")
        };
        let shaded = |shader: &Shader, points: usize| {
            let mut results = vec![Shaded::default(); points];
            let states = vec![State::default(); points];
            shader.shade(RootKind::Material, &states, &mut NoScene, &mut results);
            assert!(results.iter().all(|result| *result == results[0]), "{engine:?}");
            results[0].color
        };
        let (red, green) = ([1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0]);
        let (mut first, second) = (tinted(red), tinted(green));
        for points in [1, 1, 9, 300, 1] {
            assert_eq!((shaded(&first, points), shaded(&second, points)), (red, green));
        }
        first.set("tint", &Literal::Color(green)).expect("it is in range");
        assert_eq!(shaded(&first, 1), green);
        first.set("tint", &Literal::Color(red)).expect("it is in range");
        assert_eq!((shaded(&first, 1), shaded(&second, 1)), (red, green));
    }
}

/// What is written in the file is known when the graph is compiled; what is set is not.
#[test]
fn literals_are_constants_and_parameters_are_not() {
    let library = NodeLibrary::standard();
    let options = Options { engine: Engine::Batch, ..Options::default() };
    let shader = Shader::new(graph(&library), &[], options).expect("it compiles");
    let text = shader.print();
    let words = text.split([' ', '\n']);
    let (constants, uniforms): (Vec<&str>, Vec<&str>) =
        words.filter(|word| word.starts_with(['#', 'u'])).partition(|word| word.starts_with('#'));
    assert!(constants.contains(&"#3f800000"), "the white of the mix, in\n{text}");
    assert!(!uniforms.is_empty(), "the tint, in\n{text}");
}

/// A choice is a word of its input: nodes and parameters of the same name do not hide it.
#[test]
fn a_choice_may_have_the_name_of_a_node() {
    let library = NodeLibrary::standard();
    let check = |kind: &str, octaves: &str| {
        let text = format!(
            r#"{{ "phenomenon": "named", "version": 1,
                "interface": {{ "turbulence": {{ "type": "scalar", "default": 0.5 }} }},
                "nodes": {{
                    "noise": {{ "type": "perlin_noise", "inputs": {{ "kind": "{kind}", "octaves": {octaves} }} }},
                    "shade": {{ "type": "mix", "inputs": {{ "a": [0, 0, 0], "b": [1, 1, 1],
                        "weight": {{ "node": "both" }} }} }},
                    "both": {{ "type": "multiply", "inputs": {{
                        "a": {{ "node": "noise" }}, "b": {{ "interface": "turbulence" }} }} }} }},
                "roots": {{ "material": {{ "node": "shade" }} }} }}"#
        );
        let document = document::read("named.json", text.as_bytes()).expect("it is JSON");
        check_graph(&document, &library)
    };
    for kind in ["noise", "turbulence"] {
        let checked = check(kind, "3");
        assert!(checked.graph.is_some(), "{kind}: {:?}", checked.findings);
    }
    // What is no choice is taken for the node it names.
    let checked = check("shade", "3");
    assert!(checked.graph.is_none());
    assert!(checked.findings[0].message.contains("`kind`"), "{:?}", checked.findings);
    // No help leads to what is refused next: a connection, or another type.
    for octaves in ["\"two\"", "\"shade\"", "true", "[3]", "null"] {
        let checked = check("noise", octaves);
        let errors: Vec<_> = checked.findings.iter().map(|it| it.help.as_str()).collect();
        assert!(checked.graph.is_none());
        assert_eq!(errors, ["write a whole number in 1 to 8"], "{octaves}");
    }
}

/// A number that no integer can hold is told of once, with the range that holds here; so is one of a nested phenomenon.
#[test]
fn a_number_past_all_integers_is_told_of_once() {
    let library = NodeLibrary::standard();
    let folder = tempfile::tempdir().unwrap();
    let inner = r#"{ "phenomenon": "inner", "interface": {
        "count": { "type": "integer", "default": 1, "min": 0, "max": 5 },
        "any": { "type": "integer", "default": 1 } },
        "nodes": { "s": { "type": "add", "inputs": { "a": { "interface": "count" }, "b": { "interface": "any" } } } },
        "roots": { "material": { "node": "s" } } }"#;
    std::fs::write(folder.path().join("inner.json"), inner).unwrap();
    let told = |of: &str, input: &str, number: &str| -> Vec<String> {
        let text = format!(
            r#"{{ "phenomenon": "p", "nodes": {{ "n": {{ "type": {of}, "inputs": {{ "{input}": {number} }} }} }},
                "roots": {{ "material": {{ "node": "n" }} }} }}"#
        );
        let name = folder.path().join("p.json").display().to_string();
        let document = document::read(&name, text.as_bytes()).expect("it is JSON");
        let checked = check_graph(&document, &library);
        assert!(checked.graph.is_none(), "{input} {number}");
        checked.findings.into_iter().map(|finding| finding.help).collect()
    };
    let (noise, inner) = ("\"perlin_noise\"", r#"{ "file": "inner.json" }"#);
    for number in ["99999999999", "-2147483649", "1e30", "9", "0", "-0", "2147483647"] {
        assert_eq!(told(noise, "octaves", number), ["give a number in 1 to 8"], "{number}");
    }
    for number in ["99999999999", "6", "-1"] {
        assert_eq!(told(inner, "count", number), ["give a number in 0 to 5"], "{number}");
    }
    assert_eq!(told(inner, "any", "1e10"), ["give a number in -2147483648 to 2147483647"]);
    for number in ["1.5", "9.5", "0.5"] {
        assert_eq!(told(noise, "octaves", number).len(), 1, "{number}");
    }
    assert_eq!(told(noise, "octaves", "1e39").len(), 1);
}
