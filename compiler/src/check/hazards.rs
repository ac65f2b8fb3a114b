//! Numeric hazards: zeros that are divided by, negative numbers that are raised to powers. Told of
//! literals, of parameters by their range, and of what is computed where a hazard is surely reached.

use std::ops::RangeInclusive;

use crate::diagnostics::{Code, Finding, shortened, shown};
use crate::document::{Reader, ValueKind};
use crate::nodes::{Avoid, FINITE};

use super::draft::{Draft, DraftInput, SourceKind};
use super::intervals::{Intervals, Reached, described};

/// Reports inputs where a hazard arrives, or may.
pub(super) fn check(reader: &mut Reader<'_>, draft: &Draft<'_>, intervals: &Intervals<'_>) {
    for (at, drafted) in draft.nodes.iter().enumerate() {
        let Some(node_type) = drafted.node_type else { continue };
        let signature = draft.node_types.signature(node_type);
        for given in &drafted.inputs {
            let Some(input) = given.input else { continue };
            let declared = &signature.inputs[input];
            let Some(avoid) = declared.avoid else { continue };
            // What the range forbids is told of as out of range.
            if !holds(&declared.range, avoid) {
                continue;
            }
            let place = Arrival { draft, intervals, node: at, input, given };
            let Some(arriving) = place.hazard(avoid) else { continue };
            let (does, convention) = match avoid {
                Avoid::Zero => ("divides by", "a division by 0 gives 0"),
                Avoid::Negative => ("raises to a power", "see docs/numerics.md for its value"),
            };
            let message = format!(
                "{} {does} its input `{}`, which {arriving}",
                draft.described(at),
                declared.name
            );
            let help = format!("keep such values away with its range or a `maximum`; {convention}");
            let place = reader.document.place(given.source.value);
            reader.findings.push(Finding::new(Code::NUMERIC_HAZARD, place, message, help));
        }
    }
}

/// What arrives at an input that is given.
struct Arrival<'a, 'd> {
    draft: &'a Draft<'d>,
    intervals: &'a Intervals<'a>,
    node: usize,
    input: usize,
    given: &'a DraftInput<'d>,
}

impl Arrival<'_, '_> {
    /// How the hazard arrives, if it is known to.
    fn hazard(&self, avoid: Avoid) -> Option<String> {
        match self.given.source.kind {
            SourceKind::Literal => self.literal(avoid),
            SourceKind::Parameter(at) => {
                let parameter = self.draft.parameters[at].parameter.as_ref()?;
                // A parameter without a range of its own says nothing.
                let known = parameter.range != FINITE && holds(&parameter.range, avoid);
                let words = self.words();
                let sources = words.iter().fold(0, |sources, word| sources | word.sources);
                let (name, range) = (shortened(&parameter.name), shown(&parameter.range));
                (known && self.intervals.holds_at(self.node, self.input, sources))
                    .then(|| format!("{}: parameter `{name}` is {range}", may_be(avoid)))
            }
            SourceKind::Node(node, Some(output)) => self.computed(avoid, node, output),
            SourceKind::Node(_, None) | SourceKind::Compound(_) | SourceKind::Broken => None,
        }
    }

    fn literal(&self, avoid: Avoid) -> Option<String> {
        let value = self.given.source.value;
        let elements = match &value.kind {
            ValueKind::Array(elements) => &elements[..elements.len().min(3)],
            _ => std::slice::from_ref(value),
        };
        let number = |kind: &ValueKind| match kind {
            ValueKind::Number(text) => text.parse::<f32>().ok().map(f64::from),
            _ => None,
        };
        let mut numbers = elements.iter().filter_map(|element| number(&element.kind));
        numbers.find(|&x| holds(&(x..=x), avoid)).map(|hit| format!("is {hit}"))
    }

    fn computed(&self, avoid: Avoid, node: usize, output: usize) -> Option<String> {
        let signature = self.draft.node_types.signature(self.draft.nodes[node].node_type?);
        let words = self.words();
        // The alpha of a colour is not computed with.
        let (word, reached) = words.iter().take(3).find_map(|word| {
            let reached = word.reached.filter(|reached| reaches(reached, avoid))?;
            self.intervals.holds_at(self.node, self.input, word.sources).then_some((word, reached))
        })?;
        let of = self.draft.described_output(node, output);
        let output = &signature.outputs[output];
        let (low, high) = (f64::from(reached.low), f64::from(reached.high));
        Some(match (reached.varies(), word.sources) {
            (true, _) => format!("{}: {of} is {}", may_be(avoid), described(low, high)),
            (false, 0) => format!("is {}, {of}", low + 0.0),
            (false, _) if output.value_type.is_numeric() && output.range != FINITE => {
                format!("{}: {of} is {}", may_be(avoid), shown(&output.range))
            }
            (false, _) => format!("{}: {of} comes to be {}", may_be(avoid), low + 0.0),
        })
    }

    fn words(&self) -> Vec<super::intervals::Value> {
        self.intervals.arriving(self.draft, self.node, self.input)
    }
}

fn may_be(avoid: Avoid) -> &'static str {
    match avoid {
        Avoid::Zero => "may be 0",
        Avoid::Negative => "may be negative",
    }
}

fn holds(range: &RangeInclusive<f64>, avoid: Avoid) -> bool {
    match avoid {
        Avoid::Zero => range.contains(&0.0),
        Avoid::Negative => *range.start() < 0.0,
    }
}

fn reaches(reached: &Reached, avoid: Avoid) -> bool {
    match avoid {
        Avoid::Zero => reached.zero,
        // Rounding alone is no negative number: 1 - x may fall short of 0 by a bit.
        Avoid::Negative => reached.low < -1e-6 * reached.high.abs().max(f32::MIN_POSITIVE),
    }
}
