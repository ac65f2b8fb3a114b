//! Inputs that are known before shading: what may give them.

use crate::diagnostics::{Code, Finding, listed, shortened, shown};
use crate::document::{Reader, ValueKind};
use crate::graph::Binding;
use crate::nodes::{DefaultValue, Input, Signature};
use crate::values::{Literal, Type};

use super::draft::{Draft, Source, SourceKind};
use super::mismatch;
use super::type_names::with_article;

/// Whether a source can give such an input, with the words of a choice, or a finding: no node can, and a parameter only if it
/// never leaves the input's range, since the code is made for its value.
pub(super) fn suits(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    source: &Source<'_>,
    (input, words): (&Input, &[&str]),
    what: &dyn Fn() -> String,
) -> bool {
    match source.kind {
        SourceKind::Node(..) => {
            let message = format!("{} is known before shading, so no node can give it", what());
            let help = format!("give {}, or a parameter of type integer", form(input, words));
            reader.report(Code::FIXED_INPUT, source.value, message, help);
            false
        }
        SourceKind::Parameter(at) => {
            let Some(parameter) = &draft.parameters[at].parameter else { return true };
            let (low, high) = (*parameter.range.start(), *parameter.range.end());
            let within = input.range.contains(&low) && input.range.contains(&high);
            // Other types are told of as such.
            if parameter.value_type != Type::Integer || within {
                return true;
            }
            let name = shortened(&parameter.name);
            let range = shown(&input.range);
            let message = format!(
                "{} is known before shading and takes {range}, but parameter `{name}` may be {}",
                what(),
                shown(&parameter.range)
            );
            let (least, most) = (input.range.start(), input.range.end());
            let help = match parameter.labels.len() {
                0 => format!("give `{name}` a `min` of {least} and a `max` of {most}"),
                _ => format!("give `{name}` at most {} `values`", most + 1.0),
            };
            let place = reader.document.place(source.value);
            let declared = reader.document.place_of_key(draft.parameters[at].member);
            let finding = Finding::new(Code::FIXED_INPUT, place, message, help);
            reader.findings.push(finding.with_related(declared, "declared here"));
            false
        }
        SourceKind::Literal => {
            let is_word = matches!(source.value.kind, ValueKind::String(_));
            let suits =
                matches!(source.value.kind, ValueKind::Number(_)) || is_word && !words.is_empty();
            if !suits {
                let given = format!("not {}", source.value.describe());
                let texts = (&*what(), &*with_article(Type::Integer), &*given);
                mismatch::report(
                    reader,
                    source.value,
                    texts,
                    format!("write {}", form(input, words)),
                );
            }
            suits
        }
        SourceKind::Compound(_) | SourceKind::Broken => true,
    }
}

/// What the first such input of a node is when nothing is given for it.
pub(super) fn default(signature: &Signature) -> Binding {
    let fixed = signature.inputs.iter().find(|input| input.fixed);
    match fixed.map(|input| &input.default) {
        Some(DefaultValue::Literal(literal)) => Binding::Literal(literal.clone()),
        _ => Binding::Literal(Literal::Integer(0)),
    }
}

/// What a literal for it looks like.
fn form(input: &Input, words: &[&str]) -> String {
    if words.is_empty() {
        format!("a whole number in {}", shown(&input.range))
    } else {
        format!("one of {}", listed(words.iter().copied()))
    }
}
