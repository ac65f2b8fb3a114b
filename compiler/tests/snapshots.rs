//! What small graphs become on the way to engines, as text: the schedule, and the operations the jit
//! compiles. One graph of each hard kind. A change that is meant is taken over by
//! `INSTA_UPDATE=always cargo test --workspace --test snapshots`.

use std::sync::Arc;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document;
use phenomenon_compiler::engine::{Engine, Options, Shader};
use phenomenon_compiler::nodes::NodeLibrary;

/// The schedule and the pieces of the graph with these nodes (and interface) and this material.
fn text(interface: &str, nodes: &str, material: &str) -> String {
    let graph = format!(
        r#"{{ "phenomenon": "g", "version": 1, "interface": {{ {interface} }},
              "nodes": {{ {nodes} }}, "roots": {{ "material": {material} }} }}"#
    );
    let library = NodeLibrary::standard();
    let document = document::read("g.json", graph.as_bytes()).expect("it is JSON");
    let checked = check_graph(&document, &library);
    let graph = checked.graph.unwrap_or_else(|| panic!("{:#?}", checked.findings));
    let options = Options { engine: Engine::Batch, ..Options::default() };
    let shader = Shader::new(Arc::new(graph), &[], options).expect("it compiles");
    format!("{}\n{}", shader.print(), shader.print_pieces())
}

macro_rules! snapshots {
    ($($name:ident: $interface:literal, $nodes:literal, $material:literal;)+) => { $(
        #[test]
        fn $name() {
            insta::assert_snapshot!(stringify!($name), text($interface, $nodes, $material));
        }
    )+ };
}

snapshots! {
    literals_are_folded: "",
        r#""s": { "type": "state" },
           "one": { "type": "multiply", "inputs": { "a": { "node": "s", "output": "u" }, "b": 1 } },
           "m": { "type": "mix", "inputs": { "weight": 0.5, "a": { "node": "one" }, "b": 0.25 } }"#,
        r#"{ "node": "m" }"#;
    parameters_are_loaded: r#""tint": { "type": "color", "default": [1, 0.5, 0.25] }"#,
        r#""s": { "type": "state" },
           "dark": { "type": "scale", "inputs": { "input": { "interface": "tint" }, "factor": 0.5 } },
           "m": { "type": "scale", "inputs": { "input": { "node": "dark" }, "factor": { "node": "s", "output": "u" } } }"#,
        r#"{ "node": "m" }"#;
    a_branch_is_forced_where_it_is_demanded: "",
        r#""s": { "type": "state" }, "mirror": { "type": "trace_reflection" },
           "m": { "type": "mix", "inputs": { "weight": { "node": "s", "output": "u" },
                  "a": [0, 0, 0], "b": { "node": "mirror", "output": "color" } } }"#,
        r#"{ "node": "m" }"#;
    a_request_of_two_users_is_made_once: "",
        r#""s": { "type": "state" }, "mirror": { "type": "trace_reflection" },
           "m": { "type": "mix", "inputs": { "weight": { "node": "s", "output": "u" },
                  "a": { "node": "mirror", "output": "color" }, "b": { "node": "n" } } },
           "n": { "type": "mix", "inputs": { "weight": { "node": "s", "output": "v" },
                  "a": { "node": "mirror", "output": "color" }, "b": 1 } }"#,
        r#"{ "node": "m" }"#;
    a_condition_asks_before_a_branch: "",
        r#""probe": { "type": "trace_transparent" }, "mirror": { "type": "trace_reflection" },
           "m": { "type": "select", "inputs": { "condition": { "node": "probe", "output": "hit" },
                  "if_true": { "node": "mirror", "output": "color" },
                  "if_false": { "node": "probe", "output": "color" } } }"#,
        r#"{ "node": "m" }"#;
    a_scope_asks_anew: "",
        r#""s": { "type": "state" }, "mirror": { "type": "trace_reflection" },
           "bent": { "type": "perturb_normal", "inputs": { "normal": { "node": "s", "output": "point" },
                     "input": { "node": "mirror", "output": "color" } } },
           "m": { "type": "add", "inputs": { "a": { "node": "bent" }, "b": { "node": "mirror", "output": "color" } } }"#,
        r#"{ "node": "m" }"#;
    a_loop_runs_its_body: "",
        r#""lit": { "type": "lambert" },
           "m": { "type": "light_loop", "inputs": { "body": { "node": "lit" } } }"#,
        r#"{ "node": "m" }"#;
    a_loop_in_a_branch: "",
        r#""s": { "type": "state" }, "lit": { "type": "lambert" },
           "loop": { "type": "light_loop", "inputs": { "body": { "node": "lit" } } },
           "m": { "type": "mix", "inputs": { "weight": { "node": "s", "output": "u" }, "a": 0, "b": { "node": "loop" } } }"#,
        r#"{ "node": "m" }"#;
    shaders_hand_on_their_colour: "",
        r#""s": { "type": "state" },
           "half": { "type": "scale", "inputs": { "input": { "node": "s", "output": "incoming" }, "factor": 0.5 } },
           "first": { "type": "combine_color", "inputs": { "r": { "node": "s", "output": "u" } } }"#,
        r#"[{ "node": "first" }, { "node": "half" }]"#;
    a_count_shapes_the_code: r#""octaves": { "type": "integer", "default": 2, "min": 1, "max": 8 }"#,
        r#""n": { "type": "perlin_noise", "inputs": { "octaves": { "interface": "octaves" } } }"#,
        r#"{ "node": "n" }"#;
}
