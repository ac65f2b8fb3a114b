//! What several parts of a scene file have: vectors, paths, graphs with their settings.

use std::path::{Path, PathBuf};

use phenomenon_compiler::check::Setting;
use phenomenon_compiler::document::{Object, Reader, Section, Value};

use super::description::{MaterialRef, MaterialSource, PresetRef};
use super::keys::COORDINATES;

/// A point, direction or the like.
pub(super) fn vector<'d>(
    reader: &mut Reader<'d>,
    object: &Object<'d>,
    key: &str,
) -> Option<[f64; 3]> {
    let value = object.required(reader, key)?;
    reader.numbers(value, &format!("`{key}` of {}", object.what), COORDINATES)
}

/// An object with the keys of a section, or a finding.
pub(super) fn section<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    section: &Section,
) -> Option<Object<'d>> {
    reader.object(value, section.what, &section.names())
}

/// The graph file named at `file`, with the `preset` and the `set` of the object round it.
pub(super) fn graph_file<'d>(
    reader: &mut Reader<'d>,
    object: &Object<'d>,
    file: &'d Value,
    what: &str,
    folder: &Path,
) -> Option<MaterialRef> {
    let source = file_path(reader, file, what, folder).map(MaterialSource::File);
    let (preset, set) = (preset(reader, object), settings(reader, object));
    let place = reader.document.place(file);
    Some(MaterialRef { source: source?, preset: preset?, set: set?, place, change: None })
}

/// The preset; only the graph can tell whether it has one. The outer is none where it is no string.
pub(super) fn preset<'d>(
    reader: &mut Reader<'d>,
    object: &Object<'d>,
) -> Option<Option<PresetRef>> {
    let Some(value) = object.optional("preset") else { return Some(None) };
    let name = reader.string(value, "`preset`")?.to_owned();
    Some(Some(PresetRef { name, place: reader.document.place(value) }))
}

/// The members of `set`; what they may be only the graph can tell. None where it is no object.
pub(super) fn settings<'d>(reader: &mut Reader<'d>, object: &Object<'d>) -> Option<Vec<Setting>> {
    let Some(value) = object.optional("set") else { return Some(Vec::new()) };
    let members = reader.members(value, "`set`")?;
    Some(members.map(|member| Setting::new(reader.document, member)).collect())
}

/// A path, which starts at the scene's folder.
pub(super) fn file_path<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    what: &str,
    folder: &Path,
) -> Option<PathBuf> {
    reader.string(value, what).map(|path| folder.join(path))
}
