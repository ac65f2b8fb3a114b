//! Reading `roots`: what a phenomenon is called for.

use crate::diagnostics::synonyms;
use crate::diagnostics::{Code, Finding, is_near, listed, shortened};
use crate::document::{Member, Reader, Value, ValueKind};
use crate::graph::RootKind;

use super::draft::{Draft, DraftRoot, Source, SourceKind};
use super::keys::{PHENOMENON, ROOT};
use super::limits::MAX_SHADERS;
use super::sources;

/// Reads all roots; none at all is a finding, unless there are outputs. `graph` is the whole phenomenon.
pub(super) fn read<'d>(
    reader: &mut Reader<'d>,
    graph: &'d Value,
    value: Option<&'d Value>,
    draft: &mut Draft<'d>,
) {
    let Some(value) = value else {
        // A misspelt `roots` was reported as the unknown key it is.
        let has_outputs = graph.get("outputs").is_some();
        let misspelt = graph.members().iter().any(|member| {
            is_near(&member.key, "roots")
                || is_near(&member.key, "outputs")
                || synonyms::key(&member.key, |ours| ours == "roots").is_some()
                    && PHENOMENON.key(&member.key).is_none()
        });
        if !misspelt && !has_outputs {
            no_root(reader, graph, graph.start);
        }
        return;
    };
    let Some(members) = reader.members(value, "`roots`") else { return };
    let mut any = false;
    for member in members {
        any = true;
        let Some(kind) = RootKind::ALL.into_iter().find(|kind| kind.name() == member.key) else {
            unknown_root(reader, member);
            draft.unresolved.set(true);
            continue;
        };
        let (colors, ok) = read_root(reader, &member.value, draft);
        draft.roots.push(DraftRoot { kind, member, colors, ok });
    }
    if !any && graph.get("outputs").is_some() {
        let help = "name a root, or leave `roots` out: there are outputs";
        reader.report(Code::MISSING_ROOT, value, "`roots` is empty", help);
    } else if !any {
        no_root(reader, graph, value.start);
    }
}

fn no_root(reader: &mut Reader<'_>, graph: &Value, at: usize) {
    let place = reader.document.place_of_bytes(at, at + 1);
    let (message, help) = match std::ptr::eq(graph, &reader.document.root) {
        true => (
            "the phenomenon has no root, so nothing can ever call it",
            "add `\"roots\": { \"material\": { \"node\": … } }`",
        ),
        false => (
            "the phenomenon has no outputs and no root, so it offers nothing",
            "add `\"outputs\": { \"name\": { \"type\": …, \"from\": … } }`",
        ),
    };
    reader.findings.push(Finding::new(Code::MISSING_ROOT, place, message, help));
}

fn unknown_root(reader: &mut Reader<'_>, member: &Member) {
    let names = RootKind::ALL.map(RootKind::name);
    let advice = reader.advice(&member.key, names.into_iter(), synonyms::root(&member.key), || {
        format!("the shader types are {}", listed(names))
    });
    let message = format!("there is no shader type `{}`", shortened(&member.key));
    let place = reader.document.place_of_key(member);
    reader.findings.push(Finding::misspelt(Code::UNKNOWN_ROOT, place, message, advice));
}

/// A root's shaders and ok: either alone, or as an object of both. A list of connections is a chain of
/// shaders; a list of numbers is a color.
fn read_root<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    draft: &Draft<'d>,
) -> (Vec<Source<'d>>, Option<Source<'d>>) {
    let composite = matches!(value.kind, ValueKind::Object(_))
        && (value.get("color").is_some() || value.get("ok").is_some());
    if !composite {
        return (read_shaders(reader, value, draft), None);
    }
    let Some(object) = reader.object(value, ROOT.what, &ROOT.names()) else {
        return (Vec::new(), None);
    };
    let color = object.required(reader, "color");
    let colors = color.map(|value| read_shaders(reader, value, draft)).unwrap_or_default();
    let ok = object.optional("ok").map(|value| sources::read(reader, value, draft));
    (colors, ok)
}

fn read_shaders<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    draft: &Draft<'d>,
) -> Vec<Source<'d>> {
    let ValueKind::Array(elements) = &value.kind else {
        return vec![sources::read(reader, value, draft)];
    };
    let is_shader =
        |element: &Value| matches!(element.kind, ValueKind::Object(_) | ValueKind::Array(_));
    // A number among them makes it a color, in which no connection can stand.
    if !elements.is_empty() && !elements.iter().all(is_shader) {
        return vec![sources::read(reader, value, draft)];
    }
    if elements.is_empty() {
        let message = "a list of shaders is empty, so the root yields nothing";
        let help = "list connections such as `{ \"node\": \"name\" }`, or remove the root";
        reader.report(Code::WRONG_KIND, value, message, help);
    }
    if elements.len() > MAX_SHADERS {
        let message =
            format!("a root has {} shaders, at most {MAX_SHADERS} may be chained", elements.len());
        reader.report(Code::NUMBER_OUT_OF_RANGE, value, message, "join some of them in a node");
        return Vec::new();
    }
    elements.iter().map(|element| read_shader(reader, element, draft)).collect()
}

/// One shader of a list. A whole list returns one `ok`, so none of its shaders has one of its own.
fn read_shader<'d>(reader: &mut Reader<'d>, value: &'d Value, draft: &Draft<'d>) -> Source<'d> {
    if value.get("ok").is_some() || value.get("color").is_some() {
        let message = "a shader of a list has no `ok` of its own";
        let help = "write `{ \"color\": [ … ], \"ok\": … }` for the root as a whole";
        reader.report(Code::WRONG_KIND, value, message, help);
        return Source::new(value, SourceKind::Broken);
    }
    sources::read(reader, value, draft)
}
