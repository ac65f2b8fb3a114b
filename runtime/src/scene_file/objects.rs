//! The objects of a scene file, with their transforms and materials.

use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::diagnostics::{Code, Finding};
use phenomenon_compiler::document::{Object, Reader, Value, ValueKind};
use phenomenon_compiler::graph::RootKind;

use super::assets::Assets;
use super::description::{
    GraphUse, MaterialRef, MaterialSource, ObjectDescription, ShapeDescription,
};
use super::fields::{file_path, graph_file, preset, section, settings, vector};
use super::foreign;
use super::key_kinds::{COORDINATES, LENGTHS};
use super::keys::{MATERIAL, OBJECT, RECTANGLE, SPHERE, TRANSFORM};
use super::meshes::Meshes;
use crate::geometry::{Mesh, Normals, ShadowTerminator, Transform};

pub(super) fn objects<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    folder: &Path,
    assets: &Assets,
    uses: &mut Vec<GraphUse>,
) -> Option<Vec<ObjectDescription>> {
    let elements = reader.list(value, "`objects`")?;
    let mut meshes = Meshes::of(assets);
    // Every object is read, so that every mistake is found.
    let objects: Vec<_> =
        elements.iter().map(|value| object(reader, value, folder, &mut meshes, uses)).collect();
    let mut named: HashMap<&str, &Value> = HashMap::new();
    for name in elements.iter().filter_map(|object| object.get("name")) {
        let ValueKind::String(text) = &name.kind else { continue };
        let first = *named.entry(text).or_insert(name);
        if std::ptr::eq(first, name) {
            continue;
        }
        let message = format!("two objects are called `{text}`");
        let help = "rename one: findings call objects by their names";
        let place = reader.document.place(name);
        let finding = Finding::new(Code::BAD_NAME, place, message, help)
            .with_related(reader.document.place(first), "first given here");
        reader.findings.push(finding);
    }
    objects.into_iter().collect()
}

fn object<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    folder: &Path,
    meshes: &mut Meshes<'_>,
    uses: &mut Vec<GraphUse>,
) -> Option<ObjectDescription> {
    if foreign::shape(reader, value) {
        return None;
    }
    let object = section(reader, value, &OBJECT)?;
    let name = object.optional("name").map(|name| reader.string(name, "`name`"));
    if let Some(value) = object.optional("doc") {
        reader.string(value, "`doc`");
    }
    let shape = shape(reader, &object, folder, meshes);
    let ends = [("smooth", ShadowTerminator::Smooth), ("facets", ShadowTerminator::Facets)];
    let terminator = match object.optional("shadow_terminator") {
        Some(value) => reader.choice(value, "`shadow_terminator`", &ends),
        None => Some(ShadowTerminator::default()),
    };
    let transform = match object.optional("transform") {
        Some(value) => transform(reader, value),
        None => Some(Transform::default()),
    };
    let material =
        object.required(reader, "material").and_then(|value| material(reader, value, folder));
    uses.extend(material.clone().map(|material| GraphUse { material, root: RootKind::Material }));
    let (kind, shape) = shape?;
    let transform = transform?;
    if let (ShapeDescription::Sphere { .. }, None) = (&shape, transform.uniform_scale()) {
        let place = object.optional("transform").unwrap_or(value);
        let message = "a sphere can be scaled only by the same factor in every direction";
        reader.report(Code::UNUSABLE_OBJECT, place, message, "give `scale` one number");
        return None;
    }
    if let Err(error) = shape.check_placed(&transform) {
        // Without a transform it is the shape itself that is too large.
        let place = object.optional("transform").or(object.optional(kind)).unwrap_or(value);
        let message = format!("this object cannot be placed: {error}");
        let help = "scale it less, or move it nearer to the origin";
        reader.report(Code::UNUSABLE_OBJECT, place, message, help);
        return None;
    }
    let name = name.map_or(Some(kind), |name| name)?.to_owned();
    let (material, terminator) = (material?, terminator?);
    Some(ObjectDescription { name, shape, transform, material, terminator })
}

fn shape<'d>(
    reader: &mut Reader<'d>,
    object: &Object<'d>,
    folder: &Path,
    meshes: &mut Meshes<'_>,
) -> Option<(&'static str, ShapeDescription)> {
    let flat = [("smooth", Normals::Smooth), ("flat", Normals::Flat)];
    let normals = match object.optional("normals") {
        Some(value) => reader.choice(value, "`normals`", &flat),
        None => Some(Normals::Smooth),
    };
    // A mesh is read all the same, so that its mistakes are found.
    let smooth_or_flat = normals.unwrap_or(Normals::Smooth);
    let shapes = ["sphere", "mesh", "rectangle"];
    let given: Vec<_> = shapes
        .into_iter()
        .filter_map(|key| object.optional(key).map(|value| (key, value)))
        .collect();
    if given.is_empty() && foreign::has_other_keys(object.value, &OBJECT.names()) {
        // The key it is given by was told to be none.
        return None;
    }
    let [(kind, value)] = given[..] else {
        let message = "an object has exactly one shape: `sphere`, `mesh` or `rectangle`";
        reader.report(Code::UNUSABLE_OBJECT, object.value, message, "give one of the three keys");
        return None;
    };
    let second = object.optional("second_uv");
    if let Some(second) = second.filter(|_| kind != "mesh") {
        let message = "only a mesh has a second set of surface coordinates";
        let help = "leave `second_uv` out, or give the object as a `mesh`";
        reader.report(Code::UNUSABLE_OBJECT, second, message, help);
        return None;
    }
    let shape = match kind {
        "sphere" => sphere(reader, value)?,
        "mesh" => {
            let path = file_path(reader, value, "`mesh`", folder)?;
            let mesh = meshes.read(reader, value, &path, smooth_or_flat)?;
            let mesh = match second {
                Some(second) => {
                    let path = file_path(reader, second, "`second_uv`", folder)?;
                    meshes.with_second_set(reader, second, &path, smooth_or_flat, &mesh)?
                }
                None => mesh,
            };
            normals.map(|_| ShapeDescription::Mesh(mesh))?
        }
        _ => rectangle(reader, value)?,
    };
    Some((kind, shape))
}

fn sphere<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<ShapeDescription> {
    let object = section(reader, value, &SPHERE)?;
    let center = match object.optional("center") {
        Some(_) => vector(reader, &object, "center"),
        None => Some([0.0; 3]),
    };
    let radius = object
        .required(reader, "radius")
        .and_then(|value| reader.number(value, "`radius` of a sphere", LENGTHS));
    Some(ShapeDescription::Sphere { center: center?, radius: radius? })
}

fn rectangle<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<ShapeDescription> {
    let object = section(reader, value, &RECTANGLE)?;
    let mut side = |key: &str| {
        let value = object.required(reader, key)?;
        reader.number(value, &format!("`{key}` of a rectangle"), LENGTHS)
    };
    let (width, depth) = (side("width"), side("depth"));
    Some(ShapeDescription::Mesh(Arc::new(Mesh::rectangle(width? as f32, depth? as f32))))
}

/// `scale`, `rotate` and `translate`, applied in this order, or the three rows of a `matrix`.
fn transform<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<Transform> {
    let object = section(reader, value, &TRANSFORM)?;
    let transform = match object.optional("matrix") {
        Some(matrix) => {
            let numbers: [f64; 12] =
                reader.numbers(matrix, "`matrix` (three rows of four)", COORDINATES)?;
            let row = |at: usize| [0, 1, 2, 3].map(|column| numbers[at * 4 + column]);
            Transform::from_rows([row(0), row(1), row(2)])
        }
        None => {
            let scale = match object.optional("scale") {
                Some(value) if matches!(value.kind, ValueKind::Array(_)) => {
                    reader.numbers(value, "`scale`", COORDINATES)
                }
                Some(value) => reader.number(value, "`scale`", COORDINATES).map(|x| [x; 3]),
                None => Some([1.0; 3]),
            };
            let mut optional = |key: &str| match object.optional(key) {
                Some(value) => reader.numbers(value, &format!("`{key}`"), COORDINATES),
                None => Some([0.0; 3]),
            };
            let (rotate, translate) = (optional("rotate"), optional("translate"));
            Transform::new(scale?, rotate?, translate?)
        }
    };
    if transform.is_regular() {
        return Some(transform);
    }
    let message = "this transform flattens the object";
    reader.report(Code::UNUSABLE_OBJECT, value, message, "scale by factors other than 0");
    None
}

/// `{"subject": true}`, or `{"file": "graph.json", "preset": "smoke", "set": {…}}`.
fn material<'d>(reader: &mut Reader<'d>, value: &'d Value, folder: &Path) -> Option<MaterialRef> {
    if foreign::material(reader, value) {
        return None;
    }
    let object = section(reader, value, &MATERIAL)?;
    let subject = object.optional("subject").map(|value| reader.boolean(value, "`subject`"));
    if let (None, Some(file)) = (subject, object.optional("file")) {
        return graph_file(reader, &object, file, "`file` of a material", folder);
    }
    let (preset, set) = (preset(reader, &object), settings(reader, &object));
    match (subject, object.optional("file")) {
        (Some(Some(true)), None) => {
            let place = reader.document.place(value);
            let (preset, set) = (preset?, set?);
            Some(MaterialRef { source: MaterialSource::Subject, preset, set, place, change: None })
        }
        (Some(None), None) => None,
        _ => {
            let message = "a material is either a `file` or the `subject`";
            let help = "write {\"file\": \"graph.json\"} or {\"subject\": true}";
            reader.report(Code::UNUSABLE_OBJECT, value, message, help);
            None
        }
    }
}
