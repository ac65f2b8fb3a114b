//! Literals.

use std::collections::HashMap;
use std::fmt;
use std::sync::{Mutex, OnceLock, PoisonError};

use super::{Texture, Type};

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

    /// What the default of a generic input is where that is of type `to`: a number is repeated over the
    /// components of a vector, as a transform it scales, and as a boolean it tells whether it is not 0.
    pub fn as_default(&self, to: Type) -> Option<Literal> {
        match (self, to) {
            (Literal::Scalar(x), Type::Vector) => Some(Literal::Vector([*x; 3])),
            (Literal::Scalar(x), Type::Integer) => Some(Literal::Integer(*x as i32)),
            (Literal::Scalar(x), Type::Boolean) => Some(Literal::Boolean(*x != 0.0)),
            (Literal::Scalar(x), Type::Transform) => {
                Some(Literal::Transform(std::array::from_fn(|at| match at {
                    0 | 5 | 10 => *x,
                    15 => 1.0,
                    _ => 0.0,
                })))
            }
            _ => self.converted_to(to),
        }
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

impl From<f32> for Literal {
    fn from(value: f32) -> Self {
        Literal::Scalar(value)
    }
}

impl From<i32> for Literal {
    fn from(value: i32) -> Self {
        Literal::Integer(value)
    }
}

impl From<bool> for Literal {
    fn from(value: bool) -> Self {
        Literal::Boolean(value)
    }
}

impl From<[f32; 3]> for Literal {
    fn from(value: [f32; 3]) -> Self {
        Literal::Vector(value)
    }
}

impl From<[f32; 4]> for Literal {
    fn from(value: [f32; 4]) -> Self {
        Literal::Color(value)
    }
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
    fn a_number_is_a_default_of_every_type_that_is_computed() {
        let of = |x: f32, to: Type| Literal::Scalar(x).as_default(to).expect("a default");
        assert_eq!(of(1.0, Type::Transform), Literal::IDENTITY);
        assert_eq!(of(0.0, Type::Boolean), Literal::Boolean(false));
        assert_eq!(of(1.0, Type::Integer), Literal::Integer(1));
        for to in Type::COMPUTED {
            assert_eq!(of(0.5, to).value_type(), to);
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
}
