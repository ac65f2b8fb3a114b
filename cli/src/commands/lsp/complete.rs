//! What can be written where the cursor stands.

use lsp_types::{CompletionItem, CompletionItemKind};
use phenomenon_compiler::check::keys;
use phenomenon_compiler::document::{Kind, Member, Value, ValueKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::values::Type;

use super::cursor::Cursor;
use super::expression::Names;
use super::file::OpenFile;
use super::keys::{Spot, spot};
use super::offers::Offers;
use super::open_files::OpenFiles;
use super::parameters::{Declaration, declaration, settable};
use super::part::{Part, text};
use super::parts::{parts_of, phenomenon, phenomenon_of};
use super::paths;
use super::scope::Scope;
use crate::ours::Ours;

/// Completions at a byte of the file.
pub fn complete(
    file: &OpenFile,
    at: usize,
    library: &NodeLibrary,
    files: &OpenFiles,
) -> Vec<CompletionItem> {
    let cursor = Cursor::after(&file.text()[..at]);
    let path: Vec<&str> = cursor.path.iter().map(String::as_str).collect();
    let offers = Offers { in_string: cursor.written.is_some() };
    let (scope, inner) = Scope::of(file, &path);
    let place = Place { file, scope, cursor: &cursor, library, files, offers };
    if let (Some(_), false, Some(written), Some(key)) =
        (file.ours, cursor.at_key, &cursor.written, path.last())
        && let Some(endings) = paths::endings(key)
    {
        return paths::complete(file, at, written, endings);
    }
    match file.ours {
        Some(Ours::Scene) => place.in_scene(&path),
        Some(_) if path.last() == Some(&"expression") && !cursor.at_key => {
            let Some(written) = &cursor.written else { return Vec::new() };
            Names { scope: &place.scope, library, files }.complete(inner, written)
        }
        Some(_) if cursor.at_key => place.key(inner),
        Some(_) => place.value(inner),
        None => Vec::new(),
    }
}

/// Where the cursor stands, and what is known there.
struct Place<'p> {
    file: &'p OpenFile,
    scope: Scope<'p>,
    cursor: &'p Cursor,
    library: &'p NodeLibrary,
    files: &'p OpenFiles,
    offers: Offers,
}

impl Place<'_> {
    /// Keys at a path of a graph.
    fn key(&self, path: &[&str]) -> Vec<CompletionItem> {
        let offers = self.offers;
        match path {
            [] if self.scope.depth > 0 => offers.keys(keys::INNER.keys),
            [] => offers.keys(keys::PHENOMENON.keys),
            ["outputs", _] => offers.keys(keys::OUTPUT.keys),
            ["outputs", _, "from", ..] => offers.keys(keys::CONNECTION.keys),
            ["presets", _] => offers.parts(&self.own_parameters()),
            ["requires"] => offers.keys(keys::REQUIRES.keys),
            ["nodes", _] => offers.keys(keys::NODE.keys),
            ["interface", place @ ..] if is_declaration(place) => {
                let of = self.cursor.siblings.get("type").map(String::as_str);
                let has_values = self.cursor.siblings.contains_key("values");
                offers.keys(keys::of_declaration(of, has_values))
            }
            ["roots"] => offers.keys(keys::ROOTS.keys),
            ["roots", _] => offers.keys(keys::CONNECTION.keys.iter().chain(keys::ROOT.keys)),
            ["nodes", name, "inputs"] => {
                let parts =
                    parts_of(&self.scope, name, self.written_type(), self.library, self.files);
                offers.parts(&parts.map(|parts| parts.inputs).unwrap_or_default())
            }
            ["nodes", name, "inputs", input, inner @ ..] => {
                let mut items = self.nested(name, input, inner);
                items.extend(offers.keys(keys::CONNECTION.keys));
                items
            }
            _ => Vec::new(),
        }
    }

    /// Values at a path of a graph.
    fn value(&self, path: &[&str]) -> Vec<CompletionItem> {
        let offers = self.offers;
        match path {
            ["requires", key] => words_of(keys::REQUIRES.key(key).map(|key| &key.kind), offers),
            ["interface", place @ .., "type"] if is_declaration(place) => {
                let words = keys::declared_types().iter().copied();
                offers.words(words, CompletionItemKind::PROPERTY)
            }
            ["nodes", _, "type", "phenomenon"] => {
                offers.words(self.scope.inner_names(), CompletionItemKind::CLASS)
            }
            ["outputs", _, "type"] => words_of(keys::OUTPUT.key("type").map(|it| &it.kind), offers),
            ["nodes", _, "type"] => {
                let signatures = self.library.iter().map(|(_, definition)| &definition.signature);
                let kind = CompletionItemKind::CLASS;
                signatures.map(|it| offers.word(&it.name, kind, it.group, &it.doc)).collect()
            }
            ["nodes" | "roots" | "outputs", .., "node"] => {
                let of =
                    |member: &Member| text(&member.value, "type").unwrap_or_default().to_owned();
                self.members("nodes", |member| (of(member), String::new()))
            }
            ["nodes" | "roots" | "outputs", .., "output"] => {
                let node = self.cursor.siblings.get("node").map(String::as_str).unwrap_or_default();
                let parts = parts_of(&self.scope, node, None, self.library, self.files);
                offers.parts(&parts.map(|parts| parts.outputs).unwrap_or_default())
            }
            ["nodes" | "roots" | "outputs", .., "interface"] => {
                let said = |member: &Member, key: &str| {
                    text(&member.value, key).unwrap_or_default().to_owned()
                };
                self.members("interface", |member| (said(member, "type"), said(member, "doc")))
            }
            ["nodes", name, "inputs", input, inner @ ..] => {
                let nested = self.nested(name, input, inner);
                if nested.is_empty() { self.of_library(name, input) } else { nested }
            }
            _ => Vec::new(),
        }
    }

    /// What may be given to an input of a node of the library, besides numbers and connections.
    fn of_library(&self, node: &str, input: &str) -> Vec<CompletionItem> {
        let parts = parts_of(&self.scope, node, self.written_type(), self.library, self.files);
        let inputs = parts.map(|parts| parts.inputs).unwrap_or_default();
        let Some(part) = inputs.iter().find(|part| part.name == input) else { return Vec::new() };
        let is_boolean = part.of == Type::Boolean.name();
        let truth = is_boolean.then_some(&Kind::Boolean);
        let choices = part.choices.iter().map(String::as_str);
        let mut items = self.offers.words(choices, CompletionItemKind::ENUM_MEMBER);
        items.extend(words_of(truth, self.offers));
        items
    }

    /// The type of the node the cursor is in, as it stands before the cursor.
    fn written_type(&self) -> Option<&str> {
        self.cursor.around.get(2 + 2 * self.scope.depth)?.get("type").map(String::as_str)
    }

    /// The parameters of the phenomenon, and their parts.
    fn own_parameters(&self) -> Vec<Part> {
        self.file.document.as_ref().map(settable).unwrap_or_default()
    }

    /// Nodes or parameters of the phenomenon, with what `told` has to say of them: in few words, and in many.
    fn members(
        &self,
        section: &str,
        told: impl Fn(&Member) -> (String, String),
    ) -> Vec<CompletionItem> {
        let item = |member: &Member| {
            let (detail, doc) = told(member);
            self.offers.word(&member.key, CompletionItemKind::VARIABLE, &detail, &doc)
        };
        self.scope.members(section).iter().map(item).collect()
    }

    /// What may be given to a parameter of a phenomenon that is used as a node, at a path of keys within the value.
    fn nested(&self, node: &str, input: &str, inner: &[&str]) -> Vec<CompletionItem> {
        // A file that is written after `type` stands in an object of its own, which ended before the cursor.
        if self.written_type().is_some() {
            return Vec::new();
        }
        let Some(document) = phenomenon_of(&self.scope, node, self.files) else {
            return Vec::new();
        };
        let declared = declaration(&document, input);
        let offers = |declared: Declaration<'_>| {
            declared.offers(inner, self.cursor.at_key, self.offers, &[])
        };
        declared.map(offers).unwrap_or_default()
    }

    /// Completions in a scene: its keys, the words they take, and the parameters of the graphs it uses.
    fn in_scene(&self, path: &[&str]) -> Vec<CompletionItem> {
        let (offers, at_key) = (self.offers, self.cursor.at_key);
        if let Some(at) = path.iter().position(|key| *key == "set")
            && let Some(Spot::Settings) = spot(&path[..=at])
        {
            return self.in_set(&path[at + 1..]);
        }
        match (spot(path), at_key) {
            (Some(Spot::Section(section)), true) => offers.keys(section.keys),
            (Some(Spot::Value(key)), false) => words_of(Some(&key.kind), offers),
            _ => Vec::new(),
        }
    }

    /// Completions in a `set`, at a path of keys below it.
    fn in_set(&self, path: &[&str]) -> Vec<CompletionItem> {
        // The graph is named in the object that has the `set`, which is the outermost with a file.
        let graph = self.cursor.around.iter().find_map(|object| object.get("file"));
        let document = graph.and_then(|graph| phenomenon(self.file, graph, self.files));
        let Some(document) = document else { return Vec::new() };
        let [name, inner @ ..] = path else {
            return match self.cursor.at_key {
                true => self.offers.parts(&settable(&document)),
                false => Vec::new(),
            };
        };
        let declared = declaration(&document, name);
        let lights = light_names(self.file);
        let offers = |declared: Declaration<'_>| {
            declared.offers(inner, self.cursor.at_key, self.offers, &lights)
        };
        declared.map(offers).unwrap_or_default()
    }
}

/// The words a key takes.
fn words_of(kind: Option<&Kind>, offers: Offers) -> Vec<CompletionItem> {
    match kind {
        Some(Kind::Word(words) | Kind::Set(Kind::Word(words), _)) => {
            offers.words(words.iter().copied(), CompletionItemKind::VALUE)
        }
        Some(Kind::Boolean) => {
            ["true", "false"].iter().filter_map(|word| offers.literal(word, "")).collect()
        }
        Some(Kind::True) => offers.literal("true", "").into_iter().collect(),
        _ => Vec::new(),
    }
}

/// The names of the lights of a scene.
fn light_names(file: &OpenFile) -> Vec<String> {
    let lights = file.document.as_ref().and_then(|document| document.root.get("lights"));
    let elements = match lights.map(|lights| &lights.kind) {
        Some(ValueKind::Array(elements)) => elements.as_slice(),
        _ => &[],
    };
    let name = |light: &Value| text(light, "name").map(str::to_owned);
    elements.iter().filter_map(name).collect()
}

/// Whether a place below `interface` is that of a declaration: of a parameter, of an element, or of a member. It is read
/// from the front, as parameters and members may themselves be called `of` and `members`.
fn is_declaration(place: &[&str]) -> bool {
    let [_, inner @ ..] = place else { return false };
    let mut inner = inner;
    loop {
        inner = match inner {
            [] => return true,
            ["of", inner @ ..] | ["members", _, inner @ ..] => inner,
            _ => return false,
        };
    }
}
