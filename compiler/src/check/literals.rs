//! Literals, once it is known what type they must be.

use std::path::{Path, PathBuf};

use crate::diagnostics::Code;
use crate::document::{Reader, Value, ValueKind, numbers};
use crate::graph::bind::is_affine;
use crate::values::{Literal, Space, Texture, Type};

/// The type a literal has by itself: a number is a scalar, a list of three or four a color. None
/// for what can only suit one type of place.
pub(super) fn natural_type(value: &Value) -> Option<Type> {
    match &value.kind {
        ValueKind::Boolean(_) => Some(Type::Boolean),
        ValueKind::Number(_) => Some(Type::Scalar),
        ValueKind::Array(elements) if matches!(elements.len(), 3 | 4) => Some(Type::Color),
        _ => None,
    }
}

/// What may stand where a literal is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Room {
    /// Nothing but a literal: a default, or what a scene sets.
    Literal,
    /// A connection as well.
    Input,
    /// A connection as well; a number stands for a vector of three of it.
    Generic,
}

/// Reads a literal as `to`, or reports it. `what` names the place: "input `a` of node `n` (add)".
pub(super) fn read<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    to: Type,
    room: Room,
    what: &dyn Fn() -> String,
) -> Option<Literal> {
    match (to, &value.kind) {
        (Type::Lights, ValueKind::Array(elements)) => lights(reader, elements),
        (Type::Light, ValueKind::Object(_)) if value.get("light").is_some() => {
            light(reader, value).map(Literal::Light)
        }
        (Type::Texture, ValueKind::Object(_)) if value.get("texture").is_some() => {
            texture(reader, value).map(|texture| Literal::Texture(Some(texture)))
        }
        (Type::Texture, ValueKind::Null) => Some(Literal::Texture(None)),
        (Type::Shader, ValueKind::Null) => Some(Literal::NoShader),
        (Type::String, ValueKind::String(text)) => Some(Literal::String(text.clone())),
        (Type::Transform, ValueKind::Array(elements)) if elements.len() == 16 => {
            transform(reader, value, elements, what)
        }
        (_, ValueKind::Array(elements))
            if to.is_numeric()
                && room != Room::Literal
                && elements.iter().any(|element| matches!(element.kind, ValueKind::Object(_))) =>
        {
            let message =
                format!("{} takes {}, not a list of connections", what(), with_article(to));
            let help = "lists are of numbers; compute components with a `combine_color` or \
                        `combine_vector` node and connect that";
            reader.report(Code::TYPE_MISMATCH, value, message, help);
            None
        }
        (Type::Boolean, ValueKind::Boolean(value)) => Some(Literal::Boolean(*value)),
        (Type::Integer, ValueKind::Number(_)) => {
            reader.integer(value, &what(), i32::MIN..=i32::MAX).map(Literal::Integer)
        }
        (Type::Scalar, ValueKind::Number(_)) => number(reader, value, what).map(Literal::Scalar),
        (Type::Color, ValueKind::Number(_)) => {
            number(reader, value, what).map(|x| Literal::Color([x, x, x, 1.0]))
        }
        (Type::Vector, ValueKind::Number(_)) if room == Room::Generic => {
            number(reader, value, what).map(|x| Literal::Vector([x; 3]))
        }
        (Type::Color, ValueKind::Array(elements)) if matches!(elements.len(), 3 | 4) => {
            let mut color = [0.0, 0.0, 0.0, 1.0];
            components(reader, elements, &mut color, what).then_some(Literal::Color(color))
        }
        (Type::Vector, ValueKind::Array(elements)) if elements.len() == 3 => {
            let mut vector = [0.0; 3];
            components(reader, elements, &mut vector, what).then_some(Literal::Vector(vector))
        }
        _ => {
            mismatch(reader, value, to, room, what);
            None
        }
    }
}

fn number<'d>(reader: &mut Reader<'d>, value: &'d Value, what: &dyn Fn() -> String) -> Option<f32> {
    // The text of the place is costly for a graph of many literals, so it is made for a finding only.
    if let ValueKind::Number(text) = &value.kind
        && let Some(number) = numbers::single(text)
    {
        return Some(number);
    }
    reader.finite(value, &what()).map(|number| number as f32)
}

fn components<'d>(
    reader: &mut Reader<'d>,
    elements: &'d [Value],
    into: &mut [f32],
    what: &dyn Fn() -> String,
) -> bool {
    let mut complete = true;
    for (element, into) in elements.iter().zip(into) {
        match number(reader, element, &|| format!("a component of {}", what())) {
            Some(number) => *into = number,
            None => complete = false,
        }
    }
    complete
}

fn lights<'d>(reader: &mut Reader<'d>, elements: &'d [Value]) -> Option<Literal> {
    let mut names = Vec::with_capacity(elements.len());
    let mut complete = true;
    for element in elements {
        match light(reader, element) {
            Some(name) => names.push(name),
            None => complete = false,
        }
    }
    complete.then_some(Literal::Lights(names))
}

fn light<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<String> {
    let object = reader.object(value, "a light", &["light"])?;
    let name = object.required(reader, "light")?;
    reader.string(name, "the name of a light").map(str::to_owned)
}

/// `{ "texture": "a.png", "space": "srgb" }`; the path is relative to the folder of the file.
fn texture<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<Texture> {
    let object = reader.object(value, "a texture", &["texture", "space"])?;
    let file = object.required(reader, "texture")?;
    let space = match object.optional("space") {
        None => None,
        Some(space) => Some(reader.choice(space, "the space of a texture", &Space::ALL)?),
    };
    reader.files.push(file);
    let file = reader.string(file, "the file of a texture")?;
    let path = beside(&reader.document.file.name, file);
    Some(Texture { space: space.unwrap_or(Space::of_file(file)), file: path.display().to_string() })
}

/// The path of a file that is named in another.
pub(super) fn beside(document: &str, file: &str) -> PathBuf {
    Path::new(document).parent().unwrap_or(Path::new("")).join(file)
}

fn transform<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    elements: &'d [Value],
    what: &dyn Fn() -> String,
) -> Option<Literal> {
    let mut rows = [0.0; 16];
    if !components(reader, elements, &mut rows, what) {
        return None;
    }
    if !is_affine(&rows) {
        let message = format!("{} takes an affine transform, and this one has perspective", what());
        let help = "the last number of each row of four must be 0, and 1 in the last row";
        reader.report(Code::TYPE_MISMATCH, value, message, help);
        return None;
    }
    Some(Literal::Transform(rows))
}

fn mismatch(
    reader: &mut Reader<'_>,
    value: &Value,
    to: Type,
    room: Room,
    what: &dyn Fn() -> String,
) {
    let (given, remedy) = if value.get("texture").is_some() {
        ("a texture".into(), Some("give it to a `texture_lookup` node, and connect that"))
    } else if value.get("light").is_some() {
        ("a light".into(), Some("give it to the input `lights` of a `light_loop`"))
    } else {
        (value.describe(), None)
    };
    let message = format!("{} takes {}, not {given}", what(), with_article(to));
    if let Some(remedy) = remedy.filter(|_| room != Room::Literal) {
        return reader.report(Code::TYPE_MISMATCH, value, message, remedy);
    }
    let form = match to {
        Type::Boolean => "write `true` or `false`",
        Type::Integer => "write a whole number",
        Type::Scalar => "write a number",
        Type::Color => "write `[r, g, b]`, `[r, g, b, a]`, or one number for grey",
        Type::Vector => "write `[x, y, z]`",
        Type::Transform => "write sixteen numbers, row by row: `[1, 0, 0, 0, …, 0, 0, 0, 1]`",
        Type::String => "write a text between double quotes",
        Type::Texture => "write `{ \"texture\": \"file.png\" }`, or `null` for none",
        Type::Light => "write `{ \"light\": \"key\" }`",
        Type::Shader if room == Room::Literal => "write `null`: only a graph connects shaders",
        Type::Shader => "connect a node, or write `null` for none",
        Type::Lights => "write a list such as `[{ \"light\": \"key\" }]`",
        Type::Generic => "write a number, `[x, y, z]` or `[r, g, b, a]`",
    };
    let help = match &value.kind {
        ValueKind::String(_) if to != Type::Shader && room != Room::Literal => {
            format!(
                "{form}, or a connection: `{{ \"node\": \"name\" }}` or `{{ \"interface\": \"name\" }}`"
            )
        }
        _ => form.to_owned(),
    };
    reader.report(Code::TYPE_MISMATCH, value, message, help);
}

/// A type's name with its article.
pub(super) fn with_article(value_type: Type) -> String {
    match value_type {
        Type::Integer => "an integer".into(),
        Type::Lights => "a list of lights".into(),
        Type::Generic => "a scalar, vector or color".into(),
        other => format!("a {}", other.name()),
    }
}
