//! What of a scene the command line changes, and what `check` finds of what `render` refuses.

use phenomenon_runtime::film::{Film, read};

use crate::program::{Folder, printed, refused, run};

/// Draws its colour; shows nothing but that.
const FLAT: &str = r#"{ "phenomenon": "flat", "interface": { "tint": { "type": "color", "default": [1, 0, 0] } },
  "nodes": { "t": { "type": "scale", "inputs": { "input": { "interface": "tint" } } }, "green": { "type": "constant_color", "inputs": { "value": [0, 1, 0] } } },
  "roots": { "material": { "node": "t" }, "environment": { "node": "t" } } }"#;

/// Two spheres side by side in front of a graph for the environment.
const SCENE: &str = r#"{ "scene": "s", "camera": { "position": [0, 0, 10], "look_at": [0, 0, 0] }, "objects": [
    { "name": "left", "sphere": { "center": [-2, 0, 0], "radius": 1.5 }, "material": { "file": "flat.json" } },
    { "name": "right.one", "sphere": { "center": [2, 0, 0], "radius": 1.5 }, "material": { "file": "flat.json" } },
    { "sphere": { "center": [0, 90, 0], "radius": 1 }, "material": { "file": "flat.json" } },
    { "sphere": { "center": [0, -90, 0], "radius": 1 }, "material": { "file": "flat.json" } } ],
  "environment": { "file": "flat.json", "set": { "tint": [0, 0, 1] } },
  "options": { "size": [32, 16], "samples": 2 } }"#;

fn film(folder: &Folder, file: &str, flags: &[&str]) -> Film {
    let picture = folder.path("film.exr");
    printed(&[&["render", file, "-o", &picture, "--quiet"], flags].concat());
    read(picture.as_ref()).unwrap()
}

/// The colours in the middle of the left sphere, of the right one, and of what is behind.
fn colors(film: &Film) -> [[f32; 3]; 3] {
    [(10, 8), (21, 8), (15, 1)].map(|(x, y)| {
        let [r, g, b, _] = film.pixel(x, y);
        [r, g, b]
    })
}

const RED: [f32; 3] = [1.0, 0.0, 0.0];
const GREEN: [f32; 3] = [0.0, 1.0, 0.0];
const BLUE: [f32; 3] = [0.0, 0.0, 1.0];
const GREY: [f32; 3] = [0.5, 0.5, 0.5];

#[test]
fn parameters_and_nodes_of_one_object_change() {
    let folder = Folder::new();
    folder.file("flat.json", FLAT);
    let scene = folder.file("s.json", SCENE);
    let seen = |flags: &[&str]| colors(&film(&folder, &scene, flags));
    assert_eq!(seen(&[]), [RED, RED, BLUE]);
    assert_eq!(seen(&["--set", "left:tint=0.5"]), [GREY, RED, BLUE]);
    assert_eq!(seen(&["--set", "right.one:tint=[0.5,0.5,0.5]"]), [RED, GREY, BLUE]);
    assert_eq!(seen(&["--set", "objects[0]:tint=0,1,0"]), [GREEN, RED, BLUE]);
    let environment = ["--set", "environment:tint=0.5", "--node", "left:green"];
    assert_eq!(seen(&environment), [GREEN, RED, GREY]);
    assert_eq!(seen(&["--node", "environment:green"]), [RED, RED, GREEN]);
    assert_eq!(seen(&["--node", "right.one:green.value"]), [RED, GREEN, BLUE]);
    let render = |flags: &[&str], parts: &[&str]| {
        refused(&[&["render", &scene], flags].concat(), parts);
    };
    render(&["--set", "tint=1"], &["--set tint=1", "OBJECT:PARAMETER", "`left`", "`environment`"]);
    render(&["--set", "lfet:tint=1"], &["--set lfet:tint=1", "did you mean `left`?"]);
    render(&["--set", "left:tnit=1"], &["--set left:tnit=1", "did you mean `tint`?"]);
    render(&["--set", "left:tint=1,2"], &["--set left:tint=1,2", "three"]);
    render(&["--set", "sphere:tint=1"], &["2 objects", "`objects[2]` and `objects[3]`"]);
    render(&["--set", "objects[9]:tint=1"], &["4 objects"]);
    render(&["--set", "left:tint=1", "--set", "left:tint=0"], &["set twice"]);
    render(&["--node", "green"], &["--node green", "OBJECT:NODE", "`left`"]);
    render(&["--node", "left:gren"], &["`gren`", "did you mean `green`?"]);
    render(&["--node", "middle:green"], &["no object `middle`", "`left`"]);
    render(&["--node", "left:green", "--engine", "monolith"], &["monolith"]);
}

#[test]
fn a_graph_is_shown_in_another_scene() {
    let folder = Folder::new();
    let graph = folder.file("flat.json", FLAT.replace(r#", "environment": { "node": "t" }"#, ""));
    let sky = folder.file("sky.json", FLAT);
    folder.file("flat_sky.json", FLAT);
    let stage = SCENE.replacen(r#"{ "file": "flat.json" }"#, r#"{ "subject": true }"#, 1);
    let stage = stage.replace(
        r#""environment": { "file": "flat.json""#,
        r#""environment": { "file": "flat_sky.json""#,
    );
    let stage = folder.file("stage.json", stage);
    let scene = folder.file("s.json", SCENE);
    let seen = |graph: &str, flags: &[&str]| {
        colors(&film(&folder, graph, &[&["--scene", &stage], flags].concat()))
    };
    assert_eq!(seen(&graph, &[]), [RED, RED, BLUE]);
    assert_eq!(seen(&graph, &["--set", "tint=0.5"]), [GREY, RED, BLUE]);
    assert_eq!(seen(&graph, &["--node", "green"]), [GREEN, RED, BLUE]);
    assert_eq!(seen(&sky, &["--set", "tint=0.5"]), [GREY, RED, GREY], "its environment, too");
    refused(&["render", &graph, "--scene", &scene], &["--scene", "s.json", "\"subject\": true"]);
    refused(&["render", &scene, "--scene", &stage], &["--scene", "s.json is a scene itself"]);
    refused(&["render", &graph, "--scene", &graph], &["--scene", "no scene"]);
    refused(&["render", &graph, "--scene", "/nowhere.json"], &["/nowhere.json"]);
    refused(&["render", &stage], &["no graph is looked at", "--scene"]);
}

#[test]
fn a_region_has_the_pixels_of_the_whole() {
    let folder = Folder::new();
    let teapot = "graphs/glass/advanced_glass.json";
    let size = ["--size", "37x23", "--spp", "3"];
    let whole = film(&folder, teapot, &size);
    for (x, y, width, height) in [(0, 0, 37, 23), (5, 3, 17, 19), (36, 22, 1, 1), (0, 7, 37, 1)] {
        let region = format!("{x},{y},{width},{height}");
        for threads in ["1", "2"] {
            let flags = ["--region", &region, "--threads", threads];
            let part = film(&folder, teapot, &[&size[..], &flags].concat());
            assert_eq!((part.width(), part.height()), (width, height));
            for row in 0..height {
                for column in 0..width {
                    let bits = |pixel: [f32; 4]| pixel.map(f32::to_bits);
                    let (own, of) = (part.pixel(column, row), whole.pixel(x + column, y + row));
                    assert_eq!(bits(own), bits(of), "{region}: {column}, {row}");
                }
            }
        }
    }
    for region in ["0,0,38,1", "0,0,1,24", "37,0,1,1", "36,22,2,1", "4294967295,0,1,1"] {
        let flags = ["--region", region];
        refused(&[&["render", teapot], &size[..], &flags].concat(), &["--region"]);
    }
    refused(&["render", teapot, "--region", "1,2,3"], &["--region", "X,Y,WIDTH,HEIGHT"]);
}

#[test]
fn a_monolith_belongs_to_what_a_graph_computes() {
    let folder = Folder::new();
    let small = ["--engine", "monolith", "--size", "8x8", "--spp", "1"];
    let shipped = |name: &str| {
        let path = format!("{}/../graphs/{name}", env!("CARGO_MANIFEST_DIR"));
        std::fs::read_to_string(path).unwrap()
    };
    let red = r#"{ "phenomenon": "rainbow", "roots": { "material": [1, 0, 0] } }"#;
    let red = folder.file("rainbow.json", red);
    refused(&[&["render", &red], &small[..]].concat(), &["`rainbow`", "lacks the parameter"]);
    let text = shipped("mirror/tinted_mirror.json");
    let same = film(&folder, "graphs/mirror/tinted_mirror.json", &small);
    let moved = folder.file("moved.json", text.replace("tinted_mirror\"", "mine\""));
    assert_eq!(film(&folder, &moved, &small), same);
    // Its own default, and not that of the monolith.
    let mut other: serde_json::Value = serde_json::from_str(&text).unwrap();
    other["interface"]["ior"]["default"] = 3.5.into();
    let other = folder.file("other.json", other.to_string());
    let set = ["graphs/mirror/tinted_mirror.json", "--set", "ior=3.5"];
    let set = film(&folder, set[0], &[&small[..], &set[1..]].concat());
    assert_eq!(film(&folder, &other, &small), set);
    assert_ne!(set, same);
}

#[test]
fn what_is_not_seen_is_said() {
    let folder = Folder::new();
    let small = ["--size", "4x4", "--spp", "1", "-o", &folder.path("a.exr")];
    let told = |file: &str| {
        let run = run(&[&["render", file], &small[..]].concat());
        assert_eq!(run.code, Some(0), "{run:?}");
        run.complaint
    };
    for roots in [r#""volume": [1, 0, 0]"#, r#""shadow": 1"#, r#""displacement": 1, "photon": 1"#] {
        let text = format!(r#"{{ "phenomenon": "m", "roots": {{ {roots} }} }}"#);
        let told = told(&folder.file("m.json", text));
        assert!(told.contains("nothing is seen of `m`"), "{told}");
    }
    let told_volume =
        told(&folder.file("m.json", r#"{ "phenomenon": "m", "roots": { "volume": 1 } }"#));
    assert!(told_volume.contains("does not call shaders of type `volume`"), "{told_volume}");
    folder.file("flat.json", r#"{ "phenomenon": "m", "roots": { "shadow": 1 } }"#);
    let scene =
        told(&folder.file("s.json", SCENE.replace(r#", "set": { "tint": [0, 0, 1] }"#, "")));
    assert!(scene.contains("has no `material` root, so the object is black"), "{scene}");
    assert!(scene.contains("has no `environment` root, so the environment is black"), "{scene}");
}

#[test]
fn check_finds_what_render_refuses() {
    let folder = Folder::new();
    folder.file("flat.json", FLAT);
    let both = |file: &str, code: &str, part: &str| {
        let check = run(&["check", file, "--format", "json"]);
        assert_eq!(check.code, Some(1), "{file}: {check:?}");
        assert!(check.output.contains(code), "{file} lacks {code}: {check:?}");
        let picture = folder.path("a.exr");
        refused(&["render", file, "-o", &picture, "--size", "1x1", "--spp", "1"], &[code, part]);
        check.output
    };
    let scene = |object: &str| {
        let scene = format!(
            r#"{{ "scene": "s", "camera": {{ "position": [0, 0, 10], "look_at": [0, 0, 0] }},
                 "objects": [{{ {object}, "material": {{ "file": "flat.json" }} }}] }}"#
        );
        folder.file("scene.json", scene)
    };
    for object in [
        r#""sphere": { "radius": 1e12 }, "transform": { "scale": 1.5 }"#,
        r#""sphere": { "radius": 1, "center": [1e12, 0, 0] }, "transform": { "translate": [1e6, 0, 0] }"#,
        r#""sphere": { "radius": 1e-12 }, "transform": { "scale": 1e-40 }"#,
        r#""rectangle": { "width": 1, "depth": 1e12 }, "transform": { "scale": 3 }"#,
        r#""rectangle": { "width": 1, "depth": 1 }, "transform": { "matrix": [1e12, 0, 0, 1e12, 0, 1, 0, 0, 0, 0, 1, 0] }"#,
    ] {
        both(&scene(object), "unusable-object", "scene.json:");
    }
    // Pictures: no picture, one that is cut, and one with a pixel that is no number.
    let mut film = Film::new(9, 9).unwrap();
    let path = |name: &str| folder.path(name);
    phenomenon_runtime::film::write(&film, path("whole.png").as_ref(), 1.0).unwrap();
    let bytes = std::fs::read(path("whole.png")).unwrap();
    std::fs::write(path("cut.png"), &bytes[..bytes.len() / 2]).unwrap();
    std::fs::write(path("text.png"), "no picture").unwrap();
    film.set(3, 4, [f32::NAN, 0.0, 0.0, 1.0]);
    phenomenon_runtime::film::write(&film, path("nan.exr").as_ref(), 1.0).unwrap();
    std::fs::create_dir(path("folder.png")).unwrap();
    let graph = |picture: &str| {
        format!(
            r#"{{ "phenomenon": "p", "interface": {{ "pic": {{ "type": "texture", "default": {picture} }} }},
                 "nodes": {{ "t": {{ "type": "texture_lookup", "inputs": {{ "texture": {{ "interface": "pic" }} }} }} }},
                 "roots": {{ "material": {{ "node": "t", "output": "color" }} }} }}"#
        )
    };
    for (picture, code) in [
        ("cut.png", "unusable-file"),
        ("text.png", "unusable-file"),
        ("nan.exr", "unusable-file"),
        ("folder.png", "unreadable-file"),
        ("absent.png", "unreadable-file"),
        ("", "unreadable-file"),
    ] {
        let literal = format!(r#"{{ "texture": "{picture}" }}"#);
        both(&folder.file("p.json", graph(&literal)), code, "p.json:");
        folder.file("p.json", graph("null"));
        let set = format!(
            r#"{{ "scene": "s", "camera": {{ "position": [0, 0, 10], "look_at": [0, 0, 0] }},
                 "objects": [{{ "sphere": {{ "radius": 1 }}, "material": {{ "file": "p.json", "set": {{ "pic": {literal} }} }} }}] }}"#
        );
        both(&folder.file("set.json", set), code, "set.json:");
    }
    for file in ["", "absent.json", "folder.png"] {
        let text = format!(
            r#"{{ "phenomenon": "a", "nodes": {{ "g": {{ "type": {{ "file": "{file}" }} }} }}, "roots": {{ "material": {{ "node": "g" }} }} }}"#
        );
        both(&folder.file("nest.json", text), "unreadable-file", "nest.json:");
    }
    // Scopes that double what they hold, and loops in loops.
    let mut nodes = String::from(r#""s0": { "type": "state" }"#);
    for level in 1..=21 {
        let inner = match level {
            1 => r#"{ "node": "s0", "output": "dot_nd" }"#.to_owned(),
            _ => format!(r#"{{ "node": "s{}" }}"#, level - 1),
        };
        nodes += &format!(
            r#", "b{level}": {{ "type": "perturb_normal", "inputs": {{ "normal": [0.6, 0, 0.8], "input": {inner} }} }},
               "s{level}": {{ "type": "add", "inputs": {{ "a": {inner}, "b": {{ "node": "b{level}" }} }} }}"#
        );
    }
    let text = format!(
        r#"{{ "phenomenon": "d", "nodes": {{ {nodes} }}, "roots": {{ "material": {{ "node": "s21" }} }} }}"#
    );
    let found = both(&folder.file("doubling.json", text), "too-many-evaluations", "doubling.json:");
    assert!(found.contains("\"path\": \"nodes."), "{found}");
}

#[test]
fn a_check_of_nothing_is_no_check() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("empty")).unwrap();
    std::fs::create_dir(folder.path("foreign")).unwrap();
    folder.file("foreign/package.json", r#"{ "name": "p", "version": "1.0.0" }"#);
    folder.file("foreign/tsconfig.json", "{ // comments\n \"a\": 1 }");
    let (empty, foreign) = (folder.path("empty"), folder.path("foreign"));
    refused(&["check", &empty], &["nothing to check", "empty"]);
    refused(&["check", &foreign], &["nothing to check", "2 JSON files"]);
    let graph = r#"{ "phenomenon": "a", "roots": { "material": 1 } }"#;
    let graph = folder.file("graph.json", graph);
    let both = run(&["check", &foreign, &graph]);
    assert_eq!(both.code, Some(0), "{both:?}");
    assert!(both.complaint.contains("2 JSON files") && both.output.is_empty(), "{both:?}");
    assert_eq!(run(&["check", &folder.path("foreign/package.json")]).code, Some(1));
}

#[test]
fn what_is_no_error_can_be_silenced() {
    let folder = Folder::new();
    let graph = FLAT.replace("\"nodes\": {", r#""nodes": { "idle": { "type": "mix" },"#);
    let graph = folder.file("g.json", graph);
    let picture = folder.path("a.png");
    for command in [
        vec!["eval", &graph],
        vec!["render", &graph, "--size", "1x1", "--spp", "1", "-o", &picture, "--quiet"],
    ] {
        let told = run(&command).complaint;
        assert!(told.contains("unreachable-node"), "{told}");
        let allowed = run(&[&command[..], &["--allow", "unreachable-node"]].concat());
        assert_eq!((allowed.code, allowed.complaint.as_str()), (Some(0), ""), "{command:?}");
        refused(&[&command[..], &["--allow", "cycle"]].concat(), &["errors cannot be allowed"]);
    }
    refused(&["check", &graph, "--allow", "cycle"], &["--allow", "cycle", "unreachable-node"]);
}

#[test]
fn what_32_bits_leave_nothing_of_is_found() {
    let folder = Folder::new();
    folder.file("white.json", r#"{ "phenomenon": "white", "roots": { "material": [1, 1, 1] } }"#);
    let scene = |object: &str, light: &str| {
        format!(
            r#"{{ "scene": "s", "camera": {{ "position": [0, 3, 3], "look_at": [0, 0, 0] }},
              "objects": [{{ {object}, "material": {{ "file": "white.json" }} }}],
              "lights": [{{ "name": "sun", "directional": {{ "direction": {light} }} }}] }}"#
        )
    };
    let near = r#""rectangle": { "width": 1, "depth": 1 }"#;
    let far = format!(r#"{near}, "transform": {{ "translate": [1e12, 0, 0] }}"#);
    let good = folder.file("good.json", scene(near, "[0, -1e-30, 0]"));
    assert_eq!(run(&["check", &good]).code, Some(0));
    for (name, text, said) in [
        ("far.json", scene(&far, "[0, -1, 0]"), "no area left in 32 bits"),
        ("dark.json", scene(near, "[0, -1e-60, 0]"), "a direction that is not zero"),
    ] {
        let path = folder.file(name, text);
        let found = run(&["check", &path]);
        assert_eq!(found.code, Some(1), "{name}: {found:?}");
        let words: Vec<&str> = found.output.split(['\n', '│']).map(str::trim).collect();
        assert!(words.join(" ").contains(said), "{name}: {}", found.output);
        assert_eq!(run(&["render", &path, "-o", &folder.path("p.png")]).code, Some(2), "{name}");
    }
}
