//! Within the text of an expression: what can be written there, and what its names are.

use lsp_types::{CompletionItem, CompletionItemKind};
use phenomenon_compiler::check::{CONSTANTS, FUNCTIONS, is_function};
use phenomenon_compiler::document::{Document, Member, Role, Value, Word, words, words_in};
use phenomenon_compiler::nodes::{NodeLibrary, Signature};

use super::offers::Offers;
use super::open_files::OpenFiles;
use super::part::{Part, text};
use super::parts::{of_library, parts_of};
use super::scope::Scope;
use super::told::{of_input, of_node, parameter};

/// What names in an expression may stand for.
pub struct Names<'n> {
    /// The phenomenon it stands in.
    pub scope: &'n Scope<'n>,
    /// The nodes there are.
    pub library: &'n NodeLibrary,
    /// The files that are open.
    pub files: &'n OpenFiles,
}

/// Components, and what is made of several.
const COMPONENTS: [(&str, &str); 9] = [
    ("x", "scalar"),
    ("y", "scalar"),
    ("z", "scalar"),
    ("r", "scalar"),
    ("g", "scalar"),
    ("b", "scalar"),
    ("a", "scalar"),
    ("xyz", "vector"),
    ("rgb", "color"),
];

impl Names<'_> {
    /// What can be written behind a beginning of a text, at a path of keys of the phenomenon.
    pub fn complete(&self, path: &[&str], written: &str) -> Vec<CompletionItem> {
        let found = words(written);
        // A word is begun where the cursor touches its end; a letter more makes one of what ends otherwise.
        let begun = found.last().filter(|word| word.span.end == written.len());
        let started = words(&format!("{written}_"));
        let role = begun.or(started.last()).map(|word| &word.role);
        match role {
            Some(Role::Member { of }) => self.members(of.as_deref(), path),
            _ => {
                let before = begun.map_or(written, |word| &written[..word.span.start]);
                self.values(path, open_call(before).as_deref())
            }
        }
    }

    fn values(&self, path: &[&str], call: Option<&str>) -> Vec<CompletionItem> {
        let offers = Offers { in_string: true };
        let mut items = Vec::new();
        if let Some(parts) = call.and_then(|call| of_library(node_of(call), self.library)) {
            items.extend(parts.inputs.iter().map(|input| CompletionItem {
                insert_text: Some(format!("{}: ", input.name)),
                ..offers.word(&input.name, CompletionItemKind::FIELD, &input.of, &input.doc)
            }));
        }
        let variable = CompletionItemKind::VARIABLE;
        for member in self.bound(path) {
            items.push(offers.word(&member.key, variable, "where", &told_bound(member)));
        }
        for member in self.scope.members("interface") {
            let of = text(&member.value, "type").unwrap_or_default();
            let doc = text(&member.value, "doc").unwrap_or_default();
            items.push(offers.word(&member.key, variable, of, doc));
        }
        for member in self.scope.members("nodes") {
            let parts = self.node(&member.key);
            let of = parts.map_or(String::new(), |parts| of_first(&parts.outputs));
            items.push(offers.word(&member.key, variable, &of, ""));
        }
        let constant = CompletionItemKind::CONSTANT;
        items.extend(CONSTANTS.iter().map(|(name, value)| offers.word(name, constant, value, "")));
        items.extend(offers.words(["true", "false"], CompletionItemKind::KEYWORD));
        for function in FUNCTIONS {
            let Some(node) = self.library.find(function.node) else { continue };
            let signature = self.library.signature(node);
            items.push(call_of(function.name, signature, Some(function.order)));
        }
        for (_, definition) in self.library.iter() {
            let signature = &definition.signature;
            let is_known = FUNCTIONS.iter().any(|function| *function.name == *signature.name);
            if is_function(signature) && !is_known {
                items.push(call_of(&signature.name, signature, None));
            }
        }
        items
    }

    /// What may stand behind the `.` of a name, or of a value that is none.
    fn members(&self, of: Option<&str>, path: &[&str]) -> Vec<CompletionItem> {
        let offers = Offers { in_string: true };
        let field = CompletionItemKind::FIELD;
        let components = |of: &str| -> Vec<CompletionItem> {
            let suits = |name: &str| match of {
                "vector" => name.chars().all(|c| "xyz".contains(c)) || name == "rgb",
                "color" => name.chars().all(|c| "rgba".contains(c)) || name == "xyz",
                _ => !matches!(of, "scalar" | "integer" | "boolean" | "transform" | "string"),
            };
            let suiting = COMPONENTS.iter().filter(|(name, _)| suits(name));
            suiting.map(|(name, made)| offers.word(name, field, made, "")).collect()
        };
        let Some(of) = of else { return components("") };
        if self.bound(path).iter().any(|member| member.key == of) {
            return components("");
        }
        if let Some(parts) = self.node(of) {
            let mut items = offers.parts(&parts.outputs);
            items.extend(components(&of_first(&parts.outputs)));
            return items;
        }
        let declared = self.scope.members("interface").iter().find(|member| member.key == of);
        let Some(declared) = declared else { return Vec::new() };
        match declared.value.get("members") {
            Some(members) => {
                let of = |member: &Member| {
                    let told = |key| text(&member.value, key).unwrap_or_default();
                    offers.word(&member.key, field, told("type"), told("doc"))
                };
                members.members().iter().map(of).collect()
            }
            None => components(text(&declared.value, "type").unwrap_or_default()),
        }
    }

    fn node(&self, name: &str) -> Option<super::parts::Parts> {
        parts_of(self.scope, name, None, self.library, self.files)
    }

    /// What `where` binds round the end of a path, inner names last, as far as one is bound before the place.
    fn bound(&self, path: &[&str]) -> Vec<&Member> {
        // Where something stands in a list says nothing of its key.
        let path: Vec<&str> =
            path.iter().map(|key| key.split('[').next().unwrap_or_default()).collect();
        let [section, first, keys @ ..] = path.as_slice() else { return Vec::new() };
        let section = self.scope.members(section);
        let mut values: Vec<&Value> =
            section.iter().filter(|it| it.key == *first).map(|it| &it.value).collect();
        let mut bound = Vec::new();
        for (at, key) in keys.iter().enumerate() {
            // A path says nothing of places in lists.
            values = values.into_iter().flat_map(each).collect();
            let last = keys[at..] == ["expression"];
            for value in &values {
                let all = value.get("where").map_or(&[][..], Value::members);
                let known = match (last, keys.get(at + 1)) {
                    (true, _) => all,
                    (false, Some(name)) if *key == "where" => {
                        &all[..all.iter().position(|it| it.key == **name).unwrap_or(all.len())]
                    }
                    _ => &[],
                };
                bound.extend(known);
            }
            values = values.into_iter().filter_map(|value| value.get(key)).collect();
        }
        bound
    }

    /// What there is to say of the name at a byte of a document, in an expression that is `object`.
    pub fn hover(
        &self,
        document: &Document,
        (object, path): (&Value, &[&str]),
        at: usize,
    ) -> Option<String> {
        let all = words_in(document, object.get("expression")?);
        let (word, _) = all.iter().find(|(_, place)| place.start <= at && at <= place.end)?;
        let Word { name, role, .. } = word;
        match role {
            Role::Function => of_library(node_of(name), self.library).as_ref().map(of_node),
            Role::Argument { function } => {
                let parts = of_library(node_of(function), self.library)?;
                parts.inputs.iter().find(|input| input.name == *name).map(of_input)
            }
            Role::Member { of } => {
                let parts = self.node(of.as_deref()?)?;
                parts.outputs.iter().find(|output| output.name == *name).map(of_input)
            }
            Role::Value => {
                if let Some(member) = self.bound(path).iter().rev().find(|it| it.key == *name) {
                    return Some(format!("`{name}` of `where`\n\n{}", told_bound(member)));
                }
                let constant = CONSTANTS.iter().find(|(known, _)| known == name);
                let of_phenomenon = self.node(name).as_ref().map(of_node);
                of_phenomenon
                    .or_else(|| parameter(self.scope, name))
                    .or_else(|| constant.map(|(name, value)| format!("`{name}` = {value}")))
            }
        }
    }
}

/// A value, or each of a list.
fn each(value: &Value) -> Vec<&Value> {
    match &value.kind {
        phenomenon_compiler::document::ValueKind::Array(elements) => elements.iter().collect(),
        _ => vec![value],
    }
}

/// What a name under `where` is.
fn told_bound(member: &Member) -> String {
    match text(&member.value, "expression") {
        Some(text) => format!("`{text}`"),
        None => match (text(&member.value, "node"), text(&member.value, "interface")) {
            (Some(node), _) => format!("node `{node}`"),
            (None, Some(parameter)) => format!("parameter `{parameter}`"),
            (None, None) => member.value.describe(),
        },
    }
}

fn of_first(outputs: &[Part]) -> String {
    outputs.first().map_or(String::new(), |output| output.of.clone())
}

/// The node a function means.
fn node_of(function: &str) -> &str {
    FUNCTIONS.iter().find(|known| known.name == function).map_or(function, |known| known.node)
}

/// The function in whose brackets a text ends.
fn open_call(written: &str) -> Option<String> {
    // An argument that is named there would be one of it.
    match words(&format!("{written} _: 0")).pop()?.role {
        Role::Argument { function } => Some(function),
        _ => None,
    }
}

/// A function as an item, with its arguments and what it yields.
fn call_of(name: &str, signature: &Signature, order: Option<&[&str]>) -> CompletionItem {
    let types = |of| {
        let types: Vec<&str> = signature.types_of(of).iter().map(|of| of.name()).collect();
        types.join(" | ")
    };
    let told = |input: &str| {
        let at = signature.input(input).map(|at| signature.inputs[at].value_type);
        format!("{input}: {}", at.map_or(String::new(), types))
    };
    let arguments: Vec<String> = match order {
        Some(order) => order.iter().map(|input| told(input)).collect(),
        None => signature.inputs.iter().map(|input| told(&input.name)).collect(),
    };
    let made = signature.outputs.first().map_or(String::new(), |output| types(output.value_type));
    let detail = format!("({}) → {made}", arguments.join(", "));
    Offers { in_string: true }.word(name, CompletionItemKind::FUNCTION, &detail, &signature.doc)
}
