//! Numeric hazards that are known from constants, and from the ranges of parameters and outputs.

use std::ops::RangeInclusive;

use crate::diagnostics::{Code, Finding};
use crate::document::{Reader, ValueKind, shortened, shown};
use crate::nodes::FINITE;

use super::draft::{Draft, Source, SourceKind};

/// What must not arrive at an input for its node to mean something.
#[derive(Clone, Copy)]
enum Hazard {
    /// Zero: the node divides by it.
    Zero,
    /// Anything below zero: the node raises it to a power.
    Negative,
}

impl Hazard {
    fn name(self) -> &'static str {
        match self {
            Hazard::Zero => "0",
            Hazard::Negative => "negative",
        }
    }
}

/// Inputs that are fine with every number by the conventions of `docs/numerics.md`, but mean
/// nothing with some. All other limits are ranges in the signatures.
const HAZARDS: [(&str, &str, Hazard); 3] = [
    ("divide", "b", Hazard::Zero),
    ("modulo", "b", Hazard::Zero),
    ("power", "base", Hazard::Negative),
];

/// Reports inputs where a hazard arrives, or may.
pub(super) fn check(reader: &mut Reader<'_>, draft: &Draft<'_>) {
    for (at, drafted) in draft.nodes.iter().enumerate() {
        let Some(node_type) = drafted.node_type else { continue };
        let signature = draft.library.signature(node_type);
        for (name, input, hazard) in HAZARDS {
            if name != signature.name {
                continue;
            }
            let given = drafted.inputs.iter().find(|given| given.member.key == input);
            let Some(source) = given.map(|given| &given.source) else { continue };
            // A range the signature declares is told of as such.
            let declared = signature.inputs.iter().any(|it| it.name == input && it.range != FINITE);
            if let Some(arriving) = arriving(draft, source, hazard)
                && !declared
            {
                let of = shortened(draft.name(at));
                let (does, convention) = match hazard {
                    Hazard::Zero => ("divides by", "a division by 0 gives 0"),
                    Hazard::Negative => ("raises to a power", "see docs/numerics.md for its value"),
                };
                let message =
                    format!("node `{of}` ({name}) {does} its input `{input}`, which {arriving}");
                let help =
                    format!("keep such values away with its range or a `maximum`; {convention}");
                let place = reader.document.place(source.value);
                reader.findings.push(Finding::new(Code::NUMERIC_HAZARD, place, message, help));
            }
        }
    }
}

/// How the hazard arrives, if it is known to.
fn arriving(draft: &Draft<'_>, source: &Source<'_>, hazard: Hazard) -> Option<String> {
    match source.kind {
        SourceKind::Literal => {
            let elements = match &source.value.kind {
                ValueKind::Array(elements) => &elements[..elements.len().min(3)],
                _ => std::slice::from_ref(source.value),
            };
            let number = |kind: &ValueKind| match kind {
                ValueKind::Number(text) => text.parse::<f32>().ok().map(f64::from),
                _ => None,
            };
            let hit = elements
                .iter()
                .filter_map(|element| number(&element.kind))
                .find(|&x| holds(&(x..=x), hazard))?;
            Some(format!("is {hit}"))
        }
        SourceKind::Parameter(parameter) => {
            let parameter = draft.parameters[parameter].parameter.as_ref()?;
            // A parameter without a range of its own says nothing.
            let known = parameter.range != FINITE && holds(&parameter.range, hazard);
            let (name, range) = (shortened(&parameter.name), shown(&parameter.range));
            known.then(|| format!("parameter `{name}` may make {} ({range})", hazard.name()))
        }
        SourceKind::Node(node, Some(output)) => {
            let signature = draft.library.signature(draft.nodes[node].node_type?);
            let output = &signature.outputs[output];
            let known = output.range != FINITE && holds(&output.range, hazard);
            let (name, range) = (shortened(draft.name(node)), shown(&output.range));
            let of = format!("output `{}` of node `{name}`", output.name);
            known.then(|| format!("{of} may make {} ({range})", hazard.name()))
        }
        SourceKind::Node(_, None) | SourceKind::Compound(_) | SourceKind::Broken => None,
    }
}

fn holds(range: &RangeInclusive<f64>, hazard: Hazard) -> bool {
    match hazard {
        Hazard::Zero => range.contains(&0.0),
        Hazard::Negative => *range.start() < 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nodes::NodeLibrary;

    #[test]
    fn every_hazard_names_an_input() {
        let library = NodeLibrary::standard();
        for (name, input, _) in HAZARDS {
            let node_type = library.find(name).unwrap_or_else(|| panic!("no node `{name}`"));
            assert!(library.signature(node_type).input(input).is_some(), "{name}.{input}");
        }
    }
}
