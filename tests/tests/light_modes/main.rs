//! Loops over lights that modes choose: the same in all engines and by the definition, and what a mode leaves out
//! is not evaluated. And the environment among the lights.

mod environment;

use std::convert::Infallible;
use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document;
use phenomenon_compiler::effects::LightMode;
use phenomenon_compiler::engine::jit::Generator;
use phenomenon_compiler::engine::{Engine, Options, Shade, Shader};
use phenomenon_compiler::graph::{Binding, Graph};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::testing::build::Build;
use phenomenon_compiler::values::Literal;
use phenomenon_runtime::render::{Settings, render};
use phenomenon_runtime::scene::Scene;
use phenomenon_runtime::scene_file::{MaterialRef, read_scene};

const MODES: [LightMode; 4] =
    [LightMode::Listed, LightMode::Inclusive, LightMode::Exclusive, LightMode::All];

fn names(names: &[&str]) -> Binding {
    Binding::Literal(Literal::Lights(names.iter().map(|&name| name.to_owned()).collect()))
}

#[test]
fn engines_agree_with_the_definition_in_every_mode() {
    for mode in MODES {
        for list in [&[][..], &["key"], &["rim", "key"]] {
            let mut build = Build::new();
            let lambert = build.node("lambert", &[]);
            let arriving = build.node("light_color", &[]);
            let number = Binding::Literal(Literal::Integer(mode as i32));
            let mut over = |body: Binding| {
                let inputs = [("lights", names(list)), ("mode", number.clone()), ("body", body)];
                build.node("light_loop", &inputs).first()
            };
            // The same lights twice, and all of them.
            let (one, other) = (over(lambert.first()), over(arriving.first()));
            let all = build.node("light_loop", &[("body", arriving.first())]);
            let two = build.node("add", &[("a", one), ("b", other)]);
            let sum = build.node("add", &[("a", two.first()), ("b", all.first())]);
            build.material(sum.first()).agree(3);
        }
    }
}

/// A floor under three lights, one of which has three samples.
const SCENE: &str = r#"{
    "scene": "modes",
    "camera": { "position": [0, 3, 0.1], "look_at": [0, 0, 0] },
    "objects": [{ "rectangle": { "width": 100, "depth": 100 }, "material": { "subject": true } }],
    "lights": [
        { "name": "a", "directional": { "direction": [0, -1, 0] }, "color": [1, 0, 0] },
        { "name": "b", "sphere": { "position": [0, 9, 0], "radius": 1, "samples": 3 }, "color": [0, 1, 0], "intensity": 80 },
        { "name": "c", "spot": { "position": [0, 9, 0], "direction": [0, -1, 0] }, "color": [0, 0, 1], "intensity": 80 }
    ]
}"#;

/// A graph whose body must be seen through a shading model.
fn graph(model: &str, lights: &str, mode: &str) -> Arc<Graph> {
    let text = format!(
        r#"{{ "phenomenon": "lit", "version": 1, "nodes": {{
            "body": {{ "type": "{model}" }},
            "lit": {{ "type": "light_loop", "inputs": {{ "lights": {lights}, "mode": "{mode}", "body": {{ "node": "body" }} }} }} }},
            "roots": {{ "material": {{ "node": "lit" }} }} }}"#
    );
    let document = document::read("lit", text.as_bytes()).unwrap();
    let checked = check_graph(&document, &NodeLibrary::standard());
    Arc::new(checked.graph.unwrap_or_else(|| panic!("{:?}", checked.findings)))
}

fn scene(graph: &Arc<Graph>, options: Options) -> Scene {
    let file = read_scene("modes", SCENE.as_bytes(), Path::new("."));
    assert!(file.findings.is_empty(), "{:?}", file.findings);
    let shader = |_: &MaterialRef| -> Result<Arc<dyn Shade>, Infallible> {
        Ok(Arc::new(Shader::new(Arc::clone(graph), &[], options).unwrap()))
    };
    file.scene.unwrap().build(shader).unwrap()
}

#[test]
fn lights_a_mode_leaves_out_light_nothing_and_cost_no_ray() {
    let ab = r#"[{ "light": "b" }, { "light": "a" }]"#;
    // The list and the mode; which of the lights shine, and how many samples they have.
    let cases = [
        (ab, "listed", [true, true, false], 4),
        (ab, "inclusive", [true, true, false], 4),
        (ab, "exclusive", [false, false, true], 1),
        (ab, "all", [true; 3], 5),
        ("[]", "listed", [true; 3], 5),
        ("[]", "inclusive", [false; 3], 0),
        ("[]", "exclusive", [true; 3], 5),
    ];
    let jit = |generator| Options { engine: Engine::Jit, generator, ..Options::default() };
    let walk = Options { engine: Engine::Walk, ..Options::default() };
    let batch = Options { engine: Engine::Batch, ..Options::default() };
    let settings = Settings { width: 8, height: 6, samples: 2, threads: 1, ..Settings::default() };
    for model in ["lambert", "oren_nayar", "ggx"] {
        for (lights, mode, shine, samples) in cases {
            let graph = graph(model, lights, mode);
            let all = [walk, batch, jit(None), jit(Some(Generator::Cranelift))];
            let pictures =
                all.map(|options| render(&scene(&graph, options), &settings, &|_, _| ()).unwrap());
            for picture in &pictures {
                let what = format!("{model} {lights} {mode}");
                assert_eq!(picture.statistics.rays.eye, 96);
                assert_eq!(picture.statistics.rays.shadow, 96 * samples, "{what}");
                assert!(picture.film.pixels() == pictures[0].film.pixels(), "{what}");
                for pixel in picture.film.pixels() {
                    assert_eq!([0, 1, 2].map(|channel| pixel[channel] > 0.0), shine, "{what}");
                }
            }
        }
    }
}
