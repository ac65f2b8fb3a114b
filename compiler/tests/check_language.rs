//! What the language says beyond single values, and that engines run it: arrays, structs, strings,
//! textures, transforms, shaders, and lists of shaders in roots.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use phenomenon_compiler::check::{Checked, Files, check_graph_with};
use phenomenon_compiler::diagnostics::{Code, Finding, Place, SourceFile};
use phenomenon_compiler::document::{Document, read};
use phenomenon_compiler::effects::{
    Answer, LightList, LightSample, Ray, Renderer, TextureId, Trace,
};
use phenomenon_compiler::engine::{Engine, Options, Shade, Shaded, Shader};
use phenomenon_compiler::graph::{Graph, RootKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::state::State;
use phenomenon_compiler::values::{Literal, Space, Texture, Type};

/// Files that exist in memory only.
struct InMemory(HashMap<PathBuf, String>);

impl Files for InMemory {
    fn read(&self, path: &Path) -> Result<Document, Box<Finding>> {
        let name = path.display().to_string();
        match self.0.get(path) {
            Some(text) => read(&name, text.as_bytes()),
            None => {
                let file = Arc::new(SourceFile::new(name, ""));
                let place = Place { file, start: 0, end: 0, path: String::new() };
                Err(Box::new(Finding::new(Code::UNREADABLE_FILE, place, "no such file", "")))
            }
        }
    }

    fn identity(&self, path: &Path) -> PathBuf {
        path.to_owned()
    }

    fn unusable(&self, path: &Path) -> Option<String> {
        (!self.0.contains_key(path)).then(|| "no such file".into())
    }
}

fn check_files(files: &[(&str, &str)]) -> Checked {
    let texts = files.iter().map(|(name, text)| (PathBuf::from(name), (*text).to_owned()));
    let document = read(files[0].0, files[0].1.as_bytes()).unwrap();
    check_graph_with(&document, &NodeLibrary::standard(), &InMemory(texts.collect()))
}

fn check(text: &str) -> Checked {
    check_files(&[("a.json", text), ("wood.png", "")])
}

fn graph(files: &[(&str, &str)]) -> Graph {
    let checked = check_files(files);
    let findings: Vec<String> = checked.findings.iter().map(ToString::to_string).collect();
    assert!(findings.is_empty(), "{}", findings.join("\n"));
    checked.graph.unwrap()
}

fn codes(text: &str) -> Vec<Code> {
    check(text).findings.iter().map(|finding| finding.code).collect()
}

/// A renderer in which reflections see 1, refractions 0.5, and every texture its coordinates.
#[derive(Default)]
struct Asked {
    rays: usize,
    textures: Vec<Texture>,
    lookups: usize,
}

impl Renderer for Asked {
    fn trace(&mut self, trace: Trace, rays: &[Ray], answers: &mut [Answer]) {
        self.rays += rays.len();
        let x = if trace == Trace::Reflection { 1.0 } else { 0.5 };
        answers.fill(Answer { color: [x, x, x, 1.0], ok: true, hit: true, distance: 2.0 });
    }
    fn texture(&mut self, texture: &Texture) -> TextureId {
        self.textures.push(texture.clone());
        TextureId(7)
    }
    fn read_texture(
        &mut self,
        texture: TextureId,
        coordinates: &[[f32; 2]],
        colors: &mut [Option<[f32; 4]>],
    ) {
        assert_eq!(texture, TextureId(7));
        self.lookups += coordinates.len();
        for ([u, v], color) in coordinates.iter().zip(colors) {
            *color = u.is_finite().then_some([*u, *v, 0.25, 0.5]);
        }
    }
    fn light_list(&mut self, names: &[String]) -> LightList {
        LightList(names.len() as u32)
    }
    fn light_count(&mut self, list: LightList) -> usize {
        list.0 as usize
    }
    fn light_samples(&mut self, _: LightList, _: usize, _: &[State], samples: &mut [LightSample]) {
        let direction = [0.0, 0.0, 1.0];
        samples.fill(LightSample { direction, distance: 0.0, reachable: true, token: 0 });
    }
    fn light_colors(&mut self, _: &[State], _: &[u64], colors: &mut [[f32; 3]]) {
        colors.fill([1.0, 2.0, 4.0]);
    }
}

/// The color of a root with these values, the same in every engine, and what was asked for it.
fn shaded(
    graph: &Graph,
    root: RootKind,
    values: &[(&str, Literal)],
    state: State,
) -> ([f32; 4], Asked) {
    let library = Arc::new(NodeLibrary::standard());
    let values: Vec<(String, Literal)> =
        values.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
    let mut all = Vec::new();
    for engine in [Engine::Walk, Engine::Batch, Engine::Jit] {
        let options = Options { engine, ..Options::default() };
        let shader =
            Shader::new(Arc::new(graph.clone()), Arc::clone(&library), &values, options).unwrap();
        let mut asked = Asked::default();
        let mut results = [Shaded::default()];
        shader.shade(root, &[state], &mut asked, &mut results);
        all.push((results[0].color, asked));
    }
    let (color, asked) = all.remove(0);
    for (other, of_other) in all {
        assert_eq!(color.map(f32::to_bits), other.map(f32::to_bits));
        assert_eq!((asked.rays, asked.lookups), (of_other.rays, of_other.lookups));
    }
    (color, asked)
}

fn color(graph: &Graph, values: &[(&str, Literal)]) -> [f32; 4] {
    shaded(graph, RootKind::Material, values, State::default()).0
}

const LAYERS: &str = r#"{
    "phenomenon": "layers",
    "interface": {
        "layers": {
            "type": "array",
            "of": { "type": "struct", "members": {
                "tint": { "type": "color", "default": [0.5, 0.5, 0.5] },
                "weights": { "type": "array", "of": { "type": "scalar", "min": 0, "max": 8 },
                             "default": [1, 2] } } },
            "default": [{ "struct": {} }, { "struct": { "tint": [1, 0, 0], "weights": [4, 8] } }]
        }
    },
    "nodes": {
        "first": { "type": "scale", "inputs": { "input": { "interface": "layers[0].tint" },
                                                "factor": { "interface": "layers[0].weights[1]" } } },
        "second": { "type": "scale", "inputs": { "input": { "interface": "layers[1].tint" },
                                                 "factor": { "interface": "layers[1].weights[0]" } } },
        "both": { "type": "add", "inputs": { "a": { "node": "first" }, "b": { "node": "second" } } },
        "rest": { "type": "sum", "inputs": { "values": { "interface": "layers[0].weights" } } },
        "shade": { "type": "multiply", "inputs": { "a": { "node": "both" }, "b": { "node": "rest" } } }
    },
    "roots": { "material": { "node": "shade" } }
}"#;

#[test]
fn every_part_of_arrays_and_structs_is_a_parameter() {
    let graph = graph(&[("layers.json", LAYERS)]);
    let names: Vec<&str> = graph.parameters.iter().map(|of| of.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "layers[0].tint",
            "layers[0].weights[0]",
            "layers[0].weights[1]",
            "layers[1].tint",
            "layers[1].weights[0]",
            "layers[1].weights[1]"
        ]
    );
    assert_eq!(graph.parameters[1].range, 0.0..=8.0);
    assert_eq!(color(&graph, &[]), [15.0, 3.0, 3.0, 1.0]);
    let value = graph.bind("layers[1].weights[0]", "0.5").unwrap();
    assert_eq!(color(&graph, &[("layers[1].weights[0]", value)]), [4.5, 3.0, 3.0, 1.0]);
    assert!(graph.bind("layers[1].weights[0]", "9").is_err(), "ranges hold for every element");
    let error = graph.bind("layers[2].tint", "1").unwrap_err().to_string();
    assert!(error.contains("`layers` has 2 values, 0 to 1"), "{error}");
}

#[test]
fn compounds_are_handed_to_phenomena_whole_and_in_parts() {
    let with = |inputs: &str| {
        format!(
            r#"{{ "phenomenon": "user",
                "interface": {{ "own": {{ "type": "array", "of": {{ "type": "struct", "members": {{
                    "tint": {{ "type": "color", "default": [0, 1, 0] }},
                    "weights": {{ "type": "array", "of": {{ "type": "integer" }}, "default": [1, 1] }} }} }},
                    "default": [{{ "struct": {{}} }}, {{ "struct": {{}} }}] }} }},
                "nodes": {{ "n": {{ "type": {{ "file": "layers.json" }}, "inputs": {{ {inputs} }} }},
                            "keep": {{ "type": "scale", "inputs": {{ "input": {{ "interface": "own[0].tint" }}, "factor": {{ "interface": "own[1].weights[1]" }} }} }},
                            "out": {{ "type": "add", "inputs": {{ "a": {{ "node": "n" }}, "b": {{ "node": "keep" }} }} }} }},
                "roots": {{ "material": {{ "node": "out" }} }} }}"#
        )
    };
    let shade = |inputs: &str| {
        let text = with(inputs);
        let checked = check_files(&[("user.json", &text), ("layers.json", LAYERS)]);
        let errors: Vec<String> = checked.findings.iter().map(ToString::to_string).collect();
        color(&checked.graph.unwrap_or_else(|| panic!("{errors:?}")), &[])
    };
    // Whole: integers become the scalars the other wants.
    assert_eq!(shade(r#""layers": { "interface": "own" }"#), [0.0, 5.0, 0.0, 1.0]);
    // An element is a part of the own array, the other one a literal whose missing parts have defaults.
    let mixed = r#""layers": [{ "interface": "own[0]" }, { "struct": { "tint": [0, 0, 1] } }]"#;
    assert_eq!(shade(mixed), [0.0, 3.0, 8.0, 1.0]);
    let wrong = |inputs: &str| -> Vec<Code> {
        let text = with(inputs);
        let checked = check_files(&[("user.json", &text), ("layers.json", LAYERS)]);
        checked.findings.iter().map(|finding| finding.code).collect()
    };
    assert_eq!(wrong(r#""layers": { "interface": "own[0]" }"#), [Code::TYPE_MISMATCH]);
    assert_eq!(wrong(r#""layers": { "interface": "own[0].tint" }"#), [Code::TYPE_MISMATCH]);
    assert_eq!(wrong(r#""layers": [{ "struct": {} }]"#), [Code::WRONG_LENGTH]);
    assert_eq!(
        wrong(r#""layers": [{ "struct": { "weights": [1, 99] } }, { "struct": {} }]"#),
        [Code::NUMBER_OUT_OF_RANGE]
    );
}

#[test]
fn an_element_is_chosen_lazily_and_passes_unchanged() {
    let text = r#"{ "phenomenon": "choice",
        "interface": { "which": { "type": "integer", "default": 0 } },
        "nodes": {
            "mirror": { "type": "trace_reflection" },
            "glass": { "type": "trace_refraction", "inputs": { "direction": [0, 0, -1] } },
            "shade": { "type": "element", "inputs": { "index": { "interface": "which" }, "values": [
                [-0.0, 1e-45, 0.25, 0.75], { "node": "mirror" }, { "node": "glass" }, 3 ] } } },
        "roots": { "material": { "node": "shade" } } }"#;
    let graph = graph(&[("choice.json", text)]);
    let chosen = |which: i32| {
        let value = Literal::Integer(which);
        let (color, asked) =
            shaded(&graph, RootKind::Material, &[("which", value)], State::default());
        (color.map(f32::to_bits), asked.rays)
    };
    let first = ([-0.0_f32, 1e-45, 0.25, 0.75].map(f32::to_bits), 0);
    assert_eq!([chosen(i32::MIN), chosen(-1), chosen(0)], [first; 3]);
    assert_eq!(chosen(1), ([1.0_f32; 4].map(f32::to_bits), 1));
    assert_eq!(chosen(2), ([0.5_f32, 0.5, 0.5, 1.0].map(f32::to_bits), 1));
    let last = ([3.0_f32, 3.0, 3.0, 1.0].map(f32::to_bits), 0);
    assert_eq!([chosen(3), chosen(4), chosen(i32::MAX)], [last; 3]);
}

#[test]
fn sums_run_in_list_order() {
    let sum = |values: &str| {
        let text = format!(
            r#"{{ "phenomenon": "sum", "nodes": {{ "s": {{ "type": "sum", "inputs": {{ "values": {values} }} }} }},
               "roots": {{ "material": {{ "node": "s" }} }} }}"#
        );
        color(&graph(&[("sum.json", &text)]), &[])
    };
    assert_eq!(sum("[1e8, 1, -1e8]")[0], 0.0, "1 is lost in the first sum");
    assert_eq!(sum("[1e8, -1e8, 1]")[0], 1.0);
    assert_eq!(sum("[-0.0]")[0].to_bits(), (-0.0_f32).to_bits(), "one value is itself");
    assert_eq!(sum("[[1, 2, 3, 0.25], 1, [0, 0, 1, 7]]"), [2.0, 3.0, 5.0, 0.25]);
}

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
    let (library, options) = (Arc::new(NodeLibrary::standard()), Options::default());
    let mut shader = Shader::new(Arc::new(graph), library, &[], options).unwrap();
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

    let library = Arc::new(NodeLibrary::standard());
    let mut shader = Shader::new(Arc::new(graph), library, &[], Options::default()).unwrap();
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
        let library = Arc::new(NodeLibrary::standard());
        let shader = Shader::new(Arc::new(graph), library, &[], options).unwrap();
        assert_eq!(shader.has_root(kind), kind == RootKind::Material);
    }
}

#[test]
fn requirements_are_joined_in_the_graph() {
    let inner = r#"{ "phenomenon": "inner",
        "requires": { "shadow": "sort", "texture": 2, "derivative": [2], "parallel": true, "volume_level": 3, "apply": ["material"] },
        "roots": { "material": 1 } }"#;
    let outer = r#"{ "phenomenon": "outer",
        "requires": { "shadow": "on", "texture": 1, "bump": 1, "derivative": [1], "parallel": false },
        "nodes": { "n": { "type": { "file": "inner.json" } }, "m": { "type": "trace_reflection" },
                   "s": { "type": "add", "inputs": { "a": { "node": "n" }, "b": { "node": "m" } } } },
        "roots": { "material": { "node": "s" } } }"#;
    let graph = graph(&[("outer.json", outer), ("inner.json", inner)]);
    let requirements = &graph.requirements;
    assert_eq!(requirements.choices, [("shadow", "sort"), ("trace", "on")].into());
    assert_eq!((requirements.texture, requirements.bump, requirements.volume_level), (2, 1, 3));
    assert_eq!(requirements.derivative, [1, 2].into());
    assert_eq!(requirements.parallel, Some(false));
    assert!(requirements.applies_to(RootKind::Lens), "what the inner one is for is its own");
    let misused = outer.replace("\"material\"", "\"lens\"");
    let checked = check_files(&[("outer.json", &misused), ("inner.json", inner)]);
    let found: Vec<Code> = checked.findings.iter().map(|finding| finding.code).collect();
    assert_eq!(found, [Code::CONFLICTING_REQUIREMENTS]);
}

#[test]
fn what_is_ruled_out_is_known_in_the_graph_through_phenomena() {
    let inner = r#"{ "phenomenon": "inner",
        "interface": { "share": { "type": "scalar", "default": 0, "min": 0, "max": 0 } },
        "nodes": { "t": { "type": "trace_reflection" },
                   "m": { "type": "mix", "inputs": { "weight": { "interface": "share" }, "b": { "node": "t" } } } },
        "roots": { "material": { "node": "m" } } }"#;
    let outer = r#"{ "phenomenon": "outer",
        "nodes": { "one": { "type": { "file": "inner.json" } },
                   "t": { "type": "trace_transparent" },
                   "two": { "type": { "file": "inner.json" } },
                   "s": { "type": "select", "inputs": { "condition": true, "if_true": { "node": "one" }, "if_false": { "node": "t" } } },
                   "m": { "type": "add", "inputs": { "a": { "node": "s" }, "b": { "node": "two" } } } },
        "roots": { "material": { "node": "m" } } }"#;
    let checked = check_files(&[("outer.json", outer), ("inner.json", inner)]);
    let graph = checked.graph.unwrap();
    let library = NodeLibrary::standard();
    let named: Vec<(&str, &str)> = graph
        .ruled_out
        .iter()
        .map(|&(node, input)| {
            let node = &graph.nodes[node];
            (node.name.as_str(), library.signature(node.node_type).inputs[input].name)
        })
        .collect();
    assert_eq!(named, [("one/m", "b"), ("two/m", "b"), ("s", "if_false")]);
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
            library.signature(library.find("square_root").unwrap()).inputs[0].name
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

#[test]
fn what_is_given_twice_or_beside_a_struct_is_told() {
    let inner = r#"{ "phenomenon": "inner", "interface": {
            "s": { "type": "struct", "members": { "a": { "type": "scalar", "default": 1 }, "b": { "type": "scalar", "default": 1 } } },
            "mode": { "type": "integer", "default": "soft", "values": ["soft", "hard"] } },
        "nodes": { "x": { "type": "sum", "inputs": { "values": [{ "interface": "s.a" }, { "interface": "s.b" }, { "interface": "mode" }] } } },
        "roots": { "material": { "node": "x" } } }"#;
    let with = |inputs: &str| {
        let outer = format!(
            r#"{{ "phenomenon": "outer", "interface": {{
                 "o": {{ "type": "struct", "members": {{ "b": {{ "type": "scalar", "default": 8 }}, "a": {{ "type": "scalar", "default": 4 }} }} }},
                 "t": {{ "type": "struct", "members": {{ "b": {{ "type": "color", "default": 8 }}, "a": {{ "type": "scalar", "default": 4 }} }} }} }},
               "nodes": {{ "n": {{ "type": {{ "file": "inner.json" }}, "inputs": {{ {inputs} }} }},
                 "keep": {{ "type": "sum", "inputs": {{ "values": [{{ "interface": "o.a" }}, {{ "interface": "o.b" }}, {{ "interface": "t.a" }}, {{ "interface": "t.b" }}] }} }},
                 "m": {{ "type": "mix", "inputs": {{ "weight": 0.5, "a": {{ "node": "n" }}, "b": {{ "node": "keep" }} }} }} }},
               "roots": {{ "material": {{ "node": "m" }}, "shadow": {{ "node": "n" }} }} }}"#
        );
        let checked = check_files(&[("outer.json", &outer), ("inner.json", inner)]);
        let found: Vec<(Code, String)> =
            checked.findings.iter().map(|it| (it.code, it.message.clone())).collect();
        let shadow =
            checked.graph.map(|graph| shaded(&graph, RootKind::Shadow, &[], State::default()).0);
        (found, shadow)
    };
    let code =
        |inputs: &str| -> Vec<Code> { with(inputs).0.into_iter().map(|(code, _)| code).collect() };
    assert_eq!(code(r#""s": { "struct": { "a": 1 } }, "s.a": 7"#), [Code::DUPLICATE_KEY]);
    assert_eq!(code(r#""s": { "struct": { "a": 1 }, "unit": "mm" }"#), [Code::UNKNOWN_KEY]);
    assert_eq!(with(r#""s": { "struct": { "a": 1 } }, "s.b": 7"#).1.unwrap()[0], 8.0);
    assert_eq!(with(r#""s": { "interface": "o" }"#).1.unwrap()[0], 12.0, "by name, in any order");
    let (found, _) = with(r#""s": { "interface": "t" }"#);
    assert_eq!(found.len(), 1);
    assert!(found[0].1.ends_with("its part `b` must be a scalar, not a color"), "{}", found[0].1);
    assert_eq!(with(r#""mode": "hard""#).1.unwrap()[0], 3.0);
    assert_eq!(code(r#""mode": "hrad""#), [Code::UNKNOWN_CHOICE]);
}
