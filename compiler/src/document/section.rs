//! What is known about the keys of a file: from it come the schema, the reference page, the lists of keys the reader
//! knows, and completion in editors. Each format has a table of its sections.

use std::ops::RangeInclusive;

use crate::diagnostics::grouped;

/// An object of a file, with the keys it may have.
#[derive(Debug)]
pub struct Section {
    /// A word for it: `camera`.
    pub name: &'static str,
    /// What findings call it: "the camera".
    pub what: &'static str,
    /// Its keys, in the order of the reference page.
    pub keys: &'static [Key],
    /// Keys of which exactly one is given; empty where there is no such choice.
    pub one_of: &'static [&'static str],
}

/// A key of an object.
#[derive(Debug)]
pub struct Key {
    /// The key.
    pub name: &'static str,
    /// What its value is.
    pub kind: Kind,
    /// The values of the key `type` that it goes with; empty where it goes with all, or there is no such key.
    pub only: &'static [&'static str],
    /// Whether it must be given, and what holds where it is not.
    pub given: Given,
    /// The unit of its numbers; empty where there is none.
    pub unit: &'static str,
    /// What it means, in Markdown, without a full stop.
    pub doc: &'static str,
}

/// Endings of graphs.
pub const GRAPH_FILES: &[&str] = &["json"];
/// Endings of pictures.
pub const PICTURE_FILES: &[&str] = &["png", "jpg", "jpeg", "exr", "hdr"];
/// Endings of meshes.
pub const MESH_FILES: &[&str] = &["obj"];

/// Whether a key must be given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Given {
    /// It must.
    Required,
    /// It must, but where the key `type` is one of these.
    RequiredBut(&'static [&'static str]),
    /// It is one of the keys of which exactly one is given.
    Choice,
    /// Nothing holds where it is not given.
    Optional,
    /// This JSON text holds where it is not given.
    Default(&'static str),
}

/// What the value of a key is.
#[derive(Debug)]
pub enum Kind {
    /// Any string.
    Text,
    /// The path of a file with one of these endings, from the folder of the file that names it.
    File(&'static [&'static str]),
    /// One of a few words.
    Word(&'static [&'static str]),
    /// A name: letters, digits, `_` and `-`.
    Name,
    /// `true` and nothing else.
    True,
    /// `true` or `false`.
    Boolean,
    /// A whole number.
    Whole(RangeInclusive<i128>),
    /// A number.
    Number(RangeInclusive<f64>),
    /// So many values of one kind in a list.
    Several(&'static Kind, RangeInclusive<usize>),
    /// So many values of one kind in a list, each once.
    Set(&'static Kind, RangeInclusive<usize>),
    /// One of two kinds.
    Either(&'static Kind, &'static Kind),
    /// An object with known keys.
    Object(&'static Section),
    /// A list of objects with known keys.
    Objects(&'static Section),
    /// Objects with known keys, by names of the author's.
    Named(&'static Section),
    /// A list of names, each once.
    Labels,
    /// A value in graphs, described as `text`; `definition` is what the schema calls it.
    Value {
        /// What it is, in Markdown.
        text: &'static str,
        /// Its definition in the schema.
        definition: &'static str,
    },
    /// Values of a graph's parameters, by name.
    Settings,
    /// Such values, by names of the author's.
    Presets,
    /// Anything.
    Anything,
}

impl Section {
    /// The names of its keys.
    pub fn names(&self) -> Vec<&'static str> {
        self.keys.iter().map(|key| key.name).collect()
    }

    /// The key of that name.
    pub fn key(&self, name: &str) -> Option<&'static Key> {
        self.keys.iter().find(|key| key.name == name)
    }

    /// Its keys where the key `type` is `of`.
    pub fn keys_of(&self, of: &str) -> impl Iterator<Item = &'static Key> {
        self.keys.iter().filter(move |key| key.only.is_empty() || key.only.contains(&of))
    }

    /// It and all sections below it, each once and before those it holds.
    pub fn all(&'static self) -> Vec<&'static Section> {
        let mut all = vec![self];
        let mut at = 0;
        while let Some(section) = all.get(at) {
            for inner in section.keys.iter().filter_map(|key| key.kind.section()) {
                // A section may hold itself.
                if !all.iter().any(|known| known.name == inner.name) {
                    all.push(inner);
                }
            }
            at += 1;
        }
        all
    }
}

/// The names of the keys of a section, for readers that look at many objects.
pub const fn names_of<const N: usize>(section: &Section) -> [&'static str; N] {
    let mut names = [""; N];
    let mut at = 0;
    while at < N {
        names[at] = section.keys[at].name;
        at += 1;
    }
    assert!(section.keys.len() == N);
    names
}

impl Kind {
    /// The section of an object, or of the objects of a list.
    pub fn section(&self) -> Option<&'static Section> {
        match self {
            Kind::Object(section) | Kind::Objects(section) | Kind::Named(section) => Some(section),
            _ => None,
        }
    }

    /// What it is, in Markdown: "three numbers".
    pub fn described(&self) -> String {
        match self {
            Kind::Text => "string".into(),
            Kind::File(_) => "path of a file".into(),
            Kind::Name => "name".into(),
            Kind::Word(words) => words_or(words),
            Kind::Set(Kind::Word(words), _) => format!("list of {}, each once", words_or(words)),
            Kind::True => "`true`".into(),
            Kind::Boolean => "`true` or `false`".into(),
            Kind::Whole(_) => "whole number".into(),
            Kind::Number(_) => "number".into(),
            Kind::Several(of, count) => format!("{} {}s", counts(count), of.described()),
            Kind::Set(of, count) => format!("{} {}s, each once", counts(count), of.described()),
            Kind::Either(one, other) => format!("{}, or {}", one.described(), other.described()),
            Kind::Object(_) => "object".into(),
            Kind::Objects(_) => "list of objects".into(),
            Kind::Named(_) => "objects by name".into(),
            Kind::Labels => "list of strings".into(),
            Kind::Value { text, .. } => (*text).into(),
            Kind::Settings => "values by name".into(),
            Kind::Presets => "values by name, by name".into(),
            Kind::Anything => "anything".into(),
        }
    }

    /// The range of its numbers as text; empty where it has none.
    pub fn range(&self) -> String {
        match self {
            Kind::Whole(range) => {
                format!("{} to {}", grouped(*range.start()), grouped(*range.end()))
            }
            Kind::Number(range) => {
                format!("{} to {}", number(*range.start()), number(*range.end()))
            }
            Kind::Several(of, _) | Kind::Set(of, _) => of.range(),
            Kind::Either(one, other) => match (one.range(), other.range()) {
                (one, other) if one == other || one.is_empty() => other,
                (one, other) => format!("{one}, or {other}"),
            },
            _ => String::new(),
        }
    }
}

/// Words between quotes, as a choice.
fn words_or(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("`\"{word}\"`")).collect();
    match quoted.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
        _ => quoted.concat(),
    }
}

fn counts(count: &RangeInclusive<usize>) -> String {
    match (count.start(), count.end()) {
        (least, most) if least == most => counted(*most),
        (least, most) => format!("{} to {}", counted(*least), counted(*most)),
    }
}

fn counted(count: usize) -> String {
    match count {
        1 => "one".into(),
        2 => "two".into(),
        3 => "three".into(),
        12 => "twelve".into(),
        other => other.to_string(),
    }
}

/// A number as short as it can be written.
fn number(number: f64) -> String {
    let (plain, short) = (number.to_string(), format!("{number:e}"));
    if short.len() < plain.len() { short } else { plain }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!([-1e12, 0.001, 179.0].map(number), ["-1e12", "1e-3", "179"]);
    }

    #[test]
    fn kinds_are_described() {
        let kind = Kind::Either(&Kind::Whole(0..=5), &Kind::Several(&Kind::Whole(0..=9), 1..=3));
        assert_eq!(kind.described(), "whole number, or one to three whole numbers");
        assert_eq!(kind.range(), "0 to 5, or 0 to 9");
        let words = Kind::Set(&Kind::Word(&["a", "b", "c"]), 1..=3);
        assert_eq!(words.described(), "list of `\"a\"`, `\"b\"` or `\"c\"`, each once");
        let numbers = Kind::Set(&Kind::Whole(1..=2), 1..=2);
        assert_eq!(numbers.described(), "one to two whole numbers, each once");
        assert_eq!(numbers.range(), "1 to 2");
    }
}
