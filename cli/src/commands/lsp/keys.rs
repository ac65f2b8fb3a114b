//! What there is to say about the keys of files, from the tables their readers know them by.

use phenomenon_compiler::diagnostics::listed;
use phenomenon_compiler::document::{Given, Key, Kind, Section};
use phenomenon_runtime::scene_file::SCENE;

/// What stands at a path of the keys of a scene, the indices of lists left out.
#[derive(Debug)]
pub enum Spot {
    /// An object with these keys.
    Section(&'static Section),
    /// The value of a key.
    Value(&'static Key),
    /// The values for the parameters of a graph.
    Settings,
}

/// What stands at a path; none where nothing does.
pub fn spot(path: &[&str]) -> Option<Spot> {
    let mut section = &SCENE;
    for (at, name) in path.iter().enumerate() {
        let key = section.key(name)?;
        let is_last = at + 1 == path.len();
        match &key.kind {
            Kind::Settings if is_last => return Some(Spot::Settings),
            kind => match kind.section() {
                Some(inner) => section = inner,
                None if is_last => return Some(Spot::Value(key)),
                None => return None,
            },
        }
    }
    Some(Spot::Section(section))
}

/// The key at a path.
pub fn key(path: &[&str]) -> Option<&'static Key> {
    let (name, above) = path.split_last()?;
    match spot(above)? {
        Spot::Section(section) => section.key(name),
        Spot::Value(_) | Spot::Settings => None,
    }
}

/// What a key takes, in a few words.
pub fn detail(key: &Key) -> String {
    let mut parts = vec![key.kind.described()];
    if !key.unit.is_empty() {
        parts.push(key.unit.into());
    }
    match key.kind.range() {
        range if range.is_empty() => {}
        range => parts.push(range),
    }
    parts.join(", ")
}

/// What a key means, and what holds without it.
pub fn doc(key: &Key) -> String {
    match key.given {
        Given::Required => format!("{}.\n\nIt must be given.", key.doc),
        Given::RequiredBut(types) => {
            format!("{}.\n\nIt must be given, but of {}.", key.doc, listed(types.iter().copied()))
        }
        Given::Choice => format!("{}.\n\nOne such key must be given.", key.doc),
        Given::Optional => format!("{}.", key.doc),
        Given::Default(default) => format!("{}.\n\nDefault: `{default}`", key.doc),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_lead_to_keys() {
        let key = key(&["objects", "sphere", "radius"]).unwrap();
        assert_eq!(detail(key), "number, scene units, 1e-12 to 1e12");
        assert!(doc(key).ends_with("It must be given."));
        assert!(matches!(spot(&["camera"]), Some(Spot::Section(it)) if it.name == "camera"));
        assert!(matches!(spot(&["objects", "material", "set"]), Some(Spot::Settings)));
        assert!(
            matches!(spot(&["objects", "normals"]), Some(Spot::Value(it)) if it.name == "normals")
        );
        for nowhere in [&["camra"][..], &["doc", "x"], &["objects", "material", "set", "x"]] {
            assert!(spot(nowhere).is_none(), "{nowhere:?}");
        }
        assert!(super::key(&[]).is_none());
    }
}
