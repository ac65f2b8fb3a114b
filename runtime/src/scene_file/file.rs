//! Scene files.

use std::path::Path;

use phenomenon_compiler::diagnostics::{Code, Finding, Place};
use phenomenon_compiler::document::numbers::{self, Whole};
use phenomenon_compiler::document::{
    Document, Reader, Value, ValueKind, all_mistakes, read, read_file,
};

use super::assets::Assets;
use super::description::{GraphUse, SceneDescription, SceneOptions};
use super::fields::section;
use super::keys::{OPTIONS, SCENE};
use super::{lights, objects, surroundings};
use crate::film::{PIXEL_LIMIT, SIDE_LIMIT};
use crate::render::SAMPLE_LIMIT;
use crate::scene::{DEPTH_LIMIT, TraceDepth};

/// What reading a scene yields.
#[derive(Clone, Default)]
pub struct SceneFile {
    /// The scene; none when a finding is an error.
    pub scene: Option<SceneDescription>,
    /// The graph files it uses, as far as they can be told, in file order.
    pub uses: Vec<GraphUse>,
    /// Its lights; none where something of them is wrong.
    pub lights: Option<LightNames>,
    /// What was found, in file order.
    pub findings: Vec<Finding>,
    /// How many findings are not kept, for there are too many.
    pub omitted: usize,
}

/// The lights of a scene by name, as graphs ask for them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LightNames {
    /// Their names, in file order.
    pub names: Vec<String>,
    /// Where the scene gives them; none where it has none.
    pub place: Option<Place>,
}

/// Whether a document is meant as a scene: it has the key `scene`, and not `phenomenon`.
pub fn is_scene(document: &Document) -> bool {
    document.root.get("scene").is_some() && document.root.get("phenomenon").is_none()
}

/// Reads a scene file with its meshes and pictures. All its mistakes are found in one run.
pub fn read_scene_file(path: &Path) -> SceneFile {
    match read_file(path) {
        Ok(document) => check_scene(&document, path.parent().unwrap_or(Path::new(""))),
        Err(finding) => SceneFile { findings: all_mistakes(*finding), ..SceneFile::default() },
    }
}

/// Reads a scene from bytes; `name` is how findings call it, and `folder` is where the files it
/// names are looked for.
pub fn read_scene(name: &str, bytes: &[u8], folder: &Path) -> SceneFile {
    match read(name, bytes) {
        Ok(document) => check_scene(&document, folder),
        Err(finding) => SceneFile { findings: all_mistakes(*finding), ..SceneFile::default() },
    }
}

/// Reads a scene from a document; the files it names are looked for in `folder`.
pub fn check_scene(document: &Document, folder: &Path) -> SceneFile {
    check_scene_with(document, folder, &Assets::default())
}

/// The same with pictures from elsewhere, or with what is remembered of them.
pub fn check_scene_with(document: &Document, folder: &Path, assets: &Assets) -> SceneFile {
    let mut reader = Reader::new(document);
    let mut file = SceneFile::default();
    let scene = scene(&mut reader, folder, assets, &mut file);
    file.scene = if reader.findings.has_errors() { None } else { scene };
    file.omitted = reader.findings.omitted();
    file.findings = reader.findings.into_sorted();
    file
}

fn scene(
    reader: &mut Reader<'_>,
    folder: &Path,
    assets: &Assets,
    file: &mut SceneFile,
) -> Option<SceneDescription> {
    let document = reader.document;
    let root = &document.root;
    if matches!(root.kind, ValueKind::Object(_)) && root.get("scene").is_none() {
        let help = match root.get("phenomenon") {
            Some(_) => "this file is a graph",
            None => "name it: add `\"scene\": \"…\"`",
        };
        let place = document.place_of_bytes(root.start, root.start + 1);
        reader.findings.push(Finding::new(Code::NOT_A_SCENE, place, "this file is no scene", help));
        return None;
    }
    if !reader.reads_format(root) {
        return None;
    }
    let object = section(reader, root, &SCENE)?;
    let name = object.required(reader, "scene").and_then(|value| reader.string(value, "`scene`"));
    if let Some(value) = object.optional("version") {
        reader.integer::<i32>(value, "`version`", 1..=1);
    }
    for (key, what) in [("doc", "`doc`"), ("$schema", "`$schema`")] {
        object.optional(key).map(|value| reader.string(value, what));
    }
    let camera =
        object.required(reader, "camera").and_then(|value| surroundings::camera(reader, value));
    let objects = object
        .required(reader, "objects")
        .and_then(|value| objects::objects(reader, value, folder, assets, &mut file.uses));
    let lights = match object.optional("lights") {
        Some(value) => lights::lights(reader, value),
        None => Some(Vec::new()),
    };
    if let Some(value) = object.optional("lights") {
        lights::check_environment_lights(reader, value, object.optional("environment").is_some());
    }
    file.lights = lights.as_ref().map(|lights| LightNames {
        names: lights.iter().map(|light| light.name.clone()).collect(),
        place: object.optional("lights").map(|value| document.place(value)),
    });
    let environment = object
        .optional("environment")
        .map(|value| surroundings::environment(reader, value, folder, assets, &mut file.uses));
    let options = match object.optional("options") {
        Some(value) => options(reader, value),
        None => Some(SceneOptions::default()),
    };
    Some(SceneDescription {
        name: name?.to_owned(),
        camera: camera?,
        objects: objects?,
        lights: lights?,
        environment: match environment {
            Some(environment) => Some(environment?),
            None => None,
        },
        options: options?,
    })
}

/// Every option is read, so that every mistake is found.
fn options<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<SceneOptions> {
    let object = section(reader, value, &OPTIONS)?;
    let default = SceneOptions::default();
    let size = match object.optional("size") {
        Some(value) => size(reader, value),
        None => Some((default.width, default.height)),
    };
    let samples = match object.optional("samples") {
        Some(value) => reader.integer(value, "`samples`", 1..=SAMPLE_LIMIT),
        None => Some(default.samples),
    };
    let seed = match object.optional("seed") {
        Some(value) => reader.integer(value, "`seed`", 0..=u64::MAX),
        None => Some(default.seed),
    };
    let depth = match object.optional("trace_depth") {
        Some(value) => trace_depth(reader, value),
        None => Some(default.depth),
    };
    let (width, height) = size?;
    Some(SceneOptions { width, height, samples: samples?, depth: depth?, seed: seed? })
}

fn size<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<(u32, u32)> {
    reader.numbers::<2>(value, "`size`", 1.0..=f64::from(SIDE_LIMIT))?;
    let ValueKind::Array(sides) = &value.kind else { return None };
    let side = |value: &Value| match &value.kind {
        ValueKind::Number(text) => match numbers::whole(text) {
            Whole::Number(side) => u32::try_from(side).ok(),
            Whole::Fraction | Whole::NoNumber => None,
        },
        _ => None,
    };
    let [Some(width), Some(height)] = [&sides[0], &sides[1]].map(side) else {
        reader.wrong_kind(value, "`size`", "a list of two whole numbers");
        return None;
    };
    if u64::from(width) * u64::from(height) > PIXEL_LIMIT {
        let message = format!("a picture of {width} x {height} pixels is too large");
        let help = format!("at most {PIXEL_LIMIT} pixels are possible");
        reader.report(Code::NUMBER_OUT_OF_RANGE, value, message, help);
        return None;
    }
    Some((width, height))
}

/// One number, or a list of one to three.
fn trace_depth<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<TraceDepth> {
    let values = match &value.kind {
        ValueKind::Array(values) if (1..=3).contains(&values.len()) => values.as_slice(),
        ValueKind::Array(_) => {
            reader.wrong_kind(value, "`trace_depth`", "one to three whole numbers");
            return None;
        }
        _ => std::slice::from_ref(value),
    };
    let numbers: Vec<Option<i32>> = values
        .iter()
        .enumerate()
        .map(|(at, value)| {
            let limit = if at == 2 { 2 * DEPTH_LIMIT } else { DEPTH_LIMIT };
            reader.integer(value, "`trace_depth`", 0..=limit)
        })
        .collect();
    let numbers: Option<Vec<i32>> = numbers.into_iter().collect();
    TraceDepth::from_numbers(&numbers?)
}
