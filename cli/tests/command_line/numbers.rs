//! The same text is the same value wherever it is given.

use phenomenon_runtime::film::read;
use serde_json::Value;

use crate::program::{Folder, printed, refused, run};

const GRAPH: &str = r#"{ "phenomenon": "g",
  "interface": { "x": { "type": "scalar", "default": 0 }, "n": { "type": "integer", "default": 0 },
    "on": { "type": "boolean", "default": false }, "fin": { "type": "string", "default": "x" },
    "lamps": { "type": "lights" },
    "mode": { "type": "integer", "values": ["smooth", "rough"], "default": 0 },
    "layers": { "type": "array",
      "of": { "type": "struct", "members": { "k": { "type": "scalar", "default": 1 }, "c": { "type": "color", "default": [1, 1, 1] } } },
      "default": [{ "struct": {} }, { "struct": { "k": 2 } }, { "struct": { "k": 3 } }] } },
  "nodes": { "v": { "type": "scale", "inputs": { "input": { "interface": "x" } } },
    "here": { "type": "state" },
    "n": { "type": "add", "inputs": { "a": { "interface": "n" }, "b": { "interface": "mode" } } },
    "e": { "type": "string_equal", "inputs": { "a": { "interface": "fin" }, "b": " a " } },
    "k": { "type": "sum", "inputs": { "values": [{ "interface": "layers[0].k" }, { "interface": "layers[1].k" }, { "interface": "layers[2].k" }] } } },
  "roots": { "environment": { "node": "v" } } }"#;

/// Near ties of singles, at both ends of their range, long, and with every part a number may have.
const NUMBERS: [&str; 16] = [
    "1.00000005960464477540",
    "1.000000059604644775390625",
    "1.00000005960464477539062500000000000000000000000000000000001",
    "1.00000017881393432617187499999999999999999999999999",
    "3.4028235677973366e38",
    "1e-46",
    "7.0064923216240853546186479164495806564013097093825788587855e-46",
    "7.0064923216240853546186479164495806564013097093825788587853e-46",
    "1.1754943157898258998483097e-38",
    "16777217.0000000000000000000000000000000001",
    "0.1",
    "0",
    "123456789.123456789e-5",
    "1E+2",
    "2.0",
    "340282356779733661637539395458142568447.9999",
];

fn value(arguments: &[&str], name: &str) -> f32 {
    let json = printed(&[&["eval"], arguments, &["--format", "json"]].concat());
    let values: Value = serde_json::from_str(&json).unwrap();
    values["values"][name][0].as_f64().unwrap() as f32
}

/// What the environment of a scene of nothing else looks like.
fn seen(folder: &Folder, environment: &str, flags: &[&str]) -> f32 {
    let scene = format!(
        r#"{{ "scene": "s", "camera": {{ "position": [0, 0, 5], "look_at": [0, 0, 0] }}, "objects": [],
             "environment": {environment}, "options": {{ "size": [1, 1], "samples": 1 }} }}"#
    );
    let scene = folder.file("seen.json", scene);
    let picture = folder.path("seen.exr");
    printed(&[&["render", &scene, "-o", &picture, "--quiet"], flags].concat());
    read(picture.as_ref()).unwrap().pixel(0, 0)[0]
}

#[test]
fn a_number_is_rounded_once_wherever_it_is_given() {
    let folder = Folder::new();
    let graph = folder.file("g.json", GRAPH);
    for text in NUMBERS {
        let wanted: f32 = text.parse().unwrap();
        let given = format!("x={text}");
        assert_eq!(value(&[&graph, "--set", &given, "--node", "v"], "v.result"), wanted, "{text}");
        let file = GRAPH.replacen("\"default\": 0 }", &format!("\"default\": {text} }}"), 1);
        let file = folder.file("default.json", file);
        assert_eq!(value(&[&file, "--node", "v"], "v.result"), wanted, "default {text}");
        let literal = GRAPH.replace(r#"{ "interface": "x" }"#, text);
        let literal = folder.file("literal.json", literal);
        assert_eq!(value(&[&literal, "--node", "v"], "v.result"), wanted, "literal {text}");
        let state = format!("u={text}");
        let flags = [graph.as_str(), "--state", &state, "--node", "here.u"];
        assert_eq!(value(&flags, "here.u"), wanted, "state {text}");
        let set = format!(r#"{{ "file": "g.json", "set": {{ "x": {text} }} }}"#);
        assert_eq!(seen(&folder, &set, &[]), wanted, "scene {text}");
        let flag = format!("environment:x={text}");
        let environment = r#"{ "file": "g.json", "set": { "x": 7 } }"#;
        assert_eq!(seen(&folder, environment, &["--set", &flag]), wanted, "scene --set {text}");
        if wanted <= 1e12 {
            let color = format!(r#"{{ "color": [{text}, 0, 0] }}"#);
            assert_eq!(seen(&folder, &color, &[]), wanted, "colour {text}");
        }
    }
    let negative = value(&[&graph, "--set", "x=-0", "--node", "v"], "v.result");
    assert_eq!(negative.to_bits(), (-0.0_f32).to_bits());
}

#[test]
fn what_is_no_number_in_a_file_is_none_in_a_flag() {
    let folder = Folder::new();
    let graph = folder.file("g.json", GRAPH);
    for text in [".5", "+1", "1.", "01", "0x10", "1e", "1_000", "NaN", "inf", "-Infinity", "1e39"] {
        let (x, u) = (format!("x={text}"), format!("u={text}"));
        refused(&["eval", &graph, "--set", &x], &["--set x="]);
        refused(&["eval", &graph, "--state", &u], &["--state u="]);
        refused(&["render", &graph, "--exposure", text], &["--exposure"]);
        refused(&["render", &graph, "--seed", text], &["--seed"]);
        refused(&["render", &graph, "--spp", text], &["--spp"]);
        if text != "1e39" {
            refused(&["compare", "a.png", "b.png", "--tolerance", text], &["--tolerance"]);
        }
        let file = folder.file("literal.json", GRAPH.replace(r#"{ "interface": "x" }"#, text));
        assert_ne!(run(&["check", &file]).code, Some(0), "{text}");
    }
    refused(&["eval", &graph, "--set", "x=.5"], &["write 0.5"]);
}

#[test]
fn whole_numbers_are_whole_however_they_are_written() {
    let folder = Folder::new();
    let graph = folder.file("g.json", GRAPH);
    for text in ["2", "2.0", "2e0", "20e-1", "0.2E+1"] {
        let given = format!("n={text}");
        let at = [graph.as_str(), "--node", "n"];
        assert_eq!(value(&[&at, &["--set", &given][..]].concat(), "n.result"), 2.0, "{text}");
        let level = format!("reflection_level={text}");
        let flags = [graph.as_str(), "--node", "here.reflection_level", "--state", &level];
        assert_eq!(value(&flags, "here.reflection_level"), 2.0, "{text}");
    }
    for text in ["2.5", "2147483648", "-2147483649", "2147483647.00000000000000000001", "true"] {
        refused(&["eval", &graph, "--set", &format!("n={text}")], &["--set n="]);
    }
    refused(&["eval", &graph, "--set", "on=1"], &["`true` or `false`"]);
    refused(&["eval", &graph, "--state", "inv_normal=1"], &["true or false"]);
}

#[test]
fn seeds_keep_all_their_bits() {
    let folder = Folder::new();
    let scene = |seed: &str| {
        format!(
            r#"{{ "scene": "s", "camera": {{ "position": [0, 0, 5], "look_at": [0, 0, 0] }},
                 "objects": [], "environment": {{ "gradient": {{ "zenith": [0, 0, 1], "horizon": [1, 0, 0], "ground": [0, 1, 0] }} }},
                 "options": {{ "size": [4, 4], "samples": 3, "seed": {seed} }} }}"#
        )
    };
    let picture = |seed: &str, flags: &[&str]| {
        let (scene, picture) = (folder.file("s.json", scene(seed)), folder.path("s.exr"));
        printed(&[&["render", &scene, "-o", &picture, "--quiet"], flags].concat());
        std::fs::read(picture).unwrap()
    };
    for seed in ["18446744073709551615", "9007199254740993", "1.8446744073709551614e19"] {
        assert!(picture(seed, &[]) == picture("0", &["--seed", seed]), "{seed}");
    }
    let last = picture("18446744073709551615", &[]);
    assert!(last != picture("18446744073709551614", &[]), "the last bit counts");
    assert!(last == picture("18446744073709551615.0", &[]));
    for seed in ["18446744073709551616", "-1", "0.5"] {
        refused(&["render", &folder.file("s.json", scene(seed))], &["seed"]);
    }
}

#[test]
fn a_scene_sets_what_a_graph_file_could_say() {
    let folder = Folder::new();
    folder.file("g.json", GRAPH);
    let check = |set: &str| {
        let scene = format!(
            r#"{{ "scene": "s", "camera": {{ "position": [0, 0, 5], "look_at": [0, 0, 0] }}, "objects": [],
                 "lights": [{{ "name": "key", "point": {{ "position": [0, 1, 0] }} }}],
                 "environment": {{ "file": "g.json", "set": {{ {set} }} }} }}"#
        );
        let scene = folder.file("s.json", scene);
        let run = run(&["check", &scene, "--format", "json"]);
        let report: Value = serde_json::from_str(&run.output).unwrap();
        let first = &report["findings"][0];
        let found = first["code"].as_str().unwrap_or_default().to_owned();
        let at = first["path"].as_str().unwrap_or_default().to_owned();
        (run.code, found, at)
    };
    for right in [
        r#""on": true"#,
        r#""x": 1.5, "n": 1e0, "fin": " a ""#,
        r#""mode": "rough""#,
        r#""mode": 1"#,
        r#""lamps": [{ "light": "key" }]"#,
        r#""layers": [{ "struct": { "k": 1, "c": 0.5 } }, { "struct": {} }, { "struct": { "c": [1, 0, 0] } }]"#,
        r#""layers[1]": { "struct": { "k": 4 } }, "layers[2].k": 5"#,
    ] {
        assert_eq!(check(right).0, Some(0), "{right}: {:?}", check(right));
    }
    let base = "environment.set";
    for (wrong, code, at) in [
        (r#""on": 1"#, "type-mismatch", "on"),
        (r#""on": "true""#, "type-mismatch", "on"),
        (r#""x": "1.5""#, "type-mismatch", "x"),
        (r#""x": null"#, "type-mismatch", "x"),
        (r#""x": true"#, "type-mismatch", "x"),
        (r#""x": [1]"#, "type-mismatch", "x"),
        (r#""n": 1.5"#, "wrong-kind", "n"),
        (r#""n": "1""#, "type-mismatch", "n"),
        (r#""fin": 1"#, "type-mismatch", "fin"),
        (r#""fin": { "light": "key" }"#, "type-mismatch", "fin"),
        (r#""fin": ["a"]"#, "type-mismatch", "fin"),
        (r#""lamps": "key""#, "type-mismatch", "lamps"),
        (r#""lamps": { "light": "key" }"#, "type-mismatch", "lamps"),
        (r#""mode": "ruogh""#, "unknown-choice", "mode"),
        (r#""mode": 2"#, "number-out-of-range", "mode"),
        (r#""layers": []"#, "wrong-length", "layers"),
        (r#""layers": { "struct": {} }"#, "type-mismatch", "layers"),
        (r#""layers[1]": { "struct": { "q": 4 } }"#, "unknown-member", r#"["layers[1]"].struct.q"#),
        (r#""layers[3].k": 1"#, "unknown-parameter", r#"["layers[3].k"]"#),
        (
            r#""layers[1]": { "struct": { "k": 4 } }, "layers[1].k": 5"#,
            "duplicate-key",
            r#"["layers[1].k"]"#,
        ),
        (r#""x": 1e39"#, "not-finite", "x"),
    ] {
        let stop = if at.starts_with('[') { "" } else { "." };
        assert_eq!(check(wrong), (Some(1), code.into(), format!("{base}{stop}{at}")), "{wrong}");
    }
}

#[test]
fn strings_are_taken_as_they_stand_and_wholes_as_json() {
    let folder = Folder::new();
    let graph = folder.file("g.json", GRAPH);
    let equal = |text: &str| printed(&["eval", &graph, "--node", "e", "--set", text]);
    assert!(equal("fin= a ").contains("true"), "{}", equal("fin= a "));
    assert!(equal("fin=a").contains("false"));
    assert!(equal("fin=").contains("false"), "a string may be empty");
    let sum = |sets: &[&str]| {
        let flags: Vec<&str> = sets.iter().flat_map(|set| ["--set", *set]).collect();
        value(&[&[graph.as_str(), "--node", "k"], &flags[..]].concat(), "k.result")
    };
    assert_eq!(sum(&[]), 6.0);
    assert_eq!(sum(&["layers[1].k=10"]), 14.0);
    assert_eq!(sum(&[r#"layers=[{"struct":{"k":4}},{"struct":{}},{"struct":{"k":1}}]"#]), 7.0);
    assert_eq!(sum(&[r#"layers[0]={"struct":{"k":4}}"#, "layers[2].k=0"]), 6.0);
    for (set, part) in [
        ("layers[5].k=1", "`layers` has 3 values, 0 to 2"),
        ("layers[0].q=1", "`layers[0]` are `k` and `c`"),
        ("layers=1", "`layers` is an array of 3"),
        ("layers=[1,2]", "3 values, but 2 are given"),
        ("layers[0]={\"struct\":{\"k\":\"1\"}}", "takes a scalar, not the string"),
        ("x[0]=1", "`x` is one value"),
        ("x=[1", "add the missing `]`"),
        ("mode=ruogh", "`smooth` and `rough`"),
    ] {
        refused(&["eval", &graph, "--set", set], &["--set", part]);
    }
    refused(
        &["eval", &graph, "--set", "layers[1].k=1", "--set", r#"layers[1]={"struct":{"k":2}}"#],
        &["`layers[1].k` is set twice"],
    );
}

#[test]
fn a_field_of_the_state_says_how_many_numbers_it_needs() {
    let folder = Folder::new();
    let graph = folder.file("g.json", GRAPH);
    for (state, part) in [
        ("normal=0,0", "three numbers are needed, and 2 are given"),
        ("origin=1", "three numbers are needed, and 1 is given"),
        ("direction=0,0,1,0", "three numbers are needed, and 4 are given"),
        ("u=1,2", "one number is needed, and 2 are given"),
        ("incoming=1,2", "one, three or four numbers are needed, and 2 are given"),
        ("ray_type=1.5", "a whole number is needed"),
    ] {
        refused(&["eval", &graph, "--state", state], &["--state", part]);
    }
}

/// Every flag that takes numbers: the command it belongs to, and what its remedy says.
const FLAGS: [(&[&str], &str, &str); 15] = [
    (&["render", "g.json"], "--spp", "from 1 to 1048576"),
    (&["render", "g.json"], "--threads", "from 1 to 1024"),
    (&["render", "g.json"], "--batch", "from 1 to 65536"),
    (&["render", "g.json"], "--seed", "from 0 to 18446744073709551615"),
    (&["render", "g.json"], "--exposure", "above 0"),
    (&["render", "g.json"], "--size", "each 1 to 65536"),
    (&["render", "g.json"], "--region", "X,Y,WIDTH,HEIGHT"),
    (&["eval", "g.json"], "--batch", "from 1 to 65536"),
    (&["compare", "a.png", "b.png"], "--tolerance", "0 or more"),
    (&["bench", "render", "g.json"], "--runs", "from 1 to 100"),
    (&["bench", "render", "g.json"], "--spp", "from 1 to 1048576"),
    (&["bench", "render", "g.json"], "--threads", "from 1 to 1024"),
    (&["bench", "shade"], "--runs", "from 1 to 100"),
    (&["bench", "compile"], "--runs", "from 1 to 100"),
    (&["bench", "compile"], "--nodes", "from 1 to 100000"),
];

/// Whatever it is given, it says itself what would do; nothing is taken for a flag that nobody knows.
#[test]
fn every_flag_refuses_what_is_no_number_of_its_range() {
    for (command, flag, remedy) in FLAGS {
        for text in ["-1", "-1.5", "-inf", "-", "1e400", "NaN", "inf", "", "many", "0x10", "+1"] {
            refused(&[command, &[flag, text]].concat(), &[flag, remedy]);
        }
        refused(&[command, &[&format!("{flag}=-1")]].concat(), &[flag, remedy]);
    }
}
