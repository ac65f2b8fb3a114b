//! The types of values, and literals.

use std::collections::HashMap;
use std::fmt;
use std::sync::{Mutex, OnceLock, PoisonError};

/// The type of an input, an output or an interface parameter. Arrays and structs have none: the
/// checker takes them apart, so that each of their parts is of one of these.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Type {
    /// True or false.
    Boolean,
    /// 32-bit signed integer.
    Integer,
    /// 32-bit floating point number.
    Scalar,
    /// Scene-linear Rec. 709 red, green, blue, and alpha.
    Color,
    /// Three numbers.
    Vector,
    /// A 4×4 matrix, row by row; points are rows, so the translation is the last row.
    Transform,
    /// Text; uniform, never computed.
    String,
    /// A picture; uniform, never computed.
    Texture,
    /// A light of the scene by name; uniform, never computed.
    Light,
    /// A list of lights by name; uniform, never computed.
    Lights,
    /// A shader that is called for its colour: an output of a node, not its value.
    Shader,
    /// The one type a generic node is used with: scalar, vector or color.
    Generic,
}

impl Type {
    /// Every type a parameter or a part of one may have.
    pub const ALL: [Type; 11] = [
        Type::Scalar,
        Type::Integer,
        Type::Boolean,
        Type::Color,
        Type::Vector,
        Type::Transform,
        Type::String,
        Type::Texture,
        Type::Light,
        Type::Lights,
        Type::Shader,
    ];

    /// Number of 32-bit words; none for what is not a value of a point.
    pub fn width(self) -> usize {
        match self {
            Type::Boolean | Type::Integer | Type::Scalar | Type::String => 1,
            Type::Vector => 3,
            Type::Color | Type::Shader => 4,
            Type::Transform => 16,
            Type::Texture | Type::Light | Type::Lights | Type::Generic => 0,
        }
    }

    /// The name in graph files.
    pub fn name(self) -> &'static str {
        match self {
            Type::Boolean => "boolean",
            Type::Integer => "integer",
            Type::Scalar => "scalar",
            Type::Color => "color",
            Type::Vector => "vector",
            Type::Transform => "transform",
            Type::String => "string",
            Type::Texture => "texture",
            Type::Light => "light",
            Type::Lights => "lights",
            Type::Shader => "shader",
            Type::Generic => "scalar | vector | color",
        }
    }

    /// Whether it is the same for all points: given by a literal or a parameter, never by a node.
    pub fn is_uniform(self) -> bool {
        matches!(self, Type::String | Type::Texture | Type::Light | Type::Lights)
    }

    /// Whether the engines have it in their code rather than in words: another value is other code.
    pub fn is_in_code(self) -> bool {
        matches!(self, Type::Texture | Type::Light | Type::Lights)
    }

    /// Whether its values are numbers that may have a range.
    pub fn is_numeric(self) -> bool {
        matches!(self, Type::Integer | Type::Scalar | Type::Color | Type::Vector | Type::Generic)
    }

    /// Whether a value of this type is converted without a node: integer to scalar, scalar (or
    /// integer) to color, a light to a list of one, the color of a node (or what becomes one) to the shader
    /// that makes it.
    pub fn converts_to(self, to: Type) -> bool {
        self == to
            || matches!(
                (self, to),
                (Type::Integer, Type::Scalar | Type::Color)
                    | (Type::Scalar, Type::Color)
                    | (Type::Light, Type::Lights)
                    | (Type::Integer | Type::Scalar | Type::Color, Type::Shader)
            )
    }
}

/// A literal, of a known type.
#[derive(Clone, Debug, PartialEq)]
pub enum Literal {
    /// See [`Type::Boolean`].
    Boolean(bool),
    /// See [`Type::Integer`].
    Integer(i32),
    /// See [`Type::Scalar`].
    Scalar(f32),
    /// See [`Type::Color`].
    Color([f32; 4]),
    /// See [`Type::Vector`].
    Vector([f32; 3]),
    /// See [`Type::Transform`].
    Transform([f32; 16]),
    /// See [`Type::String`].
    String(String),
    /// See [`Type::Texture`]; none where no picture is given.
    Texture(Option<Texture>),
    /// See [`Type::Light`].
    Light(String),
    /// Names of lights in the scene's order of mention; empty: every light of the scene.
    Lights(Vec<String>),
    /// The shader that is called where none is given: transparent black.
    NoShader,
}

/// A picture, and how its numbers become colours.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Texture {
    /// Path of the file, relative to the working folder or absolute.
    pub file: String,
    /// What its numbers mean.
    pub space: Space,
}

/// What the numbers of a picture mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Space {
    /// Encoded as IEC 61966-2-1 has it: decoded to scene-linear when read. Alpha is linear.
    Srgb,
    /// Taken as they are: scene-linear colours, or data.
    Linear,
}

impl Space {
    /// Every space with its name in graph files.
    pub const ALL: [(&str, Space); 2] = [("srgb", Space::Srgb), ("linear", Space::Linear)];

    /// The space of a file that does not say: EXR and HDR are linear, all others sRGB.
    pub fn of_file(file: &str) -> Space {
        let lower = file.to_ascii_lowercase();
        let linear = lower.ends_with(".exr") || lower.ends_with(".hdr");
        if linear { Space::Linear } else { Space::Srgb }
    }

    /// Name in graph files.
    pub fn name(self) -> &'static str {
        match self {
            Space::Srgb => "srgb",
            Space::Linear => "linear",
        }
    }
}

impl Literal {
    /// The transform that changes nothing.
    pub const IDENTITY: Literal = Literal::Transform([
        1.0, 0.0, 0.0, 0.0, //
        0.0, 1.0, 0.0, 0.0, //
        0.0, 0.0, 1.0, 0.0, //
        0.0, 0.0, 0.0, 1.0,
    ]);

    /// Its type.
    pub fn value_type(&self) -> Type {
        match self {
            Literal::Boolean(_) => Type::Boolean,
            Literal::Integer(_) => Type::Integer,
            Literal::Scalar(_) => Type::Scalar,
            Literal::Color(_) => Type::Color,
            Literal::Vector(_) => Type::Vector,
            Literal::Transform(_) => Type::Transform,
            Literal::String(_) => Type::String,
            Literal::Texture(_) => Type::Texture,
            Literal::Light(_) => Type::Light,
            Literal::Lights(_) => Type::Lights,
            Literal::NoShader => Type::Shader,
        }
    }

    /// Its words as the engines store them: floats by their bits, true as all bits set, a string by
    /// a number that stands for it as long as the program runs.
    pub fn words(&self) -> Vec<u32> {
        let bits = |values: &[f32]| values.iter().map(|x| x.to_bits()).collect();
        match self {
            Literal::Boolean(true) => vec![u32::MAX],
            Literal::Boolean(false) => vec![0],
            Literal::Integer(value) => vec![*value as u32],
            Literal::Scalar(value) => bits(&[*value]),
            Literal::Color(value) => bits(value),
            Literal::Vector(value) => bits(value),
            Literal::Transform(value) => bits(value),
            Literal::String(text) => vec![number_of(text)],
            Literal::Texture(_) | Literal::Light(_) | Literal::Lights(_) => Vec::new(),
            Literal::NoShader => vec![0; 4],
        }
    }

    /// Converted as [`Type::converts_to`] allows; a shader is never a literal but none.
    pub fn converted_to(&self, to: Type) -> Option<Literal> {
        Some(match (self, to) {
            (literal, to) if literal.value_type() == to => literal.clone(),
            (Literal::Integer(value), Type::Scalar) => Literal::Scalar(*value as f32),
            (Literal::Integer(value), Type::Color) => {
                let x = *value as f32;
                Literal::Color([x, x, x, 1.0])
            }
            (Literal::Scalar(x), Type::Color) => Literal::Color([*x, *x, *x, 1.0]),
            (Literal::Light(name), Type::Lights) => Literal::Lights(vec![name.clone()]),
            _ => return None,
        })
    }
}

/// As it is written in a graph file.
impl fmt::Display for Literal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list = |numbers: &[f32]| {
            let numbers: Vec<String> = numbers.iter().map(f32::to_string).collect();
            format!("[{}]", numbers.join(", "))
        };
        let quoted = |text: &str| serde_json::Value::from(text);
        let light = |name: &String| format!("{{ \"light\": {} }}", quoted(name));
        match self {
            Literal::Boolean(value) => write!(f, "{value}"),
            Literal::Integer(value) => write!(f, "{value}"),
            Literal::Scalar(value) => write!(f, "{value}"),
            Literal::Color(value) => f.write_str(&list(value)),
            Literal::Vector(value) => f.write_str(&list(value)),
            Literal::Transform(value) => f.write_str(&list(value)),
            Literal::String(text) => write!(f, "{}", quoted(text)),
            Literal::Texture(None) | Literal::NoShader => f.write_str("null"),
            Literal::Texture(Some(Texture { file, space })) => {
                write!(f, "{{ \"texture\": {}, \"space\": \"{}\" }}", quoted(file), space.name())
            }
            Literal::Light(name) => f.write_str(&light(name)),
            Literal::Lights(names) => {
                write!(f, "[{}]", names.iter().map(light).collect::<Vec<_>>().join(", "))
            }
        }
    }
}

/// A number for a string: equal strings have equal numbers, and only they.
fn number_of(text: &str) -> u32 {
    static NUMBERS: OnceLock<Mutex<HashMap<String, u32>>> = OnceLock::new();
    let numbers = NUMBERS.get_or_init(Mutex::default);
    let mut numbers = numbers.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = numbers.get(text) {
        return *known;
    }
    let number = numbers.len() as u32;
    numbers.insert(text.to_owned(), number);
    number
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strings_have_the_same_number_only_if_they_are_the_same() {
        let words = |text: &str| Literal::String(text.into()).words();
        let texts = ["", " ", "a", "A", "\u{e9}", "e\u{301}"];
        for (at, a) in texts.iter().enumerate() {
            for (other, b) in texts.iter().enumerate() {
                assert_eq!(words(a) == words(b), at == other, "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn literals_convert_as_types_do() {
        let light = Literal::Light("key".into());
        assert_eq!(light.converted_to(Type::Lights), Some(Literal::Lights(vec!["key".into()])));
        assert_eq!(Literal::Lights(Vec::new()).converted_to(Type::Light), None);
        assert_eq!(Literal::Color([1.0; 4]).converted_to(Type::Shader), None);
        assert_eq!(Literal::NoShader.words(), [0; 4]);
        for value_type in Type::ALL {
            assert!(value_type.converts_to(value_type));
        }
    }

    #[test]
    fn a_file_that_does_not_say_has_the_space_of_its_kind() {
        assert_eq!(Space::of_file("a.EXR"), Space::Linear);
        assert_eq!(Space::of_file("a.exr.png"), Space::Srgb);
    }
}
