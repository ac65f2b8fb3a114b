//! Finds the names of a file. It need not be right for that: what is understood of it has its names.

use std::ops::Range;

use phenomenon_compiler::document::{Document, Member, Role, Value, ValueKind, words_in};

use crate::commands::lsp::parts::body_of;

use super::index::{Index, Name, NameKind, Use};

/// The names of a graph or a scene.
pub fn index(document: &Document) -> Index {
    let mut scan = Scan { document, round: Vec::new(), index: Index::default() };
    let root = &document.root;
    scan.index.scopes.push(None);
    scan.lights(root);
    scan.phenomenon(root, 0);
    scan.index.names.sort_by_key(|name| name.place.start);
    scan.index.uses.sort_by_key(|used| used.place.start);
    scan.index
}

/// The sections of a phenomenon whose members have names.
const SECTIONS: [(&str, NameKind); 5] = [
    ("interface", NameKind::Parameter),
    ("phenomena", NameKind::Phenomenon),
    ("nodes", NameKind::Node),
    ("outputs", NameKind::Output),
    ("presets", NameKind::Preset),
];

struct Scan<'d> {
    document: &'d Document,
    /// The phenomena round what is scanned, outermost first.
    round: Vec<&'d Value>,
    index: Index,
}

impl<'d> Scan<'d> {
    /// The names of a phenomenon. The nesting of documents is bounded, and so is this recursion.
    fn phenomenon(&mut self, of: &'d Value, scope: usize) {
        self.round.push(of);
        for (section, kind) in SECTIONS {
            for member in of.get(section).map_or(&[][..], Value::members) {
                let place = member.key_start + 1..member.key_end.saturating_sub(1);
                self.give(kind, scope, &member.key, place);
                self.member(kind, member, scope);
            }
        }
        for root in of.get("roots").map_or(&[][..], Value::members) {
            self.values(&root.value, scope);
        }
        self.round.pop();
    }

    /// What is used in a member of a section.
    fn member(&mut self, kind: NameKind, member: &'d Member, scope: usize) {
        match kind {
            NameKind::Phenomenon => {
                let inner = self.index.scopes.len();
                self.index.scopes.push(Some(scope));
                self.phenomenon(&member.value, inner);
            }
            NameKind::Node => {
                let node_type = member.value.get("type");
                if let Some(named) = node_type.and_then(|it| body_of(it).get("phenomenon")) {
                    self.used(NameKind::Phenomenon, scope, named);
                }
                for input in member.value.get("inputs").map_or(&[][..], Value::members) {
                    self.values(&input.value, scope);
                }
            }
            NameKind::Output => self.values(&member.value, scope),
            // What a parameter is by default uses nothing, and the names in a preset are parameters.
            NameKind::Preset => {
                for set in member.value.members() {
                    let place = set.key_start + 1..set.key_end.saturating_sub(1);
                    self.use_head(NameKind::Parameter, scope, &set.key, place);
                }
            }
            NameKind::Parameter | NameKind::Light | NameKind::Bound => {}
        }
    }

    /// What is used in a value of a graph.
    fn values(&mut self, value: &'d Value, scope: usize) {
        match &value.kind {
            ValueKind::Array(elements) => {
                elements.iter().for_each(|element| self.values(element, scope));
            }
            ValueKind::Object(members) => {
                if let Some(members) = value.get("struct").map(Value::members) {
                    return members.iter().for_each(|member| self.values(&member.value, scope));
                }
                if let Some(text) = value.get("expression") {
                    return self.expression(value, text, (scope, scope));
                }
                for member in members {
                    match member.key.as_str() {
                        "node" => self.used(NameKind::Node, scope, &member.value),
                        "interface" => self.used(NameKind::Parameter, scope, &member.value),
                        _ => self.values(&member.value, scope),
                    }
                }
            }
            _ => {}
        }
    }

    /// What an expression binds and names: nodes and parameters are those of the phenomenon, whose scope is the first of
    /// the two; the other is the innermost, with the names bound so far.
    fn expression(&mut self, value: &'d Value, text: &'d Value, (outer, inner): (usize, usize)) {
        let mut scope = inner;
        for member in value.get("where").map_or(&[][..], Value::members) {
            match member.value.get("expression") {
                Some(text) => self.expression(&member.value, text, (outer, scope)),
                None => self.values(&member.value, outer),
            }
            self.index.scopes.push(Some(scope));
            scope = self.index.scopes.len() - 1;
            let place = member.key_start + 1..member.key_end.saturating_sub(1);
            self.give(NameKind::Bound, scope, &member.key, place);
        }
        for (word, place) in words_in(self.document, text) {
            if word.role != Role::Value || !self.is_written(&word.name, &place) {
                continue;
            }
            let name = word.name;
            let used = |kind, scope| Use {
                kind,
                scope,
                name: name.clone(),
                place: place.clone(),
                in_expression: true,
            };
            let bound = used(NameKind::Bound, scope);
            let is_node = || self.round.last()?.get("nodes")?.get(&name);
            let used = match (self.index.given(&bound).is_some(), is_node().is_some()) {
                (true, _) => bound,
                (false, true) => used(NameKind::Node, outer),
                (false, false) => used(NameKind::Parameter, outer),
            };
            self.index.uses.push(used);
        }
    }

    /// A string that names something, or begins with a name: `layers[1].tint`.
    fn used(&mut self, kind: NameKind, scope: usize, value: &Value) {
        if let ValueKind::String(name) = &value.kind {
            self.use_head(kind, scope, name, value.start + 1..value.end.saturating_sub(1));
        }
    }

    fn use_head(&mut self, kind: NameKind, scope: usize, name: &str, place: Range<usize>) {
        let head = match kind {
            NameKind::Parameter => name.find(['.', '[']).unwrap_or(name.len()),
            _ => name.len(),
        };
        let name = &name[..head];
        let place = place.start..place.start + head;
        if self.is_written(name, &place) {
            let name = name.into();
            self.index.uses.push(Use { kind, scope, name, place, in_expression: false });
        }
    }

    fn give(&mut self, kind: NameKind, scope: usize, name: &str, place: Range<usize>) {
        if self.is_written(name, &place) {
            self.index.names.push(Name { kind, scope, name: name.into(), place });
        }
    }

    /// Whether a name stands there as it is: one with escapes is none that a file may have.
    fn is_written(&self, name: &str, place: &Range<usize>) -> bool {
        !name.is_empty() && self.document.file.text.get(place.clone()) == Some(name)
    }

    /// The lights of a scene, and where `set` names them.
    fn lights(&mut self, scene: &'d Value) {
        let Some(ValueKind::Array(lights)) = scene.get("lights").map(|lights| &lights.kind) else {
            return;
        };
        for light in lights {
            let Some(value) = light.get("name") else { continue };
            if let ValueKind::String(name) = &value.kind {
                let place = value.start + 1..value.end.saturating_sub(1);
                self.give(NameKind::Light, 0, name, place);
            }
        }
        let mut pending = vec![scene];
        while let Some(value) = pending.pop() {
            match &value.kind {
                ValueKind::Array(elements) => pending.extend(elements),
                ValueKind::Object(members) => {
                    for member in members {
                        match member.key.as_str() {
                            "light" => self.used(NameKind::Light, 0, &member.value),
                            "editor" => {}
                            _ => pending.push(&member.value),
                        }
                    }
                }
                _ => {}
            }
        }
    }
}
