//! `presets`: values of parameters under names, checked as a scene's `set` is.

use crate::document::{Reader, Value};
use crate::graph::{Graph, Preset};

use super::files::Files;
use super::names::check_key;
use super::settings::{Setting, bind_settings};

/// Reads the presets of a phenomenon of which the parameters are known.
pub(super) fn read<'d>(
    reader: &mut Reader<'d>,
    value: Option<&'d Value>,
    graph: &Graph,
    files: &dyn Files,
) -> Vec<Preset> {
    let mut presets = Vec::new();
    let members = value.and_then(|value| reader.members(value, "`presets`"));
    for member in members.into_iter().flatten() {
        check_key(reader, member, "the name of a preset");
        let what = format!("preset `{}`", crate::diagnostics::shortened(&member.key));
        let Some(given) = reader.members(&member.value, &what) else { continue };
        let set: Vec<Setting> = given.map(|it| Setting::new(reader.document, it)).collect();
        let (values, findings) = bind_settings(graph, &set, files);
        findings.into_iter().for_each(|finding| reader.findings.push(finding));
        presets.push(Preset { name: member.key.clone(), values });
    }
    presets
}
