//! `phenomenon eval`.

use serde_json::Value;

use crate::program::{Folder, printed, refused, run};

const GRAPH: &str = r#"{
  "phenomenon": "looked_at", "version": 1,
  "interface": {
    "tint": { "type": "color", "default": [0.9, 0.7, 0.4], "min": 0, "max": 1, "doc": "colour" },
    "ior": { "type": "scalar", "default": 1.5, "min": 1, "max": 4, "doc": "index" },
    "on": { "type": "boolean", "default": true, "doc": "whether" }
  },
  "nodes": {
    "state": { "type": "state" },
    "split": { "type": "split_color", "inputs": { "color": { "interface": "tint" } } },
    "up": { "type": "scale", "inputs": { "input": { "node": "state", "output": "normal" } } },
    "chosen": { "type": "select", "inputs": { "condition": { "interface": "on" },
                "if_true": { "interface": "tint" }, "if_false": { "interface": "ior" } } },
    "mirror": { "type": "trace_reflection" },
    "lit": { "type": "lambert" },
    "lights": { "type": "light_loop", "inputs": { "body": { "node": "lit" } } }
  },
  "roots": { "material": { "node": "chosen" }, "shadow": { "node": "mirror", "output": "color" } }
}"#;

fn graph(folder: &Folder) -> String {
    folder.file("looked_at.json", GRAPH)
}

fn values(arguments: &[&str]) -> Value {
    let json = printed(&[&["eval"], arguments, &["--format", "json"]].concat());
    serde_json::from_str(&json).unwrap()
}

#[test]
fn every_engine_prints_the_same_digits() {
    let folder = Folder::new();
    let graph = graph(&folder);
    for engine in ["auto", "walk", "batch", "jit"] {
        for (simd, batch) in [("native", "256"), ("portable", "1")] {
            let flags = ["--engine", engine, "--simd", simd, "--batch", batch];
            let json = printed(&[&["eval", &graph, "--format", "json"], &flags[..]].concat());
            let expected = "{\"values\":{\"chosen.result\":[0.9,0.7,0.4,1.0]},\"ok\":true}\n";
            assert_eq!(json, expected, "{flags:?}");
        }
    }
    assert_eq!(printed(&["eval", &graph]), "chosen.result  0.9 0.7 0.4 1\nok             true\n");
}

#[test]
fn parameters_and_state_are_set() {
    let folder = Folder::new();
    let graph = graph(&folder);
    let set = values(&[&graph, "--set", "on=false", "--set", "ior=2.25"]);
    assert_eq!(set["values"]["chosen.result"], serde_json::json!([2.25, 2.25, 2.25, 1.0]));
    let normal = values(&[&graph, "--node", "state.normal", "--state", "normal=0,0.6,0.8"]);
    assert_eq!(normal["values"]["state.normal"], serde_json::json!([0.0, 0.6, 0.8]));
}

#[test]
fn a_node_is_evaluated_with_all_its_outputs() {
    let folder = Folder::new();
    let graph = graph(&folder);
    let split = values(&[&graph, "--node", "split"]);
    let expected = serde_json::json!({ "split.r": [0.9], "split.g": [0.7], "split.b": [0.4], "split.a": [1.0] });
    assert_eq!(split["values"], expected);
    assert!(split.get("ok").is_none());
    let state = values(&[
        &graph,
        "--node",
        "state",
        "--state",
        "ray_type=shadow",
        "--state",
        "inv_normal=true",
    ]);
    assert_eq!(state["values"]["state.ray_type"], serde_json::json!([4]));
    assert_eq!(state["values"]["state.inv_normal"], serde_json::json!([true]));
    assert_eq!(state["values"]["state.dot_nd"], serde_json::json!([-1.0]));
}

#[test]
fn rays_hit_nothing_and_no_light_shines() {
    let folder = Folder::new();
    let graph = graph(&folder);
    let mirror = values(&[&graph, "--root", "shadow"]);
    assert_eq!(mirror["values"]["mirror.color"], serde_json::json!([0.0, 0.0, 0.0, 0.0]));
    let hit = values(&[&graph, "--node", "mirror.hit"]);
    assert_eq!(hit["values"]["mirror.hit"], serde_json::json!([false]));
    let lights = values(&[&graph, "--node", "lights"]);
    let colour = lights["values"].as_object().unwrap().values().next().unwrap();
    assert_eq!(
        colour.as_array().unwrap()[..3],
        serde_json::json!([0.0, 0.0, 0.0]).as_array().unwrap()[..]
    );
}

#[test]
fn wrong_values_are_refused_with_flag_value_and_remedy() {
    let folder = Folder::new();
    let graph = graph(&folder);
    let eval = |flag, value, parts: &[&str]| {
        let both = [&[flag, value], parts].concat();
        refused(&["eval", &graph, flag, value], &both);
    };
    eval("--set", "iro=1", &["did you mean `ior`?"]);
    eval("--set", "ior=NaN", &["not finite", "1 to 4"]);
    eval("--set", "ior=-1", &["outside", "1 to 4"]);
    eval("--set", "tint=1,2", &["0.9,0.7,0.4"]);
    eval("--set", "on=maybe", &["`true` or `false`"]);
    eval("--state", "normal=0,0,0", &["not all 0"]);
    eval("--state", "norml=0,0,1", &["did you mean `normal`?"]);
    eval("--state", "light_direction=0,0,1", &["light loop"]);
    eval("--state", "u=NaN", &["finite"]);
    eval("--node", "slpit", &["did you mean `split`?"]);
    eval("--node", "split.red", &["its outputs are `r`"]);
    eval("--node", "lit", &["`lit`", "light loop"]);
    eval("--engine", "monolith", &["walk, batch or jit"]);
    eval("--root", "environment", &["material, shadow"]);
    refused(&["eval", &graph, "--set", "ior=2", "--set", "ior=3"], &["--set ior=3", "twice"]);
}

#[test]
fn a_graph_with_mistakes_shows_them() {
    let folder = Folder::new();
    let cut = folder.file("cut.json", &GRAPH[..200]);
    refused(&["eval", &cut], &["cut.json"]);
    let misspelt = folder.file("misspelt.json", GRAPH.replace("split_color", "splt_color"));
    refused(&["eval", &misspelt], &["misspelt.json", "did you mean `split_color`?"]);
    refused(&["eval", "/nowhere/graph.json"], &["/nowhere/graph.json"]);
    refused(&["eval", &folder.path("")], &[]);
    assert_eq!(run(&["eval", &folder.file("empty.json", "")]).code, Some(2));
}

#[test]
fn presets_and_outputs_are_evaluated_by_name() {
    let folder = Folder::new();
    let graph = folder.file(
        "waves.json",
        r##"{ "phenomenon": "waves",
          "interface": { "tint": { "type": "color", "default": 1 }, "height": { "type": "scalar", "default": 2 } },
          "presets": { "low": { "height": 0.5, "tint": { "srgb": "#f00" } } },
          "outputs": { "tint": { "type": "color", "from": { "interface": "tint" } },
                       "up": { "type": "vector", "from": [0, 0, 1] },
                       "height": { "type": "scalar", "from": { "interface": "height" } } } }"##,
    );
    let height = values(&[&graph, "--node", "height"]);
    assert_eq!(height["values"], serde_json::json!({ "height": [2.0] }));
    let low = values(&[&graph, "--node", "height", "--preset", "low"]);
    assert_eq!(low["values"], serde_json::json!({ "height": [0.5] }));
    let set = values(&[&graph, "--node", "tint", "--preset", "low", "--set", "tint=0,1,0"]);
    assert_eq!(set["values"], serde_json::json!({ "tint": [0.0, 1.0, 0.0, 1.0] }));
    let json = values(&[&graph, "--node", "tint", "--set", r##"tint={ "srgb": "#00f" }"##]);
    assert_eq!(json["values"], serde_json::json!({ "tint": [0.0, 0.0, 1.0, 1.0] }));
    let up = values(&[&graph, "--node", "up"]);
    assert_eq!(up["values"], serde_json::json!({ "up": [0.0, 0.0, 1.0] }));
    let unknown = ["did you mean `low`?", "its presets are `low`", "`waves` has no preset `lwo`"];
    refused(&["eval", &graph, "--node", "up", "--preset", "lwo"], &unknown);
    refused(&["eval", &graph], &["`waves` has no such root", "it has outputs alone"]);
    refused(&["eval", &graph, "--node", "hieght"], &["did you mean `height`?"]);
    let scene = "scenes/default.json";
    refused(&["render", scene, "--preset", "low", "-o", "x.png"], &["OBJECT:PRESET"]);
    refused(
        &["render", "scenes/teapot.json", "--preset", "teapot:dark", "-o", "x.png"],
        &[
            "--preset teapot:dark: `advanced_glass` has no preset `dark`",
            "its presets are `moldavite`, `clear` and `smoke`",
        ],
    );
}
