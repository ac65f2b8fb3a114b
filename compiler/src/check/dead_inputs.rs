//! Connections that are never evaluated, because of what is known of the values that decide.

use crate::diagnostics::{Code, Finding, shortened};
use crate::document::Reader;

use super::draft::{Draft, DraftInput, SourceKind};
use super::intervals::Intervals;

/// Reports connections to inputs whose guard never holds.
pub(super) fn check(reader: &mut Reader<'_>, draft: &Draft<'_>, intervals: &Intervals<'_>) {
    for (at, dead) in intervals.never_demanded(draft) {
        let drafted = &draft.nodes[at];
        let Some(node_type) = drafted.node_type else { continue };
        let signature = draft.node_types.signature(node_type);
        let given = |input: usize| drafted.inputs.iter().find(|given| given.input == Some(input));
        let connected = |given: &&DraftInput<'_>| matches!(given.source.kind, SourceKind::Node(..));
        let Some(connection) = given(dead).filter(connected) else { continue };
        // A guard looks at earlier inputs that are not guarded themselves.
        let deciding = || (0..dead).filter(|&earlier| !signature.inputs[earlier].guarded);
        let names: Vec<String> =
            deciding().map(|earlier| format!("`{}`", signature.inputs[earlier].name)).collect();
        let mut reasons = Vec::new();
        let mut parameters = Vec::new();
        for earlier in deciding() {
            let Some(source) = given(earlier).map(|given| given.source.kind) else { continue };
            let of = match source {
                SourceKind::Parameter(parameter) => {
                    let name = shortened(&draft.parameters[parameter].name);
                    parameters.push(format!("`{name}`"));
                    format!("parameter `{name}`")
                }
                SourceKind::Node(node, Some(output)) => draft.described_output(node, output),
                _ => continue,
            };
            let is = match intervals.arriving(draft, at, earlier).as_slice() {
                [word] => format!("is {}", word.described()),
                // Of several components there is no one thing to say.
                _ => "rules it out".into(),
            };
            reasons.push(format!("its `{}`, {of}, {is}", signature.inputs[earlier].name));
        }
        let why = match reasons.is_empty() {
            true => format!("the constant {} rules it out", names.join(" and ")),
            false => reasons.join(" and "),
        };
        let input = &signature.inputs[dead].name;
        let message =
            format!("input `{input}` of {} is never evaluated: {why}", draft.described(at));
        let help = match parameters.is_empty() {
            true => format!(
                "connect {} to something that varies, or remove `{input}`",
                names.join(" or ")
            ),
            false => format!(
                "ranges are enforced where parameters are bound: widen that of {}, or remove `{input}`",
                parameters.join(" or ")
            ),
        };
        let place = reader.document.place(connection.source.value);
        reader.findings.push(Finding::new(Code::DEAD_INPUT, place, message, help));
    }
}
