//! `phenomenon render`.

use phenomenon_runtime::film::{Film, read};
use serde_json::Value;

use crate::program::{Folder, printed, program, refused, run};

const GLASS: &str = "graphs/glass/advanced_glass.json";
const MIRROR: &str = "graphs/mirror/tinted_mirror.json";
const SMALL: [&str; 4] = ["--size", "24x16", "--spp", "2"];

/// Renders small; the bytes of the file.
fn rendered(folder: &Folder, name: &str, arguments: &[&str]) -> Vec<u8> {
    let path = folder.path(name);
    let flags = ["-o", &path, "--quiet"];
    assert_eq!(printed(&[&["render"], arguments, &SMALL, &flags].concat()), "");
    std::fs::read(path).unwrap()
}

fn film(folder: &Folder, arguments: &[&str]) -> Film {
    rendered(folder, "film.exr", arguments);
    read(folder.path("film.exr").as_ref()).unwrap()
}

#[test]
fn no_way_to_run_a_graph_changes_a_bit() {
    let folder = Folder::new();
    for file in [GLASS, MIRROR, "graphs/rainbow/rainbow.json"] {
        let walk = rendered(&folder, "walk.exr", &[file, "--engine", "walk", "--threads", "1"]);
        for flags in [
            "--engine batch --batch 1",
            "--engine batch --batch 7 --threads 2",
            "--engine batch --simd portable",
            "--engine jit --threads 2",
            "--engine jit --simd portable --batch 7",
            "--engine auto",
        ] {
            let flags: Vec<&str> = flags.split(' ').collect();
            let other = rendered(&folder, "other.exr", &[&[file], &flags[..]].concat());
            assert!(walk == other, "{file} {flags:?}");
        }
    }
}

#[test]
fn a_monolith_is_within_rounding() {
    let folder = Folder::new();
    rendered(&folder, "graph.exr", &[GLASS]);
    rendered(&folder, "monolith.exr", &[GLASS, "--engine", "monolith"]);
    let (graph, monolith) = (folder.path("graph.exr"), folder.path("monolith.exr"));
    printed(&["compare", &graph, &monolith, "--tolerance", "5e-3"]);
}

#[test]
fn the_seed_and_the_parameters_change_the_picture() {
    let folder = Folder::new();
    let plain = rendered(&folder, "a.exr", &[GLASS]);
    assert!(plain == rendered(&folder, "a.exr", &[GLASS, "--seed", "0"]), "the scene's seed is 0");
    assert!(plain != rendered(&folder, "a.exr", &[GLASS, "--seed", "1"]));
    assert!(plain != rendered(&folder, "a.exr", &[GLASS, "--set", "ior=1.2"]));
    assert!(plain == rendered(&folder, "a.exr", &[GLASS, "--set", "ior=1.5"]), "its default");
}

#[test]
fn one_node_is_shown_as_it_is() {
    let folder = Folder::new();
    let middle = |film: &Film| film.pixel(11, 8);
    let cosine = middle(&film(&folder, &[GLASS, "--node", "cosine"]));
    assert!(cosine[0] > 0.3 && cosine[0] == cosine[1] && cosine[1] == cosine[2], "{cosine:?}");
    let normal = middle(&film(&folder, &[GLASS, "--node", "here.normal"]));
    let length = normal[..3].iter().map(|x| x * x).sum::<f32>().sqrt();
    assert!((length - 1.0).abs() < 0.1, "{normal:?}");
    assert_eq!(middle(&film(&folder, &[GLASS, "--node", "media.enter"])), [1.0; 4]);
}

#[test]
fn a_graph_of_the_environment_is_seen_behind() {
    let folder = Folder::new();
    let sky = film(&folder, &["graphs/sky/gradient_sky.json"]);
    let plain = film(&folder, &["graphs/constant/constant_simple.json"]);
    assert_ne!(sky.pixel(0, 0), plain.pixel(0, 0));
}

#[test]
fn a_scene_brings_its_own_options() {
    let folder = Folder::new();
    let scene =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/default.json"));
    let graphs = concat!(env!("CARGO_MANIFEST_DIR"), "/../graphs/");
    let subject = format!(r#"{{ "file": "{graphs}constant/constant_simple.json" }}"#);
    let scene = scene
        .unwrap()
        .replace("../graphs/", graphs)
        .replace(r#"{ "subject": true }"#, &subject)
        .replace("[512, 512]", "[6, 4]")
        .replace(r#""samples": 16"#, r#""samples": 3"#);
    let scene = folder.file("scene.json", scene);
    let stats = folder.path("stats.json");
    let picture = folder.path("scene.exr");
    let line = run(&["render", &scene, "-o", &picture, "--stats", &stats, "--engine", "batch"]);
    assert_eq!(line.code, Some(0), "{line:?}");
    assert!(line.complaint.contains("6x4, 3 samples, engine batch"), "{line:?}");
    let stats: Value = serde_json::from_slice(&std::fs::read(stats).unwrap()).unwrap();
    assert_eq!(stats["rays"]["eye"], 72);
    assert_eq!(stats["points"]["walk"], 0);
    assert!(stats["points"]["batch"].as_u64() > Some(0), "{stats}");
    let evaluations = &stats["evaluations"];
    assert_eq!(evaluations["walk"], serde_json::json!({ "wanted": 0, "done": 0 }));
    let [wanted, done] = ["wanted", "done"].map(|of| evaluations["batch"][of].as_u64().unwrap());
    assert!(0 < wanted && wanted <= done, "{stats}");
    for part in ["check", "compile", "render"] {
        assert!(stats["milliseconds"][part].as_f64() >= Some(0.0), "{stats}");
    }
    refused(&["render", &scene, "--set", "color=1"], &["--set color=1", "OBJECT:PARAMETER"]);
    refused(&["render", "scenes/default.json", "-o", &picture], &["default.json", "looked at"]);
}

#[test]
fn points_that_find_out_how_bright_the_sky_is_are_counted() {
    let folder = Folder::new();
    let sky = r#"{ "phenomenon": "own_sky",
      "nodes": { "blue": { "type": "constant_color", "inputs": { "value": [0.5, 0.75, 1] } } },
      "roots": { "environment": { "node": "blue" } } }"#;
    folder.file("own_sky.json", sky);
    let stage = r#"{ "scene": "s", "camera": { "position": [0, 0, 10], "look_at": [0, 0, 0] },
      "objects": [{ "sphere": { "center": [0, 0, 0], "radius": 1.5 }, "material": { "subject": true } }],
      "lights": [{ "name": "sky", "environment": { "samples": 2 } }],
      "environment": { "file": "own_sky.json" }, "options": { "size": [8, 8], "samples": 2 } }"#;
    let stage = folder.file("stage.json", stage);
    let (stats, picture) = (folder.path("stats.json"), folder.path("a.png"));
    let points = |engine: &str| {
        let stage = ["graphs/floor/checker_floor.json", "--scene", &stage, "-o", &picture];
        printed(&[&["render"], &stage[..], &["--engine", engine, "--stats", &stats]].concat());
        let stats: Value = serde_json::from_slice(&std::fs::read(&stats).unwrap()).unwrap();
        let points = stats["points"].as_object().unwrap().iter();
        points.map(|(name, count)| (name.clone(), count.as_u64().unwrap())).collect::<Vec<_>>()
    };
    let of = |points: &[(String, u64)], engine| {
        points.iter().find(|(name, _)| name == engine).map(|(_, count)| *count)
    };
    let sum = |points: &[(String, u64)]| points.iter().map(|(_, count)| count).sum::<u64>();
    let [compiled, by_hand] = ["batch", "monolith"].map(points);
    // Every camera ray, every light sample that no shadow ray lost, and 512 by 256 directions.
    assert!((131_072 + 128..131_072 + 256).contains(&sum(&compiled)), "{compiled:?}");
    assert_eq!(sum(&by_hand), sum(&compiled), "{by_hand:?}");
    let on_the_ball = of(&by_hand, "monolith").unwrap();
    assert!((1..64).contains(&on_the_ball), "{by_hand:?}");
}

#[test]
fn the_picture_is_named_after_the_file() {
    let folder = Folder::new();
    let graph = concat!(env!("CARGO_MANIFEST_DIR"), "/../graphs/constant/constant_simple.json");
    let mut command = program(&[&["render", graph], &SMALL[..]].concat());
    let output = command.current_dir(folder.path("")).output().unwrap();
    assert!(output.status.success());
    assert!(std::fs::read(folder.path("constant_simple.png")).unwrap().starts_with(b"\x89PNG"));
    let line = String::from_utf8(output.stderr).unwrap();
    assert!(line.starts_with("constant_simple.png: 24x16, 2 samples, engine auto, "), "{line}");
    assert_eq!(line.lines().count(), 1, "no progress bar in a pipe: {line}");
}

#[test]
fn every_wrong_flag_is_named_with_a_remedy() {
    let render = |flags: &[&str], parts: &[&str]| {
        refused(&[&["render", GLASS], flags].concat(), parts);
    };
    for size in ["0x0", "0x5", "1e9x4", "65536x65536", "-1x4", "512", "NaNx4"] {
        render(&["--size", size], &["--size", size, "512x512"]);
    }
    render(&["--spp", "0"], &["--spp", "'0'", "from 1"]);
    render(&["--spp", "-3"], &["--spp", "-3", "from 1"]);
    render(&["--threads", "0"], &["--threads", "'0'", "from 1"]);
    render(&["--seed", "-1"], &["--seed", "-1"]);
    render(&["--exposure", "NaN"], &["--exposure", "NaN", "finite"]);
    render(&["--set", "iro=1"], &["--set iro=1", "did you mean `ior`?"]);
    render(&["--set", "ior=NaN"], &["--set ior=NaN", "not finite"]);
    render(&["--set", "ior=9"], &["--set ior=9", "1 to 4"]);
    render(&["--node", "cosin"], &["--node cosin", "did you mean `cosine`?"]);
    render(&["--node", "diffuse"], &["`diffuse`", "light loop"]);
    render(&["--node", "cosine", "--engine", "monolith"], &["--engine monolith", "batch"]);
    render(&["-o", "picture.gif"], &["-o", "picture.gif", ".exr"]);
    render(&["-o", "/nowhere/a.png"], &["-o /nowhere/a.png", "no folder"]);
    render(&["--stats", "/nowhere/a.json"], &["--stats /nowhere/a.json", "no folder"]);
}

#[test]
fn what_cannot_be_rendered_leaves_no_file() {
    let folder = Folder::new();
    let picture = folder.path("a.png");
    let render = |file: &str, parts: &[&str]| {
        refused(&["render", file, "-o", &picture], parts);
        assert!(!std::path::Path::new(&picture).exists(), "{file}");
    };
    render("/nowhere/graph.json", &["/nowhere/graph.json"]);
    render(&folder.file("cut.json", r#"{ "phenomenon": "#), &["cut.json:1:"]);
    render(&folder.file("empty_scene.json", r#"{ "scene": "a" }"#), &["camera", "objects"]);
    let unknown = r#"{ "phenomenon": "mine", "version": 1,
        "nodes": { "n": { "type": "constant_color" } }, "roots": { "material": { "node": "n" } } }"#;
    let unknown = folder.file("mine.json", unknown);
    refused(&["render", &unknown, "--engine", "monolith"], &["`mine`", "advanced_glass"]);
    let unlit = r#"{ "phenomenon": "mine", "version": 1,
        "nodes": { "n": { "type": "light_loop", "inputs": { "lights": [{ "light": "kye" }] } } },
        "roots": { "material": { "node": "n" } } }"#;
    render(&folder.file("unlit.json", unlit), &["`kye`", "did you mean `key`?"]);
    let mesh = folder.file("broken.obj", "v 0 0\nf 1 2 9\n");
    let scene = format!(
        r#"{{ "scene": "a", "camera": {{ "position": [0, 0, 5], "look_at": [0, 0, 0], "field_of_view": 40 }},
             "objects": [ {{ "mesh": "{mesh}", "material": {{ "file": "{unknown}" }} }} ] }}"#
    );
    render(&folder.file("scene.json", scene), &["scene.json", "broken.obj"]);
}

#[test]
fn a_chain_of_100000_nodes_is_no_reason_to_crash() {
    let folder = Folder::new();
    let links: Vec<String> = (1..100_000)
        .map(|at| {
            let before = at - 1;
            format!(r#""n{at}": {{ "type": "add", "inputs": {{ "a": {{ "node": "n{before}" }}, "b": 1 }} }}"#)
        })
        .collect();
    let chain = format!(
        r#"{{ "phenomenon": "chain", "version": 1, "nodes": {{ "n0": {{ "type": "constant_scalar" }}, {} }},
             "roots": {{ "material": {{ "node": "n99999" }} }} }}"#,
        links.join(",")
    );
    let chain = folder.file("chain.json", chain);
    for engine in ["walk", "batch"] {
        let value = printed(&["eval", &chain, "--engine", engine]);
        assert!(value.starts_with("n99999.result  99999 99999 99999 1\n"), "{value}");
    }
}
