//! What is said of nodes, inputs and parameters, in Markdown.

use super::part::{Part, text};
use super::parts::Parts;
use super::scope::Scope;

/// What there is to say of a node.
pub fn of_node(parts: &Parts) -> String {
    let listed = |parts: &[Part]| {
        let names: Vec<String> =
            parts.iter().map(|part| format!("`{}` {}", part.name, part.of)).collect();
        names.join(", ")
    };
    let Parts { title, doc, source, inputs, outputs } = parts;
    let (inputs, outputs) = (listed(inputs), listed(outputs));
    let mut told = format!("{title}\n\n{doc}\n\nInputs: {inputs}\n\nOutputs: {outputs}");
    if !source.is_empty() {
        told.push_str(&format!("\n\nSource: {source}"));
    }
    told
}

/// What there is to say of an input or an output.
pub fn of_input(input: &Part) -> String {
    format!("`{}` {}\n\n{}", input.name, input.of, input.doc)
}

/// What there is to say of a parameter, by the path of a part of it.
pub fn parameter(scope: &Scope<'_>, name: &str) -> Option<String> {
    let name = &name[..name.find(['.', '[']).unwrap_or(name.len())];
    let member = scope.members("interface").iter().find(|member| member.key == name)?;
    let of = text(&member.value, "type").unwrap_or_default();
    let doc = text(&member.value, "doc").unwrap_or_default();
    Some(format!("parameter `{name}` {of}\n\n{doc}"))
}
