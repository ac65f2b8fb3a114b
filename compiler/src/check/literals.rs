//! Literals, once it is known what type they must be.

use std::path::{Path, PathBuf};

use crate::diagnostics::Code;
use crate::document::{Reader, Value, ValueKind, numbers};
use crate::graph::bind::is_affine;
use crate::values::{Literal, Space, Texture, Type};

use super::keys::TEXTURE;
use super::type_names::with_article;
use super::{color_literals, mismatch};

/// The type a literal has by itself: a number is a scalar, a list of three or four a color. None
/// for what can only suit one type of place.
pub(super) fn natural_type(value: &Value) -> Option<Type> {
    match &value.kind {
        ValueKind::Boolean(_) => Some(Type::Boolean),
        ValueKind::Number(_) => Some(Type::Scalar),
        ValueKind::Array(elements) if matches!(elements.len(), 3 | 4) => Some(Type::Color),
        ValueKind::Object(_) if color_literals::space_of(value).is_some() => Some(Type::Color),
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
            let help = "lists are of numbers; compute components with a `combine_color` or \
                        `combine_vector` node and connect that";
            let (what, takes) = (what(), with_article(to));
            mismatch::report(reader, value, (&what, &takes, "not a list of connections"), help);
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
        (Type::Color, ValueKind::Object(_))
            if let Some(space) = color_literals::space_of(value) =>
        {
            color_literals::read_color(reader, value, space).map(Literal::Color)
        }
        (Type::Vector, ValueKind::Array(elements)) if elements.len() == 3 => {
            let mut vector = [0.0; 3];
            components(reader, elements, &mut vector, what).then_some(Literal::Vector(vector))
        }
        _ => {
            mismatch::literal(reader, value, to, room != Room::Literal, what);
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
    let object = reader.object(value, TEXTURE.what, &TEXTURE.names())?;
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
