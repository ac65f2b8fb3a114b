//! Parameters as their files declare them, whatever state these are in: what values they may be given.

use lsp_types::{CompletionItem, CompletionItemKind};
use phenomenon_compiler::check::keys;
use phenomenon_compiler::document::{Document, Kind, Member, Value, ValueKind};

use super::offers::{Offers, quoted};
use super::part::{Part, text};

/// Most elements of an array that are offered one by one.
const ELEMENTS: usize = 16;
/// Most parts of parameters that are offered one by one. The file is not checked yet, and every level of arrays in it
/// has so many times the parts of the level above.
const PARTS: usize = 4096;
/// Most bytes of text that are offered with them.
const PART_BYTES: usize = 4 << 20;

/// A declaration, with the document it stands in.
#[derive(Clone, Copy)]
pub struct Declaration<'d> {
    document: &'d Document,
    value: &'d Value,
}

/// What is written where a value is due, or within one.
enum Inside<'d> {
    /// A value of that declaration.
    Value(Declaration<'d>),
    /// A member of a struct with that declaration.
    Members(Declaration<'d>),
    /// The space of a texture.
    Space,
    /// The name of a light.
    Light,
}

/// The members of the interface of a phenomenon.
fn declared(document: &Document) -> &[Member] {
    document.root.get("interface").map_or(&[], Value::members)
}

/// The parameters of a phenomenon.
pub fn parameters(document: &Document) -> Vec<Part> {
    let of =
        |member: &Member| Declaration { document, value: &member.value }.part(member.key.clone());
    declared(document).iter().map(of).collect()
}

/// The declaration of a parameter, or of a part of one: `layers[1].tint`.
pub fn declaration<'d>(document: &'d Document, name: &str) -> Option<Declaration<'d>> {
    let end = name.find(['.', '[']).unwrap_or(name.len());
    let (first, mut rest) = name.split_at(end);
    let member = declared(document).iter().find(|member| member.key == first)?;
    let mut value = &member.value;
    while !rest.is_empty() {
        if let Some(index) = rest.strip_prefix('[') {
            value = value.get("of")?;
            rest = index.split_once(']')?.1;
        } else {
            let member = rest.strip_prefix('.')?;
            let end = member.find(['.', '[']).unwrap_or(member.len());
            value = value.get("members")?.get(&member[..end])?;
            rest = &member[end..];
        }
    }
    Some(Declaration { document, value })
}

/// The parameters of a phenomenon and their parts, as they are set one by one: those that are least nested first, and
/// no more than [`PARTS`].
pub fn settable(document: &Document) -> Vec<Part> {
    let mut found = Found::default();
    for member in declared(document) {
        let declared = Declaration { document, value: &member.value };
        if !found.add(member.key.clone(), declared, member.value.get("default")) {
            break;
        }
    }
    let mut at = 0;
    while at < found.parts.len() && found.add_parts_of(at) {
        at += 1;
    }
    found.parts.into_iter().map(|(name, declared, _)| declared.part(name)).collect()
}

/// Parts of parameters by name, with their defaults.
#[derive(Default)]
struct Found<'d> {
    parts: Vec<(String, Declaration<'d>, Option<&'d Value>)>,
    bytes: usize,
}

impl<'d> Found<'d> {
    /// Adds a part, if there is room.
    fn add(&mut self, name: String, declared: Declaration<'d>, default: Option<&'d Value>) -> bool {
        self.bytes += name.len() + declared.bytes();
        let has_room = self.parts.len() < PARTS && self.bytes <= PART_BYTES;
        if has_room {
            self.parts.push((name, declared, default));
        }
        has_room
    }

    /// Adds the elements and members of a part, as far as there is room.
    fn add_parts_of(&mut self, at: usize) -> bool {
        let (name, declared, default) = &self.parts[at];
        let (name, declared, default) = (name.clone(), *declared, *default);
        if let (Some(of), Some(ValueKind::Array(elements))) =
            (declared.of(), default.map(|default| &default.kind))
        {
            for (at, element) in elements.iter().take(ELEMENTS).enumerate() {
                if !self.add(format!("{name}[{at}]"), of, Some(element)) {
                    return false;
                }
            }
        }
        for member in declared.members() {
            let inner = Declaration { value: &member.value, ..declared };
            let name = format!("{name}.{}", member.key);
            if !self.add(name, inner, member.value.get("default")) {
                return false;
            }
        }
        true
    }
}

impl<'d> Declaration<'d> {
    /// The name of its type, as far as there is one.
    fn type_name(self) -> &'d str {
        text(self.value, "type").unwrap_or_default()
    }

    fn of(self) -> Option<Self> {
        Some(Self { value: self.value.get("of")?, ..self })
    }

    fn member(self, name: &str) -> Option<Self> {
        Some(Self { value: self.value.get("members")?.get(name)?, ..self })
    }

    fn members(self) -> &'d [Member] {
        self.value.get("members").map_or(&[], Value::members)
    }

    /// As an input.
    fn part(self, name: String) -> Part {
        let doc = text(self.value, "doc").unwrap_or_default();
        let choices: Vec<String> = self.labels().map(str::to_owned).collect();
        let words = format!("One of `{}`", choices.join("`, `"));
        let doc = match (choices.is_empty(), doc.is_empty()) {
            (true, _) => doc.to_owned(),
            (false, true) => words,
            (false, false) => format!("{doc}\n\n{words}"),
        };
        Part { name, of: self.type_name().into(), doc, choices }
    }

    /// About how many bytes of text its part has, besides its name.
    fn bytes(self) -> usize {
        let doc = text(self.value, "doc").map_or(0, str::len);
        // Labels stand in the text, and among the choices.
        doc + self.labels().map(|label| 2 * label.len() + size_of::<String>()).sum::<usize>()
    }

    /// The names of an enumeration.
    fn labels(self) -> impl Iterator<Item = &'d str> {
        let values = self.value.get("values").map(|values| &values.kind);
        let elements = match values {
            Some(ValueKind::Array(elements)) => elements.as_slice(),
            _ => &[],
        };
        elements.iter().filter_map(|element| match &element.kind {
            ValueKind::String(label) => Some(label.as_str()),
            _ => None,
        })
    }

    /// What stands at a path of keys within a value for it, the indices of lists left out.
    fn inside(self, path: &[&str]) -> Option<Inside<'d>> {
        match (self.type_name(), path) {
            ("array", path) if !path.is_empty() => self.of()?.inside(path),
            (_, []) => Some(Inside::Value(self)),
            ("struct", ["struct"]) => Some(Inside::Members(self)),
            ("struct", ["struct", member, rest @ ..]) => self.member(member)?.inside(rest),
            ("texture", ["space"]) => Some(Inside::Space),
            ("light" | "lights", ["light"]) => Some(Inside::Light),
            _ => None,
        }
    }

    /// What may be written at a path of keys within a value for it; `lights` are those of the scene.
    pub fn offers(
        self,
        path: &[&str],
        at_key: bool,
        offers: Offers,
        lights: &[String],
    ) -> Vec<CompletionItem> {
        match (self.inside(path), at_key) {
            (Some(Inside::Value(declared)), false) => declared.values(offers, lights),
            (Some(Inside::Value(declared)), true) => declared.keys(offers),
            (Some(Inside::Members(declared)), true) => {
                let part = |member: &'d Member| {
                    Self { value: &member.value, ..declared }.part(member.key.clone())
                };
                offers.parts(&declared.members().iter().map(part).collect::<Vec<Part>>())
            }
            (Some(Inside::Space), false) => {
                let words = match keys::TEXTURE.key("space").map(|key| &key.kind) {
                    Some(Kind::Word(words)) => *words,
                    _ => &[],
                };
                offers.words(words.iter().copied(), CompletionItemKind::VALUE)
            }
            (Some(Inside::Light), false) => {
                offers.words(lights.iter().map(String::as_str), CompletionItemKind::REFERENCE)
            }
            _ => Vec::new(),
        }
    }

    /// Values of it: the words there are, and its default.
    fn values(self, offers: Offers, lights: &[String]) -> Vec<CompletionItem> {
        let mut items = offers.words(self.labels(), CompletionItemKind::ENUM_MEMBER);
        let light = |name: &String| format!("{{ \"light\": {} }}", quoted(name));
        let literals: Vec<String> = match self.type_name() {
            "boolean" => ["true", "false"].map(str::to_owned).to_vec(),
            "texture" => vec!["{ \"texture\": \"\" }".into(), "null".into()],
            "light" => lights.iter().map(light).collect(),
            "lights" => lights.iter().map(|name| format!("[{}]", light(name))).collect(),
            "array" => {
                let elements = self.of().map(|of| of.values(offers, lights));
                items.extend(elements.unwrap_or_default());
                Vec::new()
            }
            _ => Vec::new(),
        };
        items.extend(literals.iter().filter_map(|literal| offers.literal(literal, "")));
        let Some(default) = self.value.get("default") else { return items };
        let written = &self.document.file.text[default.start..default.end];
        let (label, item) = match &default.kind {
            ValueKind::String(word) => {
                let kind = CompletionItemKind::VALUE;
                (word.as_str(), Some(offers.word(word, kind, "its default", "")))
            }
            _ => (written, offers.literal(written, "its default")),
        };
        if !items.iter().any(|item| item.label == label) {
            items.extend(item);
        }
        items
    }

    /// Keys of the object a value of it is.
    fn keys(self, offers: Offers) -> Vec<CompletionItem> {
        match self.type_name() {
            "texture" => offers.keys(keys::TEXTURE.keys),
            "light" | "lights" => offers.words(["light"], CompletionItemKind::PROPERTY),
            "struct" => offers.words(["struct"], CompletionItemKind::PROPERTY),
            "array" => self.of().map(|of| of.keys(offers)).unwrap_or_default(),
            _ => Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use phenomenon_compiler::document::read;

    use super::*;

    #[test]
    fn parts_are_found_by_name_and_listed() {
        let text = r#"{ "interface": {
          "layers": { "type": "array", "default": [{ "struct": {} }, { "struct": {} }],
                      "of": { "type": "struct", "members": { "kind": { "type": "integer", "values": ["a", "b"], "default": "a" } } } },
          "on": { "type": "boolean", "default": true } } }"#;
        let document = read("a.json", text.as_bytes()).unwrap();
        let names: Vec<String> = settable(&document).into_iter().map(|part| part.name).collect();
        let wanted = ["layers", "on", "layers[0]", "layers[1]", "layers[0].kind", "layers[1].kind"];
        assert_eq!(names, wanted);
        for name in wanted {
            assert!(declaration(&document, name).is_some(), "{name}");
        }
        for name in ["", "lay", "layers[", "layers[0", "layers[0].", "layers.kind", "on[0]", ".on"]
        {
            assert!(declaration(&document, name).is_none(), "{name}");
        }
        let labels = |name: &str, path: &[&str], in_string: bool| -> Vec<String> {
            let declared = declaration(&document, name).unwrap();
            let items = declared.offers(path, false, Offers { in_string }, &[]);
            items.into_iter().map(|item| item.label).collect()
        };
        assert_eq!(labels("layers[1].kind", &[], true), ["a", "b"]);
        assert_eq!(labels("layers", &["struct", "kind"], false), ["a", "b"]);
        assert_eq!(labels("on", &[], false), ["true", "false"]);
        assert!(labels("on", &[], true).is_empty(), "a string is no boolean");
        assert!(labels("on", &["x"], false).is_empty());
    }

    #[test]
    fn an_enumeration_without_a_doc_is_told_by_its_words() {
        let doc = |more: &str| {
            let text = format!(
                r#"{{ "interface": {{ "mode": {{ "type": "integer", "values": ["a", "b"]{more} }} }} }}"#
            );
            parameters(&read("a.json", text.as_bytes()).unwrap()).remove(0).doc
        };
        assert_eq!(doc(""), "One of `a`, `b`");
        assert_eq!(doc(r#", "doc": "how""#), "how\n\nOne of `a`, `b`");
    }

    #[test]
    fn parts_that_multiply_are_bounded() {
        // Sixteen to the power of six elements.
        let elements = vec![r#"{ "struct": {} }"#; ELEMENTS].join(", ");
        let mut declared = r#"{ "type": "scalar", "default": 0 }"#.to_owned();
        for _ in 0..6 {
            declared = format!(
                r#"{{ "type": "array", "default": [{elements}], "of": {{ "type": "struct", "members": {{ "m": {declared} }} }} }}"#
            );
        }
        let text = format!(
            r#"{{ "interface": {{ "a": {declared}, "b": {{ "type": "scalar", "default": 0 }} }} }}"#
        );
        let parts = settable(&read("a.json", text.as_bytes()).unwrap());
        assert_eq!(parts.len(), PARTS);
        let names: Vec<&str> = parts[..3].iter().map(|part| &*part.name).collect();
        assert_eq!(names, ["a", "b", "a[0]"], "the least nested come first");
        // Few parts, but each with a long text.
        let doc = "d".repeat(PART_BYTES / 4);
        let element = format!(r#"{{ "type": "scalar", "doc": "{doc}" }}"#);
        let zeros = ["0"; ELEMENTS].join(", ");
        let text = format!(
            r#"{{ "interface": {{ "a": {{ "type": "array", "default": [{zeros}], "of": {element} }} }} }}"#
        );
        let names: Vec<String> = settable(&read("a.json", text.as_bytes()).unwrap())
            .into_iter()
            .map(|part| part.name)
            .collect();
        assert_eq!(names, ["a", "a[0]", "a[1]", "a[2]"]);
    }
}
