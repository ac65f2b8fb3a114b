//! What is said of values, and what makes one type of another.

use crate::check::type_names::with_article;
use crate::values::Type;

use super::operand::Arrives;

/// What arrives, with an article.
pub(super) fn described(arrives: Arrives) -> String {
    match arrives {
        Arrives::Number => "a number".into(),
        Arrives::Triple => "a list of three numbers".into(),
        Arrives::Text => "a text".into(),
        Arrives::Of(value_type) => with_article(value_type),
    }
}

/// What makes a value of one type of one of another, in an expression.
pub(in crate::check) fn remedy(from: Type, to: Type, text: &str) -> String {
    match (from, to) {
        (Type::Color, Type::Vector) => {
            format!("write `({text}).xyz` for its components as a vector")
        }
        (Type::Vector, Type::Color) => {
            format!("write `({text}).rgb` for its components as a color")
        }
        (Type::Color, Type::Scalar) => {
            "take a component, such as `.r`, or its `luminance(…)`".into()
        }
        (Type::Vector, Type::Scalar) => "take a component, such as `.x`, or its `length(…)`".into(),
        (Type::Scalar | Type::Integer, Type::Boolean) => format!("compare it: `{text} != 0`"),
        (Type::Boolean, Type::Scalar | Type::Color) => format!("write `{text} ? 1 : 0`"),
        (Type::Scalar, Type::Vector) => format!("write `vector({text})`"),
        (Type::Scalar, Type::Integer) => "a scalar is never rounded unasked".into(),
        _ => format!("give {} instead", with_article(to)),
    }
}
