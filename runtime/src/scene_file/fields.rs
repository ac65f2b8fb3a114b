//! What several parts of a scene file have: vectors, paths, graphs with their settings.

use std::path::{Path, PathBuf};

use phenomenon_compiler::check::{Setting, read_color, space_of};
use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::document::{Object, Reader, Section, Value, ValueKind};

use super::description::{MaterialRef, MaterialSource, PresetRef};
use super::key_kinds::{COORDINATES, LIGHT};

/// A point, direction or the like.
pub(super) fn vector<'d>(
    reader: &mut Reader<'d>,
    object: &Object<'d>,
    key: &str,
) -> Option<[f64; 3]> {
    let value = object.required(reader, key)?;
    reader.numbers(value, &format!("`{key}` of {}", object.what), COORDINATES)
}

/// A colour of light: three numbers, or a colour in a named space.
pub(super) fn color<'d>(reader: &mut Reader<'d>, value: &'d Value, what: &str) -> Option<[f64; 3]> {
    let space = match value.kind {
        ValueKind::Object(_) => space_of(value),
        _ => None,
    };
    let Some(space) = space else { return reader.numbers(value, what, LIGHT) };
    let [r, g, b, alpha] = read_color(reader, value, space)?.map(f64::from);
    if alpha != 1.0 {
        let message = format!("{what} has an alpha, and light has none");
        reader.report(Code::BAD_COLOR, value, message, "leave the fourth component out");
        return None;
    }
    let color = [r, g, b];
    let [r, g, b] = color.map(|x| x as f32);
    if !color.iter().all(|x| LIGHT.contains(x)) {
        let message =
            format!("{what} is {r}, {g}, {b} in linear Rec. 709, where light is 0 to 1e12");
        let help = "give a colour that Rec. 709 has: a component below 0 lies outside of it";
        reader.report(Code::NUMBER_OUT_OF_RANGE, value, message, help);
        return None;
    }
    Some(color)
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
