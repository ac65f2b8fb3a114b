//! An expression being written out, and what is said of its parts.

use std::cell::Cell;
use std::collections::HashMap;

use crate::check::draft::Draft;
use crate::check::types::Types;
use crate::diagnostics::{Advice, Code, Finding, shortened};
use crate::document::expression::Span;
use crate::document::numbers::{self, Whole};
use crate::document::{Reader, ValueKind};
use crate::values::Type;

use super::convert;
use super::operand::{Arrives, Is, Operand, settled};
use super::parsed::Parsed;
use super::written::Output;

/// What all expressions of a file are written with.
pub(super) struct Work<'w, 'd> {
    pub reader: &'w mut Reader<'d>,
    pub draft: &'w Draft<'d>,
    pub types: &'w Types,
    pub output: &'w mut Output,
}

/// A name that `where` binds.
pub(super) struct Name<'d> {
    pub name: &'d str,
    pub operand: Operand,
    pub used: Cell<bool>,
}

/// One expression being written out.
pub(super) struct Writer<'w, 'd> {
    pub reader: &'w mut Reader<'d>,
    pub draft: &'w Draft<'d>,
    pub types: &'w Types,
    pub output: &'w mut Output,
    pub parsed: &'w Parsed<'d>,
    /// The names that are bound, inner ones last.
    pub scope: &'w [Name<'d>],
    /// What the parts so far come to.
    pub operands: Vec<Operand>,
    /// How many nodes it became so far.
    pub emitted: usize,
    /// The nodes that take values apart, by what they are given.
    pub splits: HashMap<String, Operand>,
    /// Up to here a name was told of, which is none of several here.
    pub told: usize,
}

impl Writer<'_, '_> {
    /// What arrives from a part where a value is wanted; none after a finding.
    pub fn arrives(&mut self, part: usize) -> Option<Arrives> {
        match &self.operands[part].is {
            Is::Broken => None,
            Is::Number => Some(Arrives::Number),
            Is::Triple => Some(Arrives::Triple),
            Is::Text => Some(Arrives::Text),
            Is::Of(value_type) => Some(Arrives::Of(*value_type)),
            Is::Node(_, node_type, generic) => {
                let first = self.draft.node_types.signature(*node_type).outputs.first()?;
                settled(first.value_type, *generic).map(Arrives::Of)
            }
            Is::Compound(at) => {
                let (name, shape) = &self.draft.compounds[*at];
                let message =
                    format!("`{}` is {}, not one value", shortened(name), shape.describe());
                let help = match shape.parts(name).first() {
                    Some((part, _)) => format!("name a part of it, such as `{part}`"),
                    None => "name a part of it".into(),
                };
                let span = self.parsed.parts[part].span.clone();
                self.report(Code::TYPE_MISMATCH, &span, message, help);
                None
            }
            Is::Turns(name) => {
                let (count, shown) = (self.draft.nodes_named(name).count(), shortened(name));
                let message = format!("the map `{shown}` yields a list of {count}, not one value");
                let help = format!(
                    "name one of them, such as `{shown}[0]`, or a node that makes one value of all: a `sum` or a `fold`"
                );
                let span = self.parsed.parts[part].span.clone();
                self.report(Code::TYPE_MISMATCH, &span, message, help);
                None
            }
        }
    }

    /// The text of a part, for messages.
    pub fn text(&self, part: usize) -> String {
        shortened(&self.quote(&self.parsed.parts[part].span))
    }

    /// A part and what it is: "`tint` is a color".
    pub fn described(&self, part: usize, arrives: Arrives) -> String {
        format!("`{}` is {}", self.text(part), convert::described(arrives))
    }

    /// Reports a mistake at a piece of the text.
    pub fn report(
        &mut self,
        code: Code,
        span: &Span,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.advise(code, span, message, Advice::from(help.into()));
    }

    /// The same with what may be put in its place: a bare word.
    pub fn advise(&mut self, code: Code, span: &Span, message: impl Into<String>, advice: Advice) {
        let (start, end) = self.parsed.place(span);
        let place = self.reader.document.place_of_bytes(start, end);
        let mut finding = Finding::new(code, place, message, advice.help);
        // Advice has the text of a string of JSON, and stands within one here.
        let word = advice.fix.as_deref().map(|fix| fix.trim_matches('"'));
        let is_word = |word: &&str| word.chars().all(|c| c.is_alphanumeric() || c == '_');
        finding.fix = word.filter(is_word).map(str::to_owned);
        self.reader.findings.push(finding);
    }

    /// Whether a part may be given to an input of a type that is not generic.
    pub fn suits(&self, part: usize, arrives: Arrives, to: Type) -> bool {
        match arrives {
            Arrives::Number if to == Type::Integer => match &self.operands[part].json {
                ValueKind::Number(text) => {
                    matches!(numbers::whole(text), Whole::Number(_))
                }
                _ => false,
            },
            Arrives::Number => matches!(to, Type::Scalar | Type::Color),
            Arrives::Triple => matches!(to, Type::Color | Type::Vector),
            Arrives::Text => to == Type::String,
            Arrives::Of(from) => from.converts_to(to),
        }
    }

    /// A piece of the text.
    pub fn quote(&self, span: &Span) -> String {
        self.parsed.text.get(span.clone()).unwrap_or_default().to_owned()
    }
}
