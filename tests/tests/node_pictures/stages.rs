//! What nodes are shown on: a square that fills the picture, or a sphere under two lights.

use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document::read;
use phenomenon_compiler::engine::{Engine, Options, Shade, Shader};
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_runtime::film::Film;
use phenomenon_runtime::render::{Settings, render};
use phenomenon_runtime::scene_file::{MaterialRef, read_scene};
use serde_json::{Value, json};

/// What a graph is shown on.
#[derive(Clone, Copy)]
pub enum Stage {
    /// A square seen from straight above, u to the right and v upwards, each from 0 to 1.
    Square,
    /// A sphere, lit from the left and a little from the right.
    Sphere,
}

/// A graph, and what it is shown on.
pub struct Drawing {
    /// The phenomenon, as in a file.
    pub graph: Value,
    /// What wears it.
    pub stage: Stage,
}

fn scene(stage: Stage) -> Value {
    let environment = json!({ "file": "node.json" });
    match stage {
        Stage::Square => json!({
            "scene": "square", "version": 1,
            "camera": { "position": [0, 2, 0], "look_at": [0, 0, 0], "up": [0, 0, -1],
                "field_of_view": 28.0 },
            "objects": [{ "name": "square", "rectangle": { "width": 1, "depth": 1 }, "material": environment }],
            "lights": [],
        }),
        Stage::Sphere => json!({
            "scene": "sphere", "version": 1,
            "camera": { "position": [0, 0, 5], "look_at": [0, 0, 0], "field_of_view": 24.5 },
            "objects": [{ "name": "sphere", "sphere": { "center": [0, 0, 0], "radius": 1 }, "material": environment }],
            "lights": [
                { "name": "key", "directional": { "direction": [1, -1.1, -1.4] }, "intensity": 1.3 },
                { "name": "rim", "directional": { "direction": [-1, 0.1, -0.2] }, "color": [0.45, 0.6, 1], "intensity": 0.6 },
            ],
        }),
    }
}

/// The picture of a drawing, or what is wrong with its graph.
pub fn picture(library: &NodeLibrary, drawing: &Drawing, size: u32) -> Result<Film, String> {
    let text = drawing.graph.to_string();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../graphs/painted");
    let name = folder.join("node.json");
    let document = read(&name.to_string_lossy(), text.as_bytes()).expect("JSON");
    let checked = check_graph(&document, library);
    let errors: Vec<String> = checked.findings.iter().map(ToString::to_string).collect();
    let graph = checked.graph.ok_or_else(|| format!("{}\n{text}", errors.join("\n")))?;
    let scene = scene(drawing.stage).to_string();
    let file = read_scene("node_scene.json", scene.as_bytes(), &folder);
    let found: Vec<String> = file.findings.iter().map(ToString::to_string).collect();
    let scene = file.scene.unwrap_or_else(|| panic!("{}", found.join("\n")));
    let shader = shader(graph)?;
    let scene = scene
        .build(|_: &MaterialRef| Ok::<_, std::convert::Infallible>(Arc::clone(&shader)))
        .expect("a scene");
    let settings =
        Settings { width: size, height: size, samples: 9, threads: 1, ..Settings::default() };
    Ok(render(&scene, &settings, &|_, _| ()).expect("a small picture").film)
}

fn shader(graph: Graph) -> Result<Arc<dyn Shade>, String> {
    let options = Options { engine: Engine::Batch, ..Options::default() };
    let shader = Shader::new(Arc::new(graph), &[], options).map_err(|error| error.to_string())?;
    Ok(Arc::new(shader))
}
