//! The camera, the lights and the environment of a scene file.

use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::document::{Object, Reader, Value};

use super::description::EnvironmentDescription;
use super::file::{COORDINATES, vector};
use super::objects::{file_path, material};
use crate::camera::Camera;
use crate::film::{self, FilmError};
use crate::lights::{Environment, EnvironmentImage, Light, LightKind};

/// What colours and intensities of light may be.
const LIGHT: std::ops::RangeInclusive<f64> = 0.0..=1e12;

pub(super) fn camera<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<Camera> {
    let keys = ["position", "look_at", "up", "field_of_view"];
    let object = reader.object(value, "the camera", &keys)?;
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

pub(super) fn lights<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<Vec<Light>> {
    let mut lights: Vec<Light> = Vec::new();
    let mut complete = true;
    for element in reader.list(value, "`lights`")? {
        let Some(light) = light(reader, element) else {
            complete = false;
            continue;
        };
        if lights.iter().any(|other| other.name == light.name) {
            let place = element.get("name").unwrap_or(element);
            let message = format!("two lights are called `{}`", light.name);
            reader.report(Code::BAD_NAME, place, message, "rename one: graphs list lights by name");
        }
        lights.push(light);
    }
    complete.then_some(lights)
}

fn light<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<Light> {
    let keys = ["name", "point", "directional", "color", "intensity"];
    let object = reader.object(value, "a light", &keys)?;
    let name = object.required(reader, "name").and_then(|name| reader.string(name, "`name`"));
    let color = match object.optional("color") {
        Some(value) => reader.numbers(value, "`color` of a light", LIGHT),
        None => Some([1.0; 3]),
    };
    let intensity = match object.optional("intensity") {
        Some(value) => reader.number(value, "`intensity` of a light", LIGHT),
        None => Some(1.0),
    };
    let kind = match (object.optional("point"), object.optional("directional")) {
        (Some(point), None) => {
            let object = reader.object(point, "a point light", &["position"]);
            object
                .and_then(|object| vector(reader, &object, "position"))
                .map(|position| LightKind::Point { position: position.map(|x| x as f32) })
        }
        (None, Some(sun)) => {
            let object = reader.object(sun, "a directional light", &["direction"]);
            let direction = object.and_then(|object| vector(reader, &object, "direction"));
            if direction == Some([0.0; 3]) {
                let message = "a directional light needs a direction that is not zero";
                reader.report(Code::UNUSABLE_OBJECT, sun, message, "its light travels along it");
            }
            direction
                .map(|direction| LightKind::Directional { direction: direction.map(|x| x as f32) })
        }
        _ => {
            let message = "a light is either `point` or `directional`";
            reader.report(Code::UNUSABLE_OBJECT, value, message, "give one of the two keys");
            None
        }
    };
    let (color, intensity) = (color?, intensity?);
    let power = color.map(|color| (color * intensity) as f32);
    Some(Light { name: name?.to_owned(), power, kind: kind? })
}

pub(super) fn environment<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    folder: &Path,
) -> Option<EnvironmentDescription> {
    let what = "the environment";
    let keys = ["color", "gradient", "image", "intensity", "rotation", "file", "set"];
    let object = reader.object(value, what, &keys)?;
    if object.optional("file").is_some() {
        return material(reader, value, what, folder).map(EnvironmentDescription::Shader);
    }
    let built_in = if let Some(color) = object.optional("color") {
        let [r, g, b] = reader.numbers(color, "`color` of the environment", LIGHT)?;
        Environment::Constant([r as f32, g as f32, b as f32, 1.0])
    } else if let Some(gradient) = object.optional("gradient") {
        let object = reader.object(gradient, "the gradient", &["zenith", "horizon", "ground"])?;
        let mut color = |key: &str| {
            let value = object.required(reader, key)?;
            let color: [f64; 3] = reader.numbers(value, &format!("`{key}`"), LIGHT)?;
            Some(color.map(|x| x as f32))
        };
        let (zenith, horizon, ground) = (color("zenith"), color("horizon"), color("ground"));
        Environment::Gradient { zenith: zenith?, horizon: horizon?, ground: ground? }
    } else if object.optional("image").is_some() {
        image(reader, &object, folder)?
    } else {
        let message = "the environment is a color, a gradient, an image or a graph";
        let help = "give one of the keys `color`, `gradient`, `image` and `file`";
        reader.report(Code::UNUSABLE_OBJECT, value, message, help);
        return None;
    };
    Some(EnvironmentDescription::BuiltIn(built_in))
}

fn image<'d>(reader: &mut Reader<'d>, object: &Object<'d>, folder: &Path) -> Option<Environment> {
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
    match film::read(&path) {
        Ok(film) => {
            let film = film.without_invalid_light();
            let (intensity, rotation) = (intensity? as f32, rotation? as f32);
            Some(Environment::Image(Arc::new(EnvironmentImage { film, intensity, rotation })))
        }
        Err(error) => {
            let code = match error {
                FilmError::Unreadable { .. } => Code::UNREADABLE_FILE,
                _ => Code::UNUSABLE_FILE,
            };
            reader.report(code, value, error.to_string(), "give a .hdr, .exr or .png picture");
            None
        }
    }
}
