//! When the jit makes code, and who shares it.

use std::sync::Arc;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document;
use phenomenon_compiler::effects::NoScene;
use phenomenon_compiler::engine::jit::{Generator, Plan};
use phenomenon_compiler::engine::{Engine, Options, Shade, Shaded, Shader};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::state::{RayType, State};
use phenomenon_compiler::values::Literal;

/// Looks at the ray type, and mixes by a parameter.
const BY_RAY: &str = r#"{
    "phenomenon": "by_ray", "version": 1,
    "interface": { "share": { "type": "scalar", "default": 0.25, "min": 0, "max": 1 },
                   "gain": { "type": "scalar", "default": 2 } },
    "nodes": {
        "here": { "type": "state" },
        "seen": { "type": "ray_switch", "inputs": { "eye": [0.5, 0.25, 0.125], "reflection": { "node": "here", "output": "incoming" } } },
        "gained": { "type": "scale", "inputs": { "input": { "node": "seen" }, "factor": { "interface": "gain" } } },
        "shade": { "type": "mix", "inputs": {
            "weight": { "interface": "share" }, "a": { "node": "gained" }, "b": { "node": "here", "output": "incoming" } } }
    },
    "roots": { "material": { "node": "shade" } }
}"#;

/// Mixes by a parameter: within the mix, what is left of 1 depends on it alone.
const MIXED: &str = r#"{
    "phenomenon": "NAME", "version": 1,
    "interface": { "share": { "type": "scalar", "default": 0.25, "min": 0.125, "max": 0.875 },
                   "tint": { "type": "color", "default": [0.5, 0.25, 0.75] } },
    "nodes": {
        "here": { "type": "state" },
        "shade": { "type": "mix", "inputs": {
            "weight": { "interface": "share" }, "a": { "interface": "tint" }, "b": { "node": "here", "output": "incoming" } } }
    },
    "roots": { "material": { "node": "shade" } }
}"#;

fn shader(text: &str, engine: Engine, values: &[(String, Literal)]) -> Shader {
    let library = NodeLibrary::standard();
    let document = document::read("graph.json", text.as_bytes()).expect("it is JSON");
    let checked = check_graph(&document, &library);
    let graph = checked.graph.unwrap_or_else(|| panic!("{:?}", checked.findings));
    let options = Options { engine, ..Options::default() };
    Shader::new(Arc::new(graph), values, options).expect("it compiles")
}

fn colors(shader: &Shader, ray_type: RayType) -> Vec<[u32; 4]> {
    let points = [0.0, 0.5, 1.0, -3.0].map(|x| State {
        incoming: [x, 0.25, x + 1.0, 1.0],
        ray_type,
        ..State::default()
    });
    let mut results = [Shaded::default(); 4];
    shader.shade(RootKind::Material, &points, &mut NoScene, &mut results);
    results.iter().map(|result| result.color.map(f32::to_bits)).collect()
}

fn only_plan(shader: &Shader) -> &Plan {
    let plans: Vec<&Plan> = shader.plans().collect();
    assert_eq!(plans.len(), 1);
    plans[0]
}

#[test]
fn code_is_made_for_the_ray_types_that_occur_when_they_occur() {
    if Generator::chosen(None).is_err() {
        return;
    }
    let jit = shader(BY_RAY, Engine::Jit, &[]);
    let walk = shader(BY_RAY, Engine::Walk, &[]);
    assert_eq!(jit.plans().count(), 0, "nothing was shaded yet");
    let mut made = 0;
    for ray_type in [RayType::Reflection, RayType::Eye] {
        made += 1;
        for _ in 0..2 {
            assert_eq!(colors(&jit, ray_type), colors(&walk, ray_type), "{ray_type:?}");
            assert_eq!(jit.plans().count(), made);
        }
    }
    assert_eq!(jit.points(), [("walk", 0), ("batch", 0), ("jit", 16)]);
    assert!(jit.jit_failure().is_none());
}

#[test]
fn shaders_of_the_same_operations_share_their_code() {
    if Generator::chosen(None).is_err() {
        return;
    }
    let share = |value| ("share".to_owned(), Literal::Scalar(value));
    let shaders = [
        shader(&MIXED.replace("NAME", "one"), Engine::Jit, &[]),
        shader(&MIXED.replace("NAME", "two"), Engine::Jit, &[share(0.5)]),
    ];
    let other = MIXED.replace("\"incoming\"", "\"time\"");
    let other = shader(&other, Engine::Jit, &[]);
    for shader in shaders.iter().chain([&other]) {
        colors(shader, RayType::Eye);
    }
    let [one, two] = shaders.each_ref().map(only_plan);
    assert!(one.shares_code_with(two));
    assert!(!one.shares_code_with(only_plan(&other)));
    // Their words are their own.
    for (jit, value) in shaders.iter().zip([0.25, 0.5]) {
        let walk = shader(MIXED, Engine::Walk, &[share(value)]);
        assert_eq!(colors(jit, RayType::Eye), colors(&walk, RayType::Eye));
    }
}

#[test]
fn an_edit_of_a_live_parameter_compiles_nothing_and_is_seen() {
    if Generator::chosen(None).is_err() {
        return;
    }
    let mut jit = shader(MIXED, Engine::Jit, &[]);
    let print = jit.print_pieces();
    assert!(
        print.contains("when parameters are bound"),
        "a part of the mix is computed before\n{print}"
    );
    colors(&jit, RayType::Eye);
    let before: *const Plan = only_plan(&jit);
    for value in [0.5, 0.125, 0.875] {
        let value = Literal::Scalar(value);
        jit.set("share", &value).expect("it is in range");
        let walk = shader(MIXED, Engine::Walk, &[("share".to_owned(), value)]);
        assert_eq!(colors(&jit, RayType::Eye), colors(&walk, RayType::Eye));
        assert!(std::ptr::eq(before, only_plan(&jit)), "the plan is another one");
    }
}
