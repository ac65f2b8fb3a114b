//! Writing expressions out as nodes.

use crate::check::draft::Draft;
use crate::check::types::Types;
use crate::diagnostics::{Code, shortened};
use crate::document::expression::PartKind;
use crate::document::numbers;
use crate::document::{Reader, Value, ValueKind};
use crate::values::Type;

use std::cell::Cell;
use std::collections::HashMap;

use super::names;
use super::operand::{Is, Operand, connection, settled};
use super::order::{Item, read_nodes};
use super::parsed::{Bound, Parsed};
use super::writer::{Name, Work, Writer};
use super::written::{Output, Text};

/// What expressions became: for each that could be written out, what stands in its place.
pub(super) struct Written {
    /// The nodes.
    pub output: Output,
    /// By position of the expression.
    pub places: HashMap<usize, Value>,
}

/// Writes the expressions out, each after what it reads.
pub(super) fn write<'d>(
    reader: &mut Reader<'d>,
    draft: &Draft<'d>,
    types: &mut Types,
    parsed: &[Parsed<'d>],
    order: &[Item],
) -> Written {
    let mut written = Written { output: Output::default(), places: HashMap::new() };
    for item in order {
        match *item {
            Item::Node(node) => types.settle(draft, node),
            Item::Expression(at) => {
                let mut scope = Vec::new();
                let mut work = Work { reader, draft, types, output: &mut written.output };
                let operand = expression(&mut work, &parsed[at], &mut scope);
                if let Some((operand, place)) = operand {
                    types.expressions.insert(parsed[at].value.start, lone_type(draft, &operand));
                    written.places.insert(at, place);
                }
            }
            Item::Circular(at) => {
                let place = circular(draft, &parsed[at], &mut written.output);
                written.places.extend(place.map(|place| (at, place)));
            }
        }
    }
    written
}

/// The type of what stands in the place of an expression; none of what has the type it is wanted as.
fn lone_type(draft: &Draft<'_>, operand: &Operand) -> Option<Type> {
    match &operand.is {
        Is::Broken | Is::Text | Is::Compound(_) | Is::Turns(_) => None,
        Is::Number => Some(Type::Scalar),
        Is::Triple => Some(Type::Color),
        Is::Of(value_type) => Some(*value_type),
        Is::Node(_, node_type, generic) => {
            let first = draft.node_types.signature(*node_type).outputs.first()?;
            settled(first.value_type, *generic)
        }
    }
}

/// Writes an expression and those under its `where` out: what it comes to, and what stands in its place.
fn expression<'d>(
    work: &mut Work<'_, 'd>,
    parsed: &Parsed<'d>,
    scope: &mut Vec<Name<'d>>,
) -> Option<(Operand, Value)> {
    let outer = scope.len();
    for (member, bound) in &parsed.bindings {
        let operand = match bound {
            Bound::Expression(inner) => {
                expression(work, inner, scope).map_or(Operand::broken(), |(operand, _)| operand)
            }
            Bound::Value(value) => names::bound(work, value),
        };
        scope.push(Name { name: &member.key, operand, used: Cell::new(false) });
    }
    let result = match parsed.parts.len() {
        0 => None,
        count => {
            let mut writer = Writer {
                reader: work.reader,
                draft: work.draft,
                types: work.types,
                output: work.output,
                parsed,
                scope,
                operands: Vec::with_capacity(count),
                emitted: 0,
                splits: HashMap::new(),
                told: 0,
            };
            writer.write()
        }
    };
    for ((member, _), name) in parsed.bindings.iter().zip(scope.drain(outer..)) {
        // What has a mistake is not known to use nothing.
        if !name.used.get() && !parsed.parts.is_empty() && !member.key.contains('-') {
            let message = format!("the expression does not use `{}`", shortened(&member.key));
            let help = "use it, or remove it from `where`";
            work.reader.report_key(Code::UNUSED_NAME, member, message, help);
        }
    }
    result
}

/// What stands for an expression on a cycle: a node that reads what it reads, so that the cycle is told.
fn circular(draft: &Draft<'_>, parsed: &Parsed<'_>, output: &mut Output) -> Option<Value> {
    let (start, end) = parsed.place(&parsed.parts.last()?.span);
    let whole = |kind| Value { start, end, kind };
    let member = |key: &str, value: Value| crate::document::Member {
        key: key.into(),
        key_start: start,
        key_end: end,
        value,
    };
    let read = read_nodes(draft, parsed).into_iter();
    let values = read.map(|node| whole(connection("node", draft.name(node), None))).collect();
    let values = member("values", whole(ValueKind::Array(values)));
    let node = whole(ValueKind::Object(vec![
        member("type", whole(ValueKind::String("sum".into()))),
        member("inputs", whole(ValueKind::Object(vec![values]))),
    ]));
    let text = Text { mark: parsed.text.to_owned(), whole: parsed.text.to_owned() };
    output.texts.insert(parsed.name.clone(), text);
    output.members.push(member(&parsed.name, node));
    Some(whole(connection("node", &parsed.name, None)))
}

impl Writer<'_, '_> {
    fn write(&mut self) -> Option<(Operand, Value)> {
        for at in 0..self.parsed.parts.len() {
            let operand = self.part(at);
            self.operands.push(operand);
        }
        let last = self.operands.len() - 1;
        if self.operands[last].is == Is::Broken {
            return None;
        }
        self.name_last(last);
        let value = self.value_of(last);
        Some((self.operands[last].clone(), value))
    }

    /// Names the node of the whole expression for its place; the others have numbers.
    fn name_last(&mut self, whole: usize) {
        let Some(last) = self.output.members.last_mut().filter(|_| self.emitted > 0) else {
            return;
        };
        let ValueKind::Object(members) = &mut self.operands[whole].json else { return };
        let Some(node) = members.iter_mut().find(|member| member.key == "node") else { return };
        // Nothing reads the node that was written last, but what stands in the place of the expression.
        if node.value.kind != ValueKind::String(last.key.clone()) {
            return;
        }
        let name = self.parsed.name.clone();
        if let Some(text) = self.output.texts.remove(&last.key) {
            self.output.texts.insert(name.clone(), text);
        }
        last.key.clone_from(&name);
        node.value.kind = ValueKind::String(name.clone());
        if let Is::Node(own, ..) = &mut self.operands[whole].is {
            *own = name;
        }
    }

    /// A number as written.
    fn number(&mut self, at: usize, number: &str) -> Operand {
        if numbers::double(number).is_some_and(|it| (it as f32).is_finite()) {
            return Operand { json: ValueKind::Number(number.to_owned()), is: Is::Number };
        }
        let span = self.parsed.parts[at].span.clone();
        let message = format!("the number {} is too large for 32 bits", shortened(number));
        self.report(Code::NOT_FINITE, &span, message, "the largest scalar is 3.4028235e38");
        Operand::broken()
    }

    fn part(&mut self, at: usize) -> Operand {
        let parsed = self.parsed;
        match &parsed.parts[at].kind {
            PartKind::Number(number) => self.number(at, number),
            PartKind::Boolean(truth) => Operand::of(ValueKind::Boolean(*truth), Type::Boolean),
            PartKind::Text(text) => Operand { json: ValueKind::String(text.clone()), is: Is::Text },
            PartKind::Name(name) => self.named(at, name),
            PartKind::Member(of, name) => self.member(at, *of, name),
            PartKind::Element(of, index) => self.element(at, *of, *index),
            PartKind::Operation(operator, of) => self.operation(at, *operator, of),
            PartKind::Choice(condition, one, other) => self.choice(at, [*condition, *one, *other]),
            PartKind::Call(name, arguments) => self.call(at, name, arguments),
        }
    }
}
