//! Values of parameters, given as text.

use std::collections::HashSet;

use phenomenon_compiler::check::{SettingError, bind_text};
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::values::Literal;

/// A name, such as that of a parameter, and the text of its value, which only its type can tell how to read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextValue {
    /// The name.
    pub name: String,
    /// The value, as it stands: spaces may belong to a string.
    pub value: String,
}

/// Why a text cannot be the value of a parameter.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{name}={value}: {fault}")]
pub struct ValueError {
    /// The parameter.
    pub name: String,
    /// The text of its value.
    pub value: String,
    /// What is wrong with it.
    pub fault: ValueFault,
}

/// What is wrong with the text of a value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ValueFault {
    /// There is no such parameter, or it takes no such value.
    #[error(transparent)]
    Unsuitable(Box<SettingError>),
    /// It has a value already.
    #[error("`{0}` is set twice")]
    Twice(String),
}

/// The values that texts give to the parameters of a graph.
///
/// # Errors
/// There is no such parameter, it is set twice, or the value does not suit it.
pub fn bind_texts(
    graph: &Graph,
    texts: &[TextValue],
) -> Result<Vec<(String, Literal)>, ValueError> {
    let mut values: Vec<(String, Literal)> = Vec::with_capacity(texts.len());
    let mut known = HashSet::new();
    for TextValue { name, value } in texts {
        let refused = |fault| ValueError { name: name.clone(), value: value.clone(), fault };
        let given = bind_text(graph, name, value)
            .map_err(|error| refused(ValueFault::Unsuitable(Box::new(error))))?;
        for (part, literal) in given {
            if !known.insert(part.clone()) {
                return Err(refused(ValueFault::Twice(part)));
            }
            values.push((part, literal));
        }
    }
    Ok(values)
}
