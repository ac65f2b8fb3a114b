//! The lights of a scene file.

use std::collections::HashMap;

use phenomenon_compiler::diagnostics::{Code, Finding};
use phenomenon_compiler::document::{Object, Reader, Section, Value, ValueKind};

use super::fields::{color, section, vector};
use super::foreign;
use super::key_kinds::LIGHT;
use super::light_keys::{
    DIRECTIONAL, DISC, ENVIRONMENT_LIGHT, EXTENTS, INNER_ANGLES, LIGHT_SAMPLES, LIGHT_SOURCE,
    OUTER_ANGLES, POINT, RECTANGLE_LIGHT, SPHERE_LIGHT, SPOT,
};
use crate::lights::{Disc, Light, LightKind, Rectangle, Sphere, Spot};

pub(super) fn lights<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<Vec<Light>> {
    let mut lights: Vec<Light> = Vec::new();
    let mut complete = true;
    let mut named: HashMap<&str, &Value> = HashMap::new();
    for element in reader.list(value, "`lights`")? {
        match light(reader, element) {
            Some(light) => lights.push(light),
            None => complete = false,
        }
        let Some(name) = element.get("name") else { continue };
        let ValueKind::String(text) = &name.kind else { continue };
        let first = *named.entry(text).or_insert(name);
        if !std::ptr::eq(first, name) {
            let message = format!("two lights are called `{text}`");
            let help = "rename one: graphs list lights by name";
            let finding = Finding::new(Code::BAD_NAME, reader.document.place(name), message, help)
                .with_related(reader.document.place(first), "first given here");
            reader.findings.push(finding);
        }
    }
    complete.then_some(lights)
}

fn light<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<Light> {
    if foreign::light(reader, value) {
        return None;
    }
    let object = section(reader, value, &LIGHT_SOURCE)?;
    let name = object.required(reader, "name").and_then(|name| reader.string(name, "`name`"));
    let color = match object.optional("color") {
        Some(value) => color(reader, value, "`color` of a light"),
        None => Some([1.0; 3]),
    };
    let intensity = match object.optional("intensity") {
        Some(value) => reader.number(value, "`intensity` of a light", LIGHT),
        None => Some(1.0),
    };
    let kind = kind(reader, &object);
    let (color, intensity) = (color?, intensity?);
    let power = color.map(|color| (color * intensity) as f32);
    Some(Light { name: name?.to_owned(), power, kind: kind? })
}

/// The one shape it has, or a finding.
fn kind<'d>(reader: &mut Reader<'d>, object: &Object<'d>) -> Option<LightKind> {
    let given: Vec<_> = LIGHT_SOURCE
        .one_of
        .iter()
        .filter_map(|key| object.optional(key).map(|value| (*key, value)))
        .collect();
    // The key it is given by was told to be none.
    if given.is_empty() && foreign::has_other_keys(object.value, &LIGHT_SOURCE.names()) {
        return None;
    }
    let [(key, value)] = given[..] else {
        let message = "a light has exactly one shape: `point`, `spot`, `directional`, `rectangle`, `disc`, `sphere` or `environment`";
        reader.report(Code::UNUSABLE_OBJECT, object.value, message, "give one of these keys");
        return None;
    };
    match key {
        "point" => {
            let object = section(reader, value, &POINT)?;
            let position = vector(reader, &object, "position")?.map(|x| x as f32);
            Some(LightKind::Point { position })
        }
        "spot" => spot(reader, value).map(LightKind::Spot),
        "directional" => {
            let object = section(reader, value, &DIRECTIONAL)?;
            let direction = vector(reader, &object, "direction")?.map(|x| x as f32);
            if direction == [0.0; 3] {
                needs_direction(reader, value, "a directional light", "its light travels along it");
            }
            Some(LightKind::Directional { direction })
        }
        "rectangle" => rectangle(reader, value).map(LightKind::Rectangle),
        "disc" => disc(reader, value).map(LightKind::Disc),
        "environment" => {
            let (_, samples) = with_samples(reader, value, &ENVIRONMENT_LIGHT)?;
            Some(LightKind::Environment { samples: samples? })
        }
        _ => {
            let (object, samples) = with_samples(reader, value, &SPHERE_LIGHT)?;
            let position = vector(reader, &object, "position");
            let radius = extent(reader, &object, "radius");
            Some(LightKind::Sphere(Sphere::new(position?, radius?, samples?)))
        }
    }
}

/// Reports environment lights where there is no environment, or another of them.
pub(super) fn check_environment_lights(
    reader: &mut Reader<'_>,
    lights: &Value,
    has_environment: bool,
) {
    let ValueKind::Array(elements) = &lights.kind else { return };
    let mut of_environment = elements.iter().filter_map(|light| light.get("environment"));
    let Some(first) = of_environment.next() else { return };
    if !has_environment {
        let message = "an environment light in a scene without `environment` has nothing to shine";
        let help = "give the scene an `environment`, or remove the light";
        reader.report(Code::UNUSABLE_OBJECT, first, message, help);
    }
    for other in of_environment {
        let message = "a second light is the environment, which shines once";
        let help = "remove it, or give the first one more `samples` or another `intensity`";
        let finding =
            Finding::new(Code::UNUSABLE_OBJECT, reader.document.place(other), message, help)
                .with_related(reader.document.place(first), "the first one");
        reader.findings.push(finding);
    }
}

fn needs_direction(reader: &mut Reader<'_>, value: &Value, what: &str, help: &str) {
    let message = format!("{what} needs a direction that is not zero");
    reader.report(Code::UNUSABLE_OBJECT, value, message, help);
}

fn spot<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<Spot> {
    let object = section(reader, value, &SPOT)?;
    let position = vector(reader, &object, "position");
    let direction = vector(reader, &object, "direction");
    let mut angle = |key: &str, default: f64, range| match object.optional(key) {
        Some(value) => reader.number(value, &format!("`{key}` of a spot light"), range),
        None => Some(default),
    };
    let inner = angle("inner_angle", 0.0, INNER_ANGLES);
    let outer = angle("outer_angle", 45.0, OUTER_ANGLES);
    let (inner, outer) = (inner?, outer?);
    if inner > outer {
        let place = object.optional("inner_angle").unwrap_or(value);
        let message = format!(
            "`inner_angle` is {inner} degrees, and light ends at {outer} degrees, the `outer_angle`"
        );
        let help = "both count from the axis; make `inner_angle` the smaller one";
        reader.report(Code::UNUSABLE_OBJECT, place, message, help);
        return None;
    }
    let spot = Spot::new(position?, direction?, inner, outer);
    if spot.is_none() {
        needs_direction(reader, value, "a spot light", "it is the axis of its cone");
    }
    spot
}

fn rectangle<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<Rectangle> {
    let (object, samples) = with_samples(reader, value, &RECTANGLE_LIGHT)?;
    let position = vector(reader, &object, "position");
    let direction = vector(reader, &object, "direction");
    let size = ["width", "height"].map(|key| extent(reader, &object, key));
    let up = match object.optional("up") {
        Some(_) => Some(vector(reader, &object, "up")?),
        None => None,
    };
    let (position, direction, samples) = (position?, direction?, samples?);
    let size = [size[0]?, size[1]?];
    let upwards = |up: [f64; 3]| Rectangle::new(position, direction, up, size, samples);
    let rectangle = match up {
        Some(up) => upwards(up),
        None => upwards([0.0, 1.0, 0.0]).or_else(|| upwards([0.0, 0.0, -1.0])),
    };
    if rectangle.is_none() && direction == [0.0; 3] {
        needs_direction(reader, value, "a rectangle light", "it shines along it");
    } else if rectangle.is_none() {
        let place = object.optional("up").unwrap_or(value);
        let message = "`up` of a rectangle light is zero, or runs along its `direction`";
        let help = "give a direction across the one it shines in, or leave `up` out";
        reader.report(Code::UNUSABLE_OBJECT, place, message, help);
    }
    rectangle
}

fn disc<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<Disc> {
    let (object, samples) = with_samples(reader, value, &DISC)?;
    let position = vector(reader, &object, "position");
    let direction = vector(reader, &object, "direction");
    let radius = extent(reader, &object, "radius");
    let disc = Disc::new(position?, direction?, radius?, samples?);
    if disc.is_none() {
        needs_direction(reader, value, "a disc light", "it shines along it");
    }
    disc
}

/// A light with extent, and how many samples it has.
fn with_samples<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    of: &Section,
) -> Option<(Object<'d>, Option<u32>)> {
    let object = section(reader, value, of)?;
    let samples = match object.optional("samples") {
        Some(value) => reader.integer::<i32>(value, "`samples` of a light", LIGHT_SAMPLES),
        None => Some(4),
    };
    Some((object, samples.map(i32::unsigned_abs)))
}

/// A size a light must have; 0 leaves a line or a point.
fn extent<'d>(reader: &mut Reader<'d>, object: &Object<'d>, key: &str) -> Option<f64> {
    let value = object.required(reader, key)?;
    reader.number(value, &format!("`{key}` of {}", object.what), EXTENTS)
}
