//! `outputs`: the values a phenomenon offers where it is a node.

use crate::diagnostics::{Code, shortened, synonyms};
use crate::document::{Member, Reader, Value};
use crate::graph::Output;
use crate::values::Type;

use super::bind_inputs::bind_source;
use super::draft::{Draft, DraftOutput};
use super::keys::OUTPUT;
use super::limits::MAX_OUTPUTS;
use super::names::check_key;
use super::sources;
use super::types::Types;

/// Reads all outputs. Those a file lacks are no mistake here: that is up to the roots.
pub(super) fn read<'d>(reader: &mut Reader<'d>, value: Option<&'d Value>, draft: &mut Draft<'d>) {
    let Some(value) = value else { return };
    let Some(members) = reader.members(value, "`outputs`") else { return };
    let members: Vec<&Member> = members.collect();
    if members.is_empty() {
        let message = "`outputs` declares no output, so it offers nothing";
        let help = "add `\"name\": { \"type\": …, \"from\": … }`, or leave `outputs` out";
        reader.report(Code::EMPTY_RANGE, value, message, help);
    }
    if members.len() > MAX_OUTPUTS {
        let count = members.len();
        let message = format!("a phenomenon has at most {MAX_OUTPUTS} outputs, this one {count}");
        reader.report(Code::TOO_MANY_PARTS, value, message, "split it into several phenomena");
        draft.unresolved.set(true);
        return;
    }
    for member in members {
        check_key(reader, member, "the name of an output");
        match read_output(reader, member, draft) {
            Some(output) => draft.outputs.push(output),
            None => draft.unresolved.set(true),
        }
    }
}

fn read_output<'d>(
    reader: &mut Reader<'d>,
    member: &'d Member,
    draft: &Draft<'d>,
) -> Option<DraftOutput<'d>> {
    let what = format!("output `{}`", shortened(&member.key));
    if is_bare(&member.value) {
        let message = format!("{what} is a connection, so its type is not declared");
        let form = "`{ \"type\": …, \"from\": { … } }`";
        let help = format!("declare it, with the connection under `from`: {form}");
        reader.report_key(Code::MISSING_KEY, member, message, help);
        return None;
    }
    let object = reader.object(&member.value, &what, &OUTPUT.names())?;
    let doc = object.optional("doc").and_then(|value| reader.string(value, "`doc`"));
    let choices = Type::COMPUTED.map(|value_type| (value_type.name(), value_type));
    let value_type = object.required(reader, "type").and_then(|value| {
        reader.choice_or(value, "the type of an output", &choices, synonyms::value_type)
    });
    let from = object.required(reader, "from")?;
    let source = sources::read(reader, from, draft);
    Some(DraftOutput { member, value_type, doc: doc.unwrap_or_default().to_owned(), source })
}

/// Whether it is what should stand under `from`.
fn is_bare(value: &Value) -> bool {
    let has = |key: &&str| value.get(key).is_some();
    ["node", "interface", "expression"].iter().any(has) && !["type", "from"].iter().any(has)
}

/// The outputs with their values, the types checked.
pub(super) fn bind<'d>(reader: &mut Reader<'d>, draft: &Draft<'d>, types: &Types) -> Vec<Output> {
    let mut bound = Vec::with_capacity(draft.outputs.len());
    for output in &draft.outputs {
        let Some(value_type) = output.value_type else { continue };
        let name = &output.member.key;
        let what = || format!("output `{}`", shortened(name));
        let value = bind_source(reader, draft, types, &output.source, value_type, false, &what);
        if let Some(value) = value {
            bound.push(Output { name: name.clone(), doc: output.doc.clone(), value_type, value });
        }
    }
    bound
}
