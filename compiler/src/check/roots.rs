//! Reading `roots`: what a phenomenon is called for.

use crate::diagnostics::{Code, Finding};
use crate::document::{Reader, Value, ValueKind, listed};
use crate::graph::RootKind;

use super::draft::{Draft, DraftRoot, Source};
use super::sources;

/// Every shader type a root may have, as mental ray knows them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ShaderType {
    /// One the engines run.
    Run(RootKind),
    /// One that is checked only.
    Checked(&'static str),
}

impl ShaderType {
    /// Every shader type, those that are run first.
    pub const ALL: [ShaderType; 14] = [
        ShaderType::Run(RootKind::Material),
        ShaderType::Run(RootKind::Shadow),
        ShaderType::Run(RootKind::Environment),
        ShaderType::Checked("volume"),
        ShaderType::Checked("light"),
        ShaderType::Checked("lens"),
        ShaderType::Checked("texture"),
        ShaderType::Checked("displacement"),
        ShaderType::Checked("output"),
        ShaderType::Checked("photon"),
        ShaderType::Checked("contour"),
        ShaderType::Checked("lightmap"),
        ShaderType::Checked("geometry"),
        ShaderType::Checked("state"),
    ];

    /// Name in graph files.
    pub fn name(self) -> &'static str {
        match self {
            ShaderType::Run(kind) => kind.name(),
            ShaderType::Checked(name) => name,
        }
    }
}

/// Reads all roots; none at all is a finding. `graph` is the whole document.
pub(super) fn read<'d>(
    reader: &mut Reader<'d>,
    graph: &'d Value,
    value: Option<&'d Value>,
    draft: &mut Draft<'d>,
) {
    let Some(value) = value else {
        // A misspelt `roots` was reported as the unknown key it is.
        let misspelt = graph
            .members()
            .iter()
            .any(|member| crate::document::nearest(&member.key, ["roots"]).is_some());
        if !misspelt {
            no_root(reader, graph.start);
        }
        return;
    };
    let Some(members) = reader.members(value, "`roots`") else { return };
    let mut any = false;
    for member in members {
        any = true;
        let Some(kind) = ShaderType::ALL.into_iter().find(|kind| kind.name() == member.key) else {
            unknown_root(reader, member);
            draft.unresolved.set(true);
            continue;
        };
        let (color, ok) = read_root(reader, &member.value, draft);
        draft.roots.push(DraftRoot { kind, color, ok });
    }
    if !any {
        no_root(reader, value.start);
    }
}

fn no_root(reader: &mut Reader<'_>, at: usize) {
    let place = reader.document.place_of_bytes(at, at + 1);
    let message = "the phenomenon has no root, so nothing can ever call it";
    let help = "add `\"roots\": { \"material\": { \"node\": … } }`";
    reader.findings.push(Finding::new(Code::MISSING_ROOT, place, message, help));
}

fn unknown_root(reader: &mut Reader<'_>, member: &crate::document::Member) {
    let names = ShaderType::ALL.map(ShaderType::name);
    let near = crate::document::nearest(&member.key, names);
    let help = match near {
        Some(near) => near.help(),
        None => format!("the shader types are {}", listed(names)),
    };
    let message = format!("there is no shader type `{}`", crate::document::shortened(&member.key));
    let place = reader.document.place_of_key(member);
    let mut finding = Finding::new(Code::UNKNOWN_ROOT, place, message, help);
    finding.fix = near.and_then(|near| near.fix());
    reader.findings.push(finding);
}

/// A root's color and ok: either alone, or as an object of both.
fn read_root<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    draft: &Draft<'d>,
) -> (Option<Source<'d>>, Option<Source<'d>>) {
    let composite = matches!(value.kind, ValueKind::Object(_))
        && (value.get("color").is_some() || value.get("ok").is_some());
    if !composite {
        return (Some(sources::read(reader, value, draft)), None);
    }
    let Some(object) = reader.object(value, "a root", &["color", "ok"]) else {
        return (None, None);
    };
    let color = object.required(reader, "color").map(|value| sources::read(reader, value, draft));
    let ok = object.optional("ok").map(|value| sources::read(reader, value, draft));
    (color, ok)
}
