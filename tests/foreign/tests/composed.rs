//! What composing costs the jit: nothing. A graph of elementary nodes and one node of the same maths become the same
//! operations, and as many bytes of machine code.

use std::sync::Arc;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document;
use phenomenon_compiler::effects::NoScene;
use phenomenon_compiler::emit::Real as _;
use phenomenon_compiler::engine::jit::Generator;
use phenomenon_compiler::engine::{Engine, Options, Shade, Shaded, Shader};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::node;
use phenomenon_compiler::state::State;

node! {
    /// A wave over a plane, by hand: what the graph below composes.
    wave in foreign,
    source "",
    inputs {
        /// Along the wave.
        u: scalar = 0.0;
        /// Across it.
        v: scalar = 0.0;
    }
    outputs {
        /// Its height.
        height: scalar;
    }
    body |e, i| Outputs { height: (i.u * 3.0 + i.v).sin() * i.u }
}

const COMPOSED: &str = r#"
    "steep": { "type": "multiply", "inputs": { "a": { "node": "here", "output": "u" }, "b": 3 } },
    "moved": { "type": "add", "inputs": { "a": { "node": "steep" }, "b": { "node": "here", "output": "v" } } },
    "bent": { "type": "sine", "inputs": { "input": { "node": "moved" } } },
    "height": { "type": "multiply", "inputs": { "a": { "node": "bent" }, "b": { "node": "here", "output": "u" } } }"#;

const BY_HAND: &str = r#"
    "height": { "type": "wave", "inputs": {
        "u": { "node": "here", "output": "u" }, "v": { "node": "here", "output": "v" } } }"#;

fn shader(nodes: &str, generator: Generator) -> Shader {
    let text = format!(
        r#"{{ "phenomenon": "g", "version": 1, "nodes": {{
            "here": {{ "type": "state" }}, {nodes},
            "shade": {{ "type": "scale", "inputs": {{ "input": [0.5, 0.25, 1], "factor": {{ "node": "height" }} }} }}
        }}, "roots": {{ "material": {{ "node": "shade" }} }} }}"#
    );
    let mut library = phenomenon_foreign_nodes::library();
    library.add(definition());
    let document = document::read("g.json", text.as_bytes()).expect("it is JSON");
    let checked = check_graph(&document, &library);
    let graph = checked.graph.unwrap_or_else(|| panic!("{:#?}", checked.findings));
    let generator = Some(generator);
    let options = Options { engine: Engine::Jit, generator, ..Options::default() };
    Shader::new(Arc::new(graph), &[], options).expect("it compiles")
}

#[test]
fn composed_and_as_one_node_it_is_the_same_code() {
    for generator in Generator::ALL {
        // Beside Cranelift, bodies this heavy stay kernels, which are another thing for one node and for four.
        if generator.available().is_err() || generator == Generator::Cranelift {
            continue;
        }
        let shaders = [COMPOSED, BY_HAND].map(|nodes| shader(nodes, generator));
        let results = shaders.each_ref().map(|shader| {
            let points = [0.25, -1.5, 40.0].map(|u| State { uv: [u, u + 0.5], ..State::default() });
            let mut results = [Shaded::default(); 3];
            shader.shade(RootKind::Material, &points, &mut NoScene, &mut results);
            results.map(|result| result.color.map(f32::to_bits))
        });
        assert_eq!(results[0], results[1]);
        // Loads may stand in another order; each operation is there once in both.
        let operations = shaders.each_ref().map(|shader| {
            let text = shader.print_pieces();
            let names = text.lines().filter_map(|line| line.split_once(" = ")?.1.split(' ').next());
            let mut names: Vec<String> = names.map(str::to_owned).collect();
            names.sort();
            names
        });
        assert!(operations[0].len() > 10);
        assert_eq!(operations[0], operations[1]);
        let bytes =
            shaders.each_ref().map(|shader| shader.plans().next().expect("it ran").code_bytes());
        assert_eq!(bytes[0], bytes[1]);
    }
}
