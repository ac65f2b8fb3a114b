//! The camera and the environment of a scene file.

use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::document::{Object, Reader, Value};
use phenomenon_compiler::graph::RootKind;

use super::assets::{Assets, Unusable};
use super::description::{EnvironmentDescription, GraphUse};
use super::fields::{color, file_path, graph_file, section, vector};
use super::foreign;
use super::key_kinds::{COORDINATES, LIGHT};
use super::keys::{CAMERA, ENVIRONMENT, GRADIENT};
use crate::camera::Camera;
use crate::lights::{Environment, EnvironmentImage};

pub(super) fn camera<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<Camera> {
    let object = section(reader, value, &CAMERA)?;
    let position = vector(reader, &object, "position");
    let look_at = vector(reader, &object, "look_at");
    let up = match object.optional("up") {
        Some(value) => reader.numbers(value, "`up` of the camera", COORDINATES),
        None => Some([0.0, 1.0, 0.0]),
    };
    let angle = match object.optional("field_of_view") {
        Some(value) => reader.number(value, "`field_of_view` of the camera", 1e-3..=179.0),
        None => Some(40.0),
    };
    match Camera::new(position?, look_at?, up?, angle?) {
        Ok(camera) => Some(camera),
        Err(error) => {
            let help = "move `position` away from `look_at`, and turn `up` off the line between";
            reader.report(Code::UNUSABLE_OBJECT, value, error.to_string(), help);
            None
        }
    }
}

pub(super) fn environment<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    folder: &Path,
    assets: &Assets,
    uses: &mut Vec<GraphUse>,
) -> Option<EnvironmentDescription> {
    let object = section(reader, value, &ENVIRONMENT)?;
    let kinds = ["color", "gradient", "image", "file"];
    let given: Vec<&str> =
        kinds.into_iter().filter(|kind| object.optional(kind).is_some()).collect();
    if given.is_empty() && foreign::has_other_keys(value, &ENVIRONMENT.names()) {
        return None;
    }
    let [kind] = given[..] else {
        let message = match given.as_slice() {
            [] => "the environment is a color, a gradient, an image or a graph".to_owned(),
            _ => format!("the environment is given more than once, by `{}`", given.join("` and `")),
        };
        let help = "give one of the keys `color`, `gradient`, `image` and `file`";
        reader.report(Code::UNUSABLE_OBJECT, value, message, help);
        return None;
    };
    let keys = [("intensity", "image"), ("rotation", "image"), ("preset", "file"), ("set", "file")];
    for (key, of) in keys {
        let member = value.members().iter().find(|member| member.key == key);
        if let Some(member) = member.filter(|_| of != kind) {
            let message = format!("`{key}` does nothing in an environment that is no `{of}`");
            let help = format!("remove it, or give the environment by `{of}`");
            reader.report_key(Code::UNUSABLE_OBJECT, member, message, help);
        }
    }
    let built_in = match kind {
        "file" => {
            let file = object.required(reader, "file")?;
            let what = "`file` of the environment";
            let material = graph_file(reader, &object, file, what, folder)?;
            uses.push(GraphUse { material: material.clone(), root: RootKind::Environment });
            return Some(EnvironmentDescription::Shader(material));
        }
        "color" => {
            let given = object.required(reader, "color")?;
            let [r, g, b] = color(reader, given, "`color` of the environment")?;
            Environment::Constant([r as f32, g as f32, b as f32, 1.0])
        }
        "gradient" => {
            let value = object.required(reader, "gradient")?;
            gradient(reader, value)?
        }
        _ => image(reader, &object, folder, assets)?,
    };
    Some(EnvironmentDescription::BuiltIn(built_in))
}

fn gradient<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<Environment> {
    let object = section(reader, value, &GRADIENT)?;
    let mut height = |key: &str| {
        let value = object.required(reader, key)?;
        Some(color(reader, value, &format!("`{key}`"))?.map(|x| x as f32))
    };
    let (zenith, horizon, ground) = (height("zenith"), height("horizon"), height("ground"));
    Some(Environment::Gradient { zenith: zenith?, horizon: horizon?, ground: ground? })
}

fn image<'d>(
    reader: &mut Reader<'d>,
    object: &Object<'d>,
    folder: &Path,
    assets: &Assets,
) -> Option<Environment> {
    let intensity = match object.optional("intensity") {
        Some(value) => reader.number(value, "`intensity` of the environment", LIGHT),
        None => Some(1.0),
    };
    let rotation = match object.optional("rotation") {
        Some(value) => reader.number(value, "`rotation` of the environment", -3600.0..=3600.0),
        None => Some(0.0),
    };
    let value = object.required(reader, "image")?;
    let path = file_path(reader, value, "`image`", folder)?;
    match assets.picture(&path) {
        Ok(film) => {
            let film = film.without_invalid_light();
            let (intensity, rotation) = (intensity? as f32, rotation? as f32);
            Some(Environment::Image(Arc::new(EnvironmentImage { film, intensity, rotation })))
        }
        Err(Unusable { code, message }) => {
            reader.report(code, value, message, "give a .hdr, .exr or .png picture");
            None
        }
    }
}
