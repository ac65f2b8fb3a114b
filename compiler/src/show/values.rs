//! Literals as the few characters a box has room for.

use crate::nodes::DefaultValue;
use crate::values::{Literal, Type};

/// What stands beside an input.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Value {
    /// The text.
    pub text: String,
    /// For a colour: linear red, green and blue.
    pub swatch: Option<[f32; 3]>,
}

impl Value {
    /// Text without a swatch.
    pub fn plain(text: impl Into<String>) -> Self {
        Self { text: text.into(), swatch: None }
    }
}

/// A literal.
pub(super) fn literal(literal: &Literal) -> Value {
    match literal {
        Literal::Boolean(value) => Value::plain(value.to_string()),
        Literal::Integer(value) => Value::plain(value.to_string()),
        Literal::Scalar(value) => Value::plain(number(*value)),
        Literal::Vector(vector) => Value::plain(listed(vector)),
        Literal::Color([r, g, b, a]) => {
            let opaque = *a == 1.0;
            let text = match (r == g && g == b, opaque) {
                (true, true) => number(*r),
                (_, true) => listed(&[*r, *g, *b]),
                (_, false) => listed(&[*r, *g, *b, *a]),
            };
            Value { text, swatch: Some([*r, *g, *b]) }
        }
        Literal::Transform(_) => Value::plain("transform"),
        Literal::String(text) => Value::plain(text.clone()),
        Literal::Texture(None) => Value::plain("no texture"),
        Literal::Texture(Some(texture)) => Value::plain(texture.file.clone()),
        Literal::NoShader => Value::plain("no shader"),
        Literal::Light(name) => Value::plain(name.clone()),
        Literal::Lights(names) if names.is_empty() => Value::plain("every light"),
        Literal::Lights(names) => Value::plain(names.join(", ")),
    }
}

/// What stands in where nothing is given.
pub(super) fn default(default: &DefaultValue, value_type: Type) -> Value {
    match default {
        DefaultValue::Literal(value) => match value.as_default(value_type) {
            Some(value) => literal(&value),
            None => literal(value),
        },
        DefaultValue::State(field) => Value::plain(format!("state.{}", field.name())),
        DefaultValue::Node(name) => Value::plain(*name),
        // The checker refuses it; a graph made by hand may still have it.
        DefaultValue::Required => Value::plain("missing"),
    }
}

fn listed(numbers: &[f32]) -> String {
    let texts: Vec<String> = numbers.iter().map(|x| number(*x)).collect();
    texts.join(", ")
}

/// The shortest digits that read back the same; powers of ten where zeros would take over.
fn number(x: f32) -> String {
    let size = x.abs();
    if size != 0.0 && size.is_finite() && !(1e-4..1e7).contains(&size) {
        return format!("{x:e}");
    }
    x.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stay_short_and_exact() {
        let hard =
            [0.0, -0.0, 0.1, 1.0 / 3.0, 1e-45, f32::MIN_POSITIVE, f32::MAX, -1e-5, 9_999_999.0];
        for x in hard {
            let text = number(x);
            assert!(text.len() <= 14, "{text}");
            assert_eq!(text.parse::<f32>().map(f32::to_bits), Ok(x.to_bits()), "{text}");
        }
        assert_eq!(number(-0.0), "-0");
        assert_eq!(number(f32::NAN), "NaN");
        assert_eq!(number(f32::NEG_INFINITY), "-inf");
    }

    #[test]
    fn colours_say_alpha_only_where_it_is_not_one() {
        let text = |color| literal(&Literal::Color(color)).text;
        assert_eq!(text([0.5, 0.5, 0.5, 1.0]), "0.5");
        assert_eq!(text([1.0, 0.5, 0.25, 1.0]), "1, 0.5, 0.25");
        assert_eq!(text([1.0, 1.0, 1.0, 0.0]), "1, 1, 1, 0");
        assert_eq!(text([f32::NAN, 0.0, 0.0, 1.0]), "NaN, 0, 0");
    }

    #[test]
    fn defaults_are_told_in_the_type_of_the_input() {
        let value = default(&DefaultValue::Literal(Literal::Scalar(1.0)), Type::Color);
        assert_eq!(value.swatch, Some([1.0; 3]));
        assert_eq!(default(&crate::nodes::node("mix"), Type::Vector).text, "mix");
        assert_eq!(
            default(&crate::nodes::state(crate::state::Field::U), Type::Scalar).text,
            "state.u"
        );
    }
}
