//! Nodes that expressions become, as members of the document's `nodes`.

use crate::diagnostics::Code;
use crate::document::{Member, Value, ValueKind};
use crate::nodes::NodeType;
use crate::values::Type;

use super::operand::{Is, Operand, connection, placed_member, settled};
use super::writer::Writer;
use super::written::Text;

impl<'d> Writer<'_, 'd> {
    /// The node type an expression needs; a finding where the library lacks it.
    pub fn library_type(&mut self, at: usize, name: &str) -> Option<NodeType> {
        let found = self.draft.node_types.library.find(name);
        if found.is_none() {
            let message = format!("the node library lacks `{name}`, which this is written out as");
            let span = self.parsed.parts[at].mark.clone();
            self.report(Code::UNKNOWN_NODE_TYPE, &span, message, "add it to the library");
        }
        found
    }

    /// Adds a node of the library for a part, given inputs by name; its outputs of generic type are `generic`.
    pub fn node(
        &mut self,
        at: usize,
        type_name: &str,
        generic: Option<Type>,
        inputs: Vec<(&str, Value)>,
    ) -> Operand {
        match self.library_type(at, type_name) {
            Some(node_type) => self.typed_node(at, node_type, generic, inputs),
            None => Operand::broken(),
        }
    }

    /// The same of a type that is known.
    pub fn typed_node(
        &mut self,
        at: usize,
        node_type: NodeType,
        generic: Option<Type>,
        inputs: Vec<(&str, Value)>,
    ) -> Operand {
        let part = &self.parsed.parts[at];
        let (span, mark) = (part.span.clone(), part.mark.clone());
        let signature = self.draft.node_types.signature(node_type);
        let type_name = signature.name.to_string();
        self.emitted += 1;
        let name = format!("{}#{}", self.parsed.name, self.emitted);
        let inputs = inputs.into_iter().map(|(key, value)| placed_member(key, value)).collect();
        let (start, end) = self.parsed.place(&span);
        let whole = |kind| Value { start, end, kind };
        let value = whole(ValueKind::Object(vec![
            placed_member("type", whole(ValueKind::String(type_name))),
            placed_member("inputs", whole(ValueKind::Object(inputs))),
        ]));
        let (key_start, key_end) = self.parsed.place(&mark);
        self.output.members.push(Member { key: name.clone(), key_start, key_end, value });
        let text = Text { mark: self.quote(&mark), whole: self.quote(&span) };
        self.output.texts.insert(name.clone(), text);
        self.whole_node(name, node_type, generic)
    }

    /// A node as an operand.
    pub fn whole_node(&self, name: String, node_type: NodeType, generic: Option<Type>) -> Operand {
        let json = connection("node", &name, None);
        Operand { json, is: Is::Node(name, node_type, generic) }
    }

    /// An output of a node, by position.
    pub fn output_of(
        &self,
        name: &str,
        (node_type, generic): (NodeType, Option<Type>),
        output: usize,
    ) -> Operand {
        let output = &self.draft.node_types.signature(node_type).outputs[output];
        let json = connection("node", name, Some(&output.name));
        match settled(output.value_type, generic) {
            Some(value_type) => Operand::of(json, value_type),
            None => Operand::broken(),
        }
    }

    /// What stands for an operand at the place of a part.
    pub fn at(&self, part: usize, operand: &Operand) -> Value {
        let (start, end) = self.parsed.place(&self.parsed.parts[part].span);
        let json = match &operand.json {
            ValueKind::Object(members) => {
                ValueKind::Object(members.iter().map(|it| moved(it, start, end)).collect())
            }
            other => other.clone(),
        };
        Value { start, end, kind: json }
    }

    /// What a part comes to, at its place.
    pub fn value_of(&self, part: usize) -> Value {
        self.at(part, &self.operands[part])
    }
}

fn moved(member: &Member, start: usize, end: usize) -> Member {
    let value = Value { start, end, kind: member.value.kind.clone() };
    Member { key: member.key.clone(), key_start: start, key_end: end, value }
}
