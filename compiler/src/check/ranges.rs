//! Values outside the ranges nodes declare: literals, parameters by their own range, and what is
//! computed where it surely comes to lie outside.

use std::collections::HashSet;
use std::ops::RangeInclusive;

use crate::diagnostics::{Code, Finding, shortened, shown};
use crate::document::numbers::{self, Whole};
use crate::document::{Reader, Value, ValueKind};
use crate::nodes::{FINITE, Input, NodeType};
use crate::values::{Literal, Type};

use super::draft::{Draft, SourceKind};
use super::intervals::{Intervals, Value as Known, described};

/// By how much of itself a number may be wrong that was computed.
const ROUNDING: f64 = 1e-6;

/// Reports what arrives at inputs from outside their declared range, but the literals that are `told` of
/// by their first bytes.
pub(super) fn check(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    intervals: &Intervals<'_>,
    told: &HashSet<usize>,
) {
    for (node, drafted) in draft.nodes.iter().enumerate() {
        let Some(node_type) = drafted.node_type else { continue };
        let signature = draft.node_types.signature(node_type);
        for given in &drafted.inputs {
            let Some(at) = given.input else { continue };
            let input = &signature.inputs[at];
            if input.range == FINITE || !input.value_type.is_numeric() {
                continue;
            }
            let what = || format!("input `{}` of {}", input.name, draft.described(node));
            match given.source.kind {
                SourceKind::Literal if told.contains(&given.source.value.start) => {}
                SourceKind::Literal => {
                    let enforced = is_enforced(draft, node_type, input);
                    literal(reader, given.source.value, input, enforced, &what);
                }
                // Told of where it is bound.
                SourceKind::Parameter(_) if input.fixed => {}
                SourceKind::Parameter(parameter) => {
                    let words = intervals.arriving(draft, node, at);
                    let sources = words.iter().fold(0, |sources, word| sources | word.sources);
                    if intervals.holds_at(node, at, sources) {
                        self::parameter(reader, draft, parameter, given.source.value, input, &what);
                    }
                }
                SourceKind::Node(source, Some(output)) => {
                    let words = intervals.arriving(draft, node, at);
                    let holds = |word: &Known| intervals.holds_at(node, at, word.sources);
                    let left = words.iter().take(3).find(|word| leaves(word, input) && holds(word));
                    if let Some(left) = left {
                        let source = (source, output);
                        computed(reader, draft, source, left, given.source.value, input, &what);
                    }
                }
                SourceKind::Node(_, None) | SourceKind::Compound(_) | SourceKind::Broken => {}
            }
        }
    }
}

/// Whether an input takes nothing from outside its range: the ranges of a phenomenon's parameters are enforced, and of
/// what is known before shading; those of other inputs are not.
pub(super) fn is_enforced(draft: &Draft<'_>, node_type: NodeType, input: &Input) -> bool {
    input.fixed || draft.nested.contains_key(&node_type)
}

/// Reports a number that no integer can hold, with the narrower range that is enforced; whether it is one. Others are
/// told of by [`check`], or by whoever reads the literal.
pub(super) fn is_huge(
    reader: &mut Reader<'_>,
    value: &Value,
    input: &Input,
    what: &dyn Fn() -> String,
) -> bool {
    let ValueKind::Number(text) = &value.kind else { return false };
    let is_huge = input.value_type == Type::Integer
        && input.range != FINITE
        && matches!(numbers::whole(text), Whole::Number(number) if i32::try_from(number).is_err());
    if is_huge {
        outside(reader, value, text, input, true, what);
    }
    is_huge
}

/// Whether a number can be read as what the input takes; what cannot is told of where it is read.
fn is_readable(text: &str, input: &Input) -> bool {
    input.value_type != Type::Integer
        || matches!(numbers::whole(text), Whole::Number(number) if i32::try_from(number).is_ok())
}

fn literal(
    reader: &mut Reader<'_>,
    value: &Value,
    input: &Input,
    enforced: bool,
    what: &dyn Fn() -> String,
) {
    let elements = match &value.kind {
        // Alpha has no range.
        ValueKind::Array(elements) if matches!(elements.len(), 3 | 4) => &elements[..3],
        _ => std::slice::from_ref(value),
    };
    let past = elements.iter().find(|element| match &element.kind {
        ValueKind::Number(text) if is_readable(text, input) => {
            numbers::single(text).is_some_and(|x| !holds(&input.range, x.into()))
        }
        _ => false,
    });
    if let Some(ValueKind::Number(number)) = past.map(|element| &element.kind) {
        outside(reader, value, number, input, enforced, what);
    }
}

fn outside(
    reader: &mut Reader<'_>,
    value: &Value,
    number: &str,
    input: &Input,
    enforced: bool,
    what: &dyn Fn() -> String,
) {
    let range = shown(&input.range);
    let message = format!("{} is {}, outside {range}", what(), shortened(number));
    let (code, promise) = match enforced {
        true => (Code::NUMBER_OUT_OF_RANGE, ""),
        false => (Code::LITERAL_OUT_OF_RANGE, "; outside of it the result has no promised meaning"),
    };
    reader.report(code, value, message, format!("give a number in {range}{promise}"));
}

/// A parameter without a range of its own promises nothing, and is not told of.
fn parameter(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    at: usize,
    value: &Value,
    input: &Input,
    what: &dyn Fn() -> String,
) {
    let Some(parameter) = &draft.parameters[at].parameter else { return };
    if parameter.range == FINITE || matches!(parameter.default, Literal::Boolean(_)) {
        return;
    }
    let (low, high) = (*parameter.range.start(), *parameter.range.end());
    if holds(&input.range, low) && holds(&input.range, high) {
        return;
    }
    let (own, range) = (shown(&parameter.range), shown(&input.range));
    let name = shortened(&parameter.name);
    let message = format!("{} takes {range}, but parameter `{name}` may be {own}", what());
    let help = format!("narrow `min` and `max` of `{name}`, or clamp it");
    let place = reader.document.place(value);
    let declared = reader.document.place_of_key(draft.parameters[at].member);
    let finding = Finding::new(Code::RANGE_PAST_INPUT, place, message, help);
    reader.findings.push(finding.with_related(declared, "declared here"));
}

/// Whether a word surely comes to be outside of the input's range, by more than rounding.
fn leaves(word: &Known, input: &Input) -> bool {
    let Some(reached) = word.reached else { return false };
    let (low, high) = (f64::from(reached.low), f64::from(reached.high));
    let size = low.abs().max(high.abs());
    let past = |bound: f64, by: f64| by > ROUNDING * size.max(bound.abs());
    let (from, to) = (*input.range.start(), *input.range.end());
    past(from, from - low) || past(to, high - to)
}

fn computed(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    (node, output): (usize, usize),
    word: &Known,
    value: &Value,
    input: &Input,
    what: &dyn Fn() -> String,
) {
    let Some(reached) = word.reached else { return };
    let own = described(reached.low.into(), reached.high.into());
    let is = if word.sources == 0 { "is" } else { "may be" };
    let range = shown(&input.range);
    let message = format!(
        "{} takes {range}, but {} {is} {own}",
        what(),
        draft.described_output(node, output)
    );
    let place = reader.document.place(value);
    // The part of an expression is where it is used.
    if draft.is_written(draft.name(node)) {
        let help = "clamp it, or change what it is made of";
        reader.findings.push(Finding::new(Code::RANGE_PAST_INPUT, place, message, help));
        return;
    }
    let name = draft.told_name(node);
    let help = format!("clamp it, or change what `{name}` makes it of");
    let declared = reader.document.place_of_key(draft.nodes[node].member);
    let finding = Finding::new(Code::RANGE_PAST_INPUT, place, message, help);
    reader.findings.push(finding.with_related(declared, "computed here"));
}

/// Whether a range holds a number, both rounded as they are kept.
fn holds(range: &RangeInclusive<f64>, number: f64) -> bool {
    (*range.start() as f32) <= number as f32 && number as f32 <= (*range.end() as f32)
}
