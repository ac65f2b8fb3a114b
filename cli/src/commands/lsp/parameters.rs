//! Parameters as their files declare them, whatever state these are in: what values they may be given.

use lsp_types::{CompletionItem, CompletionItemKind};
use phenomenon_compiler::check::keys;
use phenomenon_compiler::document::{Document, Kind, Member, Value, ValueKind};

use super::offers::{Offers, quoted};
use super::part::{Part, text};

/// Most elements of an array that are offered one by one.
const ELEMENTS: usize = 16;

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

/// The parameters of a phenomenon and their parts, as they are set one by one.
pub fn settable(document: &Document) -> Vec<Part> {
    let mut parts = Vec::new();
    for member in declared(document) {
        let declared = Declaration { document, value: &member.value };
        declared.add_parts(member.key.clone(), declared.value.get("default"), &mut parts);
    }
    parts
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
        let doc = match choices.is_empty() {
            true => doc.to_owned(),
            false => format!("{doc}\n\nOne of `{}`", choices.join("`, `")),
        };
        Part { name, of: self.type_name().into(), doc, choices }
    }

    fn add_parts(self, name: String, default: Option<&Value>, parts: &mut Vec<Part>) {
        parts.push(self.part(name.clone()));
        let default = default.map(|default| &default.kind);
        if let (Some(of), Some(ValueKind::Array(elements))) = (self.of(), default) {
            for (at, element) in elements.iter().take(ELEMENTS).enumerate() {
                of.add_parts(format!("{name}[{at}]"), Some(element), parts);
            }
        }
        for member in self.members() {
            let inner = Self { value: &member.value, ..self };
            inner.add_parts(format!("{name}.{}", member.key), member.value.get("default"), parts);
        }
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
        let wanted = ["layers", "layers[0]", "layers[0].kind", "layers[1]", "layers[1].kind", "on"];
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
}
