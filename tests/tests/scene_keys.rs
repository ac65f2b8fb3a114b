//! What the table of scene keys says, the reader of scenes does: every key is read, what must be given must be given,
//! defaults are those that hold, and ranges end where the table says.

use std::path::Path;

use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::document::{Given, Key, Kind, Section};
use phenomenon_runtime::film::{self, Film};
use phenomenon_runtime::lights::Environment;
use phenomenon_runtime::scene_file::{
    EnvironmentDescription, MaterialRef, SCENE, SceneFile, read_scene,
};
use serde_json::{Value, json};

/// A scene in which a section stands, and where.
struct Example {
    scene: Value,
    pointer: &'static str,
}

/// A folder with what the examples name.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    film::write(&Film::new(4, 2).unwrap(), &folder.path().join("a.hdr"), 1.0).unwrap();
    folder
}

fn example(section: &Section) -> Example {
    let mut scene = json!({
        "scene": "s",
        "camera": { "position": [0, 0, 5], "look_at": [0, 0, 0] },
        "objects": [
            { "sphere": { "radius": 1 }, "material": { "file": "a.json" }, "transform": {} },
            { "rectangle": { "width": 1, "depth": 1 }, "material": { "subject": true } },
            { "mesh": "a.obj", "material": { "file": "a.json" } },
        ],
        "lights": [
            { "name": "a", "point": { "position": [0, 0, 0] } },
            { "name": "b", "directional": { "direction": [0, 0, 1] } },
            { "name": "c", "spot": { "position": [0, 0, 0], "direction": [0, 0, 1] } },
            { "name": "d", "rectangle": { "position": [0, 0, 0], "direction": [0, 0, 1], "width": 1, "height": 1 } },
            { "name": "e", "disc": { "position": [0, 0, 0], "direction": [0, 0, 1], "radius": 1 } },
            { "name": "f", "sphere": { "position": [0, 0, 0], "radius": 1 } },
        ],
        "environment": { "image": "a.hdr" },
        "options": {},
    });
    let pointer = match section.name {
        "scene" => "",
        "camera" => "/camera",
        // The mesh: its normals are read.
        "object" => "/objects/2",
        "sphere" => "/objects/0/sphere",
        "rectangle" => "/objects/1/rectangle",
        "transform" => "/objects/0/transform",
        "material" => "/objects/0/material",
        "light" => "/lights/0",
        "point" => "/lights/0/point",
        "directional" => "/lights/1/directional",
        "spot" => "/lights/2/spot",
        "rectangle_light" => "/lights/3/rectangle",
        "disc" => "/lights/4/disc",
        "sphere_light" => "/lights/5/sphere",
        "environment_light" => {
            scene["lights"] = json!([{ "name": "g", "environment": {} }]);
            "/lights/0/environment"
        }
        "environment" => "/environment",
        "gradient" => {
            scene["environment"] = json!({ "gradient": {
                "zenith": [0, 0, 0], "horizon": [0, 0, 0], "ground": [0, 0, 0] } });
            "/environment/gradient"
        }
        "options" => "/options",
        other => panic!("no example has the section {other}"),
    };
    Example { scene, pointer }
}

impl Example {
    /// The example made ready for a key, with that value; without one the key is left out.
    fn with(&self, section: &Section, key: &Key, value: Option<Value>) -> Value {
        let mut scene = self.scene.clone();
        let object = scene.pointer_mut(self.pointer).unwrap().as_object_mut().unwrap();
        if key.given == Given::Choice {
            section.one_of.iter().for_each(|other| {
                object.remove(*other);
            });
        }
        // What stands beside it may exclude it.
        match (section.name, key.name) {
            ("environment", "set") => {
                *object = json!({ "file": "a.json" }).as_object().unwrap().clone();
            }
            ("transform", "matrix") => object.clear(),
            _ => {}
        }
        match value {
            Some(value) => {
                object.insert(key.name.into(), value);
            }
            None => {
                object.remove(key.name);
            }
        }
        scene
    }

    /// The key as findings have it.
    fn path(&self, key: &Key) -> String {
        let dotted = self.pointer.split('/').skip(1).fold(String::new(), |path, part| {
            match part.parse::<usize>() {
                Ok(at) => format!("{path}[{at}]"),
                Err(_) if path.is_empty() => part.to_owned(),
                Err(_) => format!("{path}.{part}"),
            }
        });
        if dotted.is_empty() { key.name.into() } else { format!("{dotted}.{}", key.name) }
    }
}

fn read(scene: &Value, folder: &Path) -> SceneFile {
    read_scene("scene.json", scene.to_string().as_bytes(), folder)
}

/// The codes of what is found at a key or below it.
fn codes_at(file: &SceneFile, path: &str) -> Vec<Code> {
    let below = |found: &str| {
        found.strip_prefix(path).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
    };
    let findings = file.findings.iter().filter(|finding| below(&finding.place.path));
    findings.map(|finding| finding.code).collect()
}

/// Everything that is read of a scene, but for places.
fn content(file: &SceneFile) -> String {
    let Some(scene) = &file.scene else { panic!("{:#?}", file.findings) };
    let material = |material: &MaterialRef| {
        let set: Vec<_> = material.set.iter().map(|set| (&set.name, set.place.text())).collect();
        format!("{:?} {set:?}", material.source)
    };
    let objects: Vec<_> = scene
        .objects
        .iter()
        .map(|it| (&it.name, &it.shape, &it.transform, material(&it.material)))
        .collect();
    let environment = match &scene.environment {
        None => String::new(),
        Some(EnvironmentDescription::Shader(shader)) => material(shader),
        Some(EnvironmentDescription::BuiltIn(Environment::Image(image))) => format!("{image:?}"),
        Some(EnvironmentDescription::BuiltIn(other)) => {
            format!("{:?}", other.color([0.0, 1.0, 0.0]))
        }
    };
    format!(
        "{} {:?} {objects:?} {:?} {environment} {:?}",
        scene.name, scene.camera, scene.lights, scene.options
    )
}

fn keys() -> impl Iterator<Item = (&'static Section, &'static Key)> {
    SCENE.all().into_iter().flat_map(|section| section.keys.iter().map(move |key| (section, key)))
}

#[test]
fn the_examples_have_no_mistakes() {
    let folder = folder();
    for section in SCENE.all() {
        let file = read(&example(section).scene, folder.path());
        assert!(file.findings.is_empty(), "{}: {:?}", section.name, file.findings);
    }
}

#[test]
fn every_key_is_read() {
    let folder = folder();
    for (section, key) in keys() {
        if matches!(key.kind, Kind::Anything) {
            continue;
        }
        let example = example(section);
        let file = read(&example.with(section, key, Some(json!([[]]))), folder.path());
        let path = example.path(key);
        assert!(!codes_at(&file, &path).is_empty(), "{path} is not read: {:?}", file.findings);
    }
}

#[test]
fn what_must_be_given_must_be_given() {
    let folder = folder();
    for (section, key) in keys() {
        let example = example(section);
        let file = read(&example.with(section, key, None), folder.path());
        let codes: Vec<Code> = file.findings.iter().map(|finding| finding.code).collect();
        let expected = match key.given {
            // A file without it is no scene.
            Given::Required if key.name == "scene" => vec![Code::NOT_A_SCENE],
            Given::Required => vec![Code::MISSING_KEY],
            Given::Choice => vec![Code::UNUSABLE_OBJECT],
            Given::RequiredBut(_) => panic!("objects of scenes have no types"),
            Given::Optional | Given::Default(_) => Vec::new(),
        };
        assert_eq!(codes, expected, "{}", example.path(key));
    }
}

#[test]
fn defaults_are_those_that_hold() {
    let folder = folder();
    let mut compared = 0;
    for (section, key) in keys() {
        let Given::Default(default) = key.given else { continue };
        let example = example(section);
        let given = example.with(section, key, Some(serde_json::from_str(default).unwrap()));
        let left_out = example.with(section, key, None);
        let [given, left_out] =
            [given, left_out].map(|scene| content(&read(&scene, folder.path())));
        assert_eq!(given, left_out, "{}", example.path(key));
        compared += 1;
    }
    assert!(compared >= 14, "{compared}");
}

/// The number a range is tried with stands last in its list: the others stay as they are.
fn with_last(key: &Key, number: Value) -> Value {
    fn of_kind(kind: &Kind, number: Value) -> Value {
        match kind {
            Kind::Several(of, count) => {
                let mut list = vec![json!(1); *count.end() - 1];
                list.push(of_kind(of, number));
                Value::Array(list)
            }
            Kind::Either(_, other) => of_kind(other, number),
            _ => number,
        }
    }
    of_kind(&key.kind, number)
}

/// The ends of a range, and what lies just past them.
fn ends(kind: &Kind) -> Option<([Value; 2], [Value; 2])> {
    match kind {
        Kind::Whole(range) => {
            let (low, high) = (*range.start(), *range.end());
            let whole = |number: i128| match u64::try_from(number) {
                Ok(number) => json!(number),
                Err(_) => json!(number as i64),
            };
            // Past 2^53 the next whole number is the next of f64.
            let above =
                if high < 1 << 53 { whole(high + 1) } else { json!((high as f64).next_up()) };
            Some(([whole(low), whole(high)], [whole(low - 1), above]))
        }
        Kind::Number(range) => {
            let (low, high) = (*range.start(), *range.end());
            Some(([json!(low), json!(high)], [json!(low.next_down()), json!(high.next_up())]))
        }
        Kind::Several(of, _) => ends(of),
        Kind::Either(_, other) => ends(other),
        _ => None,
    }
}

#[test]
fn ranges_end_where_the_table_says() {
    let folder = folder();
    let mut tried = 0;
    for (section, key) in keys() {
        let Some((inside, outside)) = ends(&key.kind) else { continue };
        let example = example(section);
        let path = example.path(key);
        let codes = |number: &Value| {
            let scene = example.with(section, key, Some(with_last(key, number.clone())));
            codes_at(&read(&scene, folder.path()), &path)
        };
        for number in &inside {
            let codes = codes(number);
            assert!(!codes.contains(&Code::NUMBER_OUT_OF_RANGE), "{path}: {number} is refused");
        }
        for number in &outside {
            let codes = codes(number);
            let refused = [Code::NUMBER_OUT_OF_RANGE, Code::NEWER_FORMAT];
            let is_refused = codes.iter().any(|code| refused.contains(code));
            assert!(is_refused, "{path}: {number} gives {codes:?}");
        }
        tried += 1;
    }
    assert!(tried >= 20, "{tried}");
}

#[test]
fn words_are_those_of_the_table() {
    let folder = folder();
    for (section, key) in keys() {
        let Kind::Word(words) = key.kind else { continue };
        let example = example(section);
        let codes = |word: &str| {
            let scene = example.with(section, key, Some(json!(word)));
            codes_at(&read(&scene, folder.path()), &example.path(key))
        };
        words.iter().for_each(|word| assert_eq!(codes(word), [], "{word}"));
        assert_eq!(codes("other"), [Code::UNKNOWN_CHOICE]);
    }
}
