//! Binding values to interface parameters, from text or literals, with their ranges enforced.

use thiserror::Error;

use super::parts::Parts;
use super::{Graph, Parameter};
use crate::diagnostics::{listed, shortened, shown};
use crate::document::numbers::{self, Whole};
use crate::values::{Literal, Space, Texture, Type};

/// Why a value cannot be bound to a parameter.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum BindError {
    /// There is no such parameter.
    #[error("`{phenomenon}` has no parameter `{name}`; {help}")]
    Unknown {
        /// The phenomenon.
        phenomenon: String,
        /// The name that was given.
        name: String,
        /// The nearest parameter, or all of them.
        help: String,
    },
    /// The text or the literal is not of the parameter's type.
    #[error("`{given}` is no value for the {type_name} parameter `{name}`; write {form}")]
    Type {
        /// The parameter.
        name: String,
        /// Its type.
        type_name: &'static str,
        /// What was given.
        given: String,
        /// How a value of the type is written.
        form: String,
    },
    /// A number is infinite or NaN.
    #[error("`{given}` for parameter `{name}` is not finite in 32 bits; give a number in {range}")]
    NotFinite {
        /// The parameter.
        name: String,
        /// What was given.
        given: String,
        /// Its range.
        range: String,
    },
    /// A number lies outside the parameter's range.
    #[error("{given} is outside the range of parameter `{name}`; give a number in {range}")]
    Range {
        /// The parameter.
        name: String,
        /// The number that was given.
        given: String,
        /// Its range.
        range: String,
    },
}

impl Graph {
    /// The value of parameter `name` written as `text`: `0.5`, `0.9,0.7,0.4`, `true`, a label of an
    /// enumeration, or names of lights joined by commas. A color takes one number (grey), three
    /// (alpha 1) or four. Numbers are written as in files; a string is taken as it stands.
    ///
    /// # Errors
    /// There is no such parameter, or the text is not of its type, not finite or out of range.
    pub fn bind(&self, name: &str, text: &str) -> Result<Literal, BindError> {
        let parameter = self.find_parameter(name)?;
        let literal = parameter.parse(text)?;
        parameter.admit(literal)
    }

    /// `literal` as a value of parameter `name`, converted as [`Type::converts_to`] allows.
    ///
    /// # Errors
    /// As for [`Graph::bind`].
    pub fn bind_literal(&self, name: &str, literal: &Literal) -> Result<Literal, BindError> {
        let parameter = self.find_parameter(name)?;
        match literal.converted_to(parameter.value_type) {
            Some(literal) => parameter.admit(literal),
            None => Err(parameter.type_error(&format!("a {}", literal.value_type().name()))),
        }
    }

    fn find_parameter(&self, name: &str) -> Result<&Parameter, BindError> {
        match self.parameter(name) {
            Some(at) => Ok(&self.parameters[at]),
            None => Err(BindError::Unknown {
                phenomenon: self.name.clone(),
                name: shortened(name),
                help: Parts::of(&self.parameters).remedy(name),
            }),
        }
    }
}

impl Parameter {
    fn parse(&self, text: &str) -> Result<Literal, BindError> {
        // Of numbers and words, as in files, the space round them does not count.
        let word = text.trim();
        match self.value_type {
            Type::Boolean => match word {
                "true" => Ok(Literal::Boolean(true)),
                "false" => Ok(Literal::Boolean(false)),
                _ => Err(self.type_error(text)),
            },
            Type::Integer => {
                if let Some(at) = self.labels.iter().position(|label| label == text) {
                    return Ok(Literal::Integer(at as i32));
                }
                match numbers::whole(word) {
                    Whole::Number(number) => i32::try_from(number)
                        .map(Literal::Integer)
                        .map_err(|_| self.range_error(word)),
                    Whole::Fraction => Err(self.type_error(text)),
                    Whole::NoNumber => Err(self.number_error(text, word)),
                }
            }
            Type::String => Ok(Literal::String(text.to_owned())),
            Type::Light if text.is_empty() => Err(self.type_error(text)),
            Type::Light => Ok(Literal::Light(text.to_owned())),
            Type::Texture => Ok(Literal::Texture(texture(text))),
            Type::Shader if word == "null" => Ok(Literal::NoShader),
            Type::Shader => Err(self.type_error(text)),
            Type::Lights => {
                let names = text.split(',').map(str::trim).filter(|name| !name.is_empty());
                Ok(Literal::Lights(names.map(str::to_owned).collect()))
            }
            Type::Scalar | Type::Color | Type::Vector | Type::Transform | Type::Generic => {
                self.parse_numbers(text)
            }
        }
    }

    fn parse_numbers(&self, text: &str) -> Result<Literal, BindError> {
        let mut given = Vec::new();
        for part in text.split(',').take(17).map(str::trim) {
            given.push(numbers::single(part).ok_or_else(|| self.number_error(text, part))?);
        }
        match (self.value_type, given.as_slice()) {
            (Type::Scalar, &[x]) => Ok(Literal::Scalar(x)),
            (Type::Vector, &[x, y, z]) => Ok(Literal::Vector([x, y, z])),
            (Type::Color, &[x]) => Ok(Literal::Color([x, x, x, 1.0])),
            (Type::Color, &[r, g, b]) => Ok(Literal::Color([r, g, b, 1.0])),
            (Type::Color, &[r, g, b, a]) => Ok(Literal::Color([r, g, b, a])),
            (Type::Transform, numbers) => match numbers.try_into() {
                Ok(rows) if is_affine(&rows) => Ok(Literal::Transform(rows)),
                _ => Err(self.type_error(text)),
            },
            _ => Err(self.type_error(text)),
        }
    }

    /// Why `part` of a text is no number: it is none, or too large.
    fn number_error(&self, text: &str, part: &str) -> BindError {
        if numbers::is_number(part) || numbers::names_no_finite(part) {
            return BindError::NotFinite {
                name: self.name.clone(),
                given: shortened(part),
                range: shown(&self.range),
            };
        }
        match (numbers::nearest_number(part), self.type_error(text)) {
            (Some(form), BindError::Type { name, type_name, given, .. }) => {
                let form = if part == text { form } else { format!("`{form}` for `{part}`") };
                BindError::Type { name, type_name, given, form }
            }
            (_, error) => error,
        }
    }

    /// `literal` if it is finite and in range. Alpha need only be finite.
    pub(crate) fn admit(&self, literal: Literal) -> Result<Literal, BindError> {
        let components: &[f32] = match &literal {
            Literal::Scalar(x) => std::slice::from_ref(x),
            Literal::Vector(vector) => vector,
            Literal::Color(color) => color,
            Literal::Transform(rows) => rows,
            Literal::Integer(number) if !self.range.contains(&f64::from(*number)) => {
                return Err(self.range_error(&number.to_string()));
            }
            _ => &[],
        };
        for (at, component) in components.iter().enumerate() {
            if !component.is_finite() {
                return Err(BindError::NotFinite {
                    name: self.name.clone(),
                    given: component.to_string(),
                    range: shown(&self.range),
                });
            }
            let ranged = at < 3 && self.value_type != Type::Transform;
            if ranged && !self.contains(*component) {
                return Err(self.range_error(&component.to_string()));
            }
        }
        Ok(literal)
    }

    /// Whether a component is in range. The bounds are rounded as the component was, so that a
    /// bound of 0.1 admits 0.1.
    fn contains(&self, component: f32) -> bool {
        (*self.range.start() as f32) <= component && component <= (*self.range.end() as f32)
    }

    fn range_error(&self, given: &str) -> BindError {
        BindError::Range {
            name: self.name.clone(),
            given: shortened(given),
            range: if self.value_type == Type::Integer && self.range == crate::nodes::FINITE {
                format!("{} to {}", i32::MIN, i32::MAX)
            } else {
                shown(&self.range)
            },
        }
    }

    fn type_error(&self, given: &str) -> BindError {
        let form = match self.value_type {
            Type::Boolean => "`true` or `false`".into(),
            Type::Integer if !self.labels.is_empty() => {
                format!("one of {}", listed(self.labels.iter().map(String::as_str)))
            }
            Type::Integer => "a whole number".into(),
            Type::Scalar => "a number, such as `0.5`".into(),
            Type::Color => "one, three or four numbers, such as `0.9,0.7,0.4`".into(),
            Type::Vector => "three numbers, such as `0,0,1`".into(),
            Type::Transform => {
                "sixteen numbers, row by row, the last of each row 0 but 1 in the last row".into()
            }
            Type::String => "any text".into(),
            Type::Texture => {
                "a file, a file and its space such as `bump.png,linear`, or `null`".into()
            }
            Type::Light => "the name of a light".into(),
            Type::Lights => "names of lights joined by commas".into(),
            Type::Shader => {
                "`null`; only a node can be a shader, in a graph that uses this one".into()
            }
            Type::Generic => "numbers".into(),
        };
        BindError::Type {
            name: self.name.clone(),
            type_name: self.value_type.name(),
            given: shortened(given),
            form,
        }
    }
}

/// `file` or `file,space`; nothing at all, or `null`, is no texture.
fn texture(text: &str) -> Option<Texture> {
    let spaced = text.rsplit_once(',').and_then(|(file, space)| {
        let (_, space) = Space::ALL.into_iter().find(|(name, _)| *name == space.trim())?;
        Some(Texture { file: file.to_owned(), space })
    });
    let plain = || Texture { file: text.to_owned(), space: Space::of_file(text) };
    (!matches!(text, "" | "null")).then(|| spaced.unwrap_or_else(plain))
}

/// Whether a matrix by rows maps points without perspective: its last column is 0, 0, 0, 1.
pub(crate) fn is_affine(rows: &[f32; 16]) -> bool {
    [rows[3], rows[7], rows[11], rows[15]] == [0.0, 0.0, 0.0, 1.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn graph() -> Graph {
        let ranged =
            |name: &str, default, range| Parameter { range, ..Parameter::new(name, default) };
        Graph {
            name: "g".into(),
            parameters: vec![
                ranged("ior", Literal::Scalar(1.5), 0.1..=4.0),
                ranged("tint", Literal::Color([1.0; 4]), 0.0..=1.0),
                Parameter::new("up", Literal::Vector([0.0, 0.0, 1.0])),
                Parameter::new("count", Literal::Integer(1)),
                Parameter {
                    labels: vec!["smooth".into(), "rough".into()],
                    ..ranged("mode", Literal::Integer(0), 0.0..=1.0)
                },
                Parameter::new("on", Literal::Boolean(true)),
                Parameter::new("lights", Literal::Lights(Vec::new())),
            ],
            ..Graph::default()
        }
    }

    #[test]
    fn text_becomes_a_literal_of_the_type() {
        let graph = graph();
        assert_eq!(graph.bind("ior", " 0.1 "), Ok(Literal::Scalar(0.1)), "a bound is inside");
        assert_eq!(graph.bind("tint", "0.5"), Ok(Literal::Color([0.5, 0.5, 0.5, 1.0])));
        assert_eq!(graph.bind("tint", "0,1,0, 9"), Ok(Literal::Color([0.0, 1.0, 0.0, 9.0])));
        assert_eq!(graph.bind("up", "0,-0,1e-40"), Ok(Literal::Vector([0.0, -0.0, 1e-40])));
        assert_eq!(graph.bind("count", "-2147483648"), Ok(Literal::Integer(i32::MIN)));
        assert_eq!(graph.bind("mode", "rough"), Ok(Literal::Integer(1)));
        assert_eq!(graph.bind("on", "false"), Ok(Literal::Boolean(false)));
        assert_eq!(graph.bind("count", "2.0"), Ok(Literal::Integer(2)));
        assert_eq!(graph.bind("count", "1e0"), Ok(Literal::Integer(1)));
        assert_eq!(graph.bind("ior", "1.00000005960464477540"), Ok(Literal::Scalar(1.000_000_1)));
        assert_eq!(
            graph.bind("lights", "key, rim"),
            Ok(Literal::Lights(vec!["key".into(), "rim".into()]))
        );
        assert_eq!(graph.bind("lights", ""), Ok(Literal::Lights(vec![])));
    }

    #[test]
    fn literals_convert_as_connections_do() {
        let graph = graph();
        assert_eq!(graph.bind_literal("ior", &Literal::Integer(2)), Ok(Literal::Scalar(2.0)));
        assert_eq!(
            graph.bind_literal("tint", &Literal::Scalar(0.5)),
            Ok(Literal::Color([0.5, 0.5, 0.5, 1.0]))
        );
        assert!(matches!(
            graph.bind_literal("up", &Literal::Scalar(0.5)),
            Err(BindError::Type { .. })
        ));
    }

    #[test]
    fn errors_name_range_and_remedy() {
        let graph = graph();
        let message = |name: &str, text: &str| graph.bind(name, text).unwrap_err().to_string();
        assert_eq!(
            message("ior", "4.1"),
            "4.1 is outside the range of parameter `ior`; give a number in 0.1 to 4"
        );
        assert_eq!(
            message("ior", "NaN"),
            "`NaN` for parameter `ior` is not finite in 32 bits; give a number in 0.1 to 4"
        );
        assert_eq!(
            message("ior", "1e39"),
            "`1e39` for parameter `ior` is not finite in 32 bits; give a number in 0.1 to 4"
        );
        assert_eq!(
            message("ior", "x"),
            "`x` is no value for the scalar parameter `ior`; write a number, such as `0.5`"
        );
        assert_eq!(message("iro", "1"), "`g` has no parameter `iro`; did you mean `ior`?");
        assert!(message("count", "99999999999999999999").contains("-2147483648 to 2147483647"));
        assert!(message("mode", "2").contains("0 to 1"));
        assert!(message("mode", "mid").contains("`smooth` and `rough`"));
        assert!(message("up", "1,2").contains("`0,0,1`"));
        assert!(message("tint", "1,2,3").starts_with("2 is outside"));
        assert!(message("tint", "1,1,1,inf").contains("not finite"));
        for text in ["maybe", "1", "0", "True", ""] {
            assert!(message("on", text).contains("`true` or `false`"), "{text}");
        }
        assert!(message("ior", ".5").ends_with("write 0.5"));
        assert!(message("ior", "+1").ends_with("write 1"));
        assert!(message("tint", "1,.5,0").ends_with("write `0.5` for `.5`"));
        assert!(message("count", "1.5").contains("a whole number"));
        assert!(message("count", "0x10").ends_with("write 16"));
    }
}
