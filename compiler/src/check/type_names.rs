//! Types as messages name them.

use crate::values::Type;

/// A type's name with its article.
pub(super) fn with_article(value_type: Type) -> String {
    match value_type {
        Type::Integer => "an integer".into(),
        Type::Lights => "a list of lights".into(),
        Type::Generic => "a scalar, vector or color".into(),
        other => format!("a {}", other.name()),
    }
}

/// How a value of a type is written; a shader is one where connections may stand.
pub(super) fn form(value_type: Type, connects: bool) -> &'static str {
    match value_type {
        Type::Boolean => "write `true` or `false`",
        Type::Integer => "write a whole number",
        Type::Scalar => "write a number",
        Type::Color => "write `[r, g, b]`, `[r, g, b, a]`, or one number for grey",
        Type::Vector => "write `[x, y, z]`",
        Type::Transform => "write sixteen numbers, row by row: `[1, 0, 0, 0, …, 0, 0, 0, 1]`",
        Type::String => "write a text between double quotes",
        Type::Texture => "write `{ \"texture\": \"file.png\" }`, or `null` for none",
        Type::Light => "write `{ \"light\": \"key\" }`",
        Type::Shader if connects => "connect a node, or write `null` for none",
        Type::Shader => "write `null`: only a graph connects shaders",
        Type::Lights => "write a list such as `[{ \"light\": \"key\" }]`",
        Type::Generic => "write a number, `[x, y, z]` or `[r, g, b, a]`",
    }
}
