//! What kinds of names stand where, so that editors can colour them.

use std::ops::Range;

use lsp_types::{SemanticToken, SemanticTokenModifier, SemanticTokenType};
use phenomenon_compiler::document::{Value, ValueKind};

use crate::commands::lsp::file::OpenFile;
use crate::commands::lsp::names::{self, NameKind};

/// The kinds of tokens, by their numbers in the protocol, and what may be said of each.
pub const LEGEND: (&[SemanticTokenType], &[SemanticTokenModifier]) = (
    &[
        SemanticTokenType::PARAMETER,
        SemanticTokenType::VARIABLE,
        SemanticTokenType::CLASS,
        SemanticTokenType::PROPERTY,
    ],
    &[SemanticTokenModifier::DECLARATION],
);

const PARAMETER: u32 = 0;
const VARIABLE: u32 = 1;
const CLASS: u32 = 2;
const PROPERTY: u32 = 3;
const DECLARATION: u32 = 1;

/// The tokens of the file, each with its place after the one before, as the protocol has it.
pub fn tokens(file: &OpenFile) -> Option<Vec<SemanticToken>> {
    let document = file.current()?;
    let index = names::index(document);
    let mut found: Vec<(Range<usize>, u32, u32)> = Vec::new();
    for name in &index.names {
        found.push((name.place.clone(), kind_of(name.kind), DECLARATION));
    }
    for used in &index.uses {
        found.push((used.place.clone(), kind_of(used.kind), 0));
    }
    phenomenon(&document.root, &mut found);
    found.sort_by_key(|(place, _, _)| (place.start, place.end));
    found.dedup_by(|later, earlier| later.0.start < earlier.0.end);
    Some(relative(file.text(), &found))
}

fn kind_of(kind: NameKind) -> u32 {
    match kind {
        NameKind::Parameter => PARAMETER,
        NameKind::Node | NameKind::Light | NameKind::Bound => VARIABLE,
        NameKind::Phenomenon => CLASS,
        NameKind::Output | NameKind::Preset => PROPERTY,
    }
}

/// Types of nodes, and the names of their inputs and outputs. The nesting of documents is bounded, and so is this
/// recursion.
fn phenomenon(of: &Value, found: &mut Vec<(Range<usize>, u32, u32)>) {
    for node in of.get("nodes").map_or(&[][..], Value::members) {
        if let Some(of) = node.value.get("type") {
            string(of, CLASS, found);
        }
        for input in node.value.get("inputs").map_or(&[][..], Value::members) {
            let key = input.key_start + 1..input.key_end.saturating_sub(1);
            if key.start < key.end {
                found.push((key, PROPERTY, 0));
            }
            outputs(&input.value, found);
        }
    }
    for section in ["roots", "outputs"] {
        for member in of.get(section).map_or(&[][..], Value::members) {
            outputs(&member.value, found);
        }
    }
    for inner in of.get("phenomena").map_or(&[][..], Value::members) {
        phenomenon(&inner.value, found);
    }
}

/// The outputs that connections name.
fn outputs(value: &Value, found: &mut Vec<(Range<usize>, u32, u32)>) {
    match &value.kind {
        ValueKind::Array(elements) => elements.iter().for_each(|it| outputs(it, found)),
        ValueKind::Object(members) => {
            for member in members {
                match member.key.as_str() {
                    "output" => string(&member.value, PROPERTY, found),
                    _ => outputs(&member.value, found),
                }
            }
        }
        _ => {}
    }
}

fn string(value: &Value, kind: u32, found: &mut Vec<(Range<usize>, u32, u32)>) {
    let place = value.start + 1..value.end.saturating_sub(1);
    if matches!(value.kind, ValueKind::String(_)) && place.start < place.end {
        found.push((place, kind, 0));
    }
}

/// Tokens in order, counted from one another in one pass over the text.
fn relative(text: &str, found: &[(Range<usize>, u32, u32)]) -> Vec<SemanticToken> {
    let mut tokens = Vec::with_capacity(found.len());
    let utf_16 = |range: Range<usize>| text[range].encode_utf16().count() as u32;
    let (mut at, mut last_start) = (0, 0);
    for (place, kind, modifiers) in found {
        let between = &text[at..place.start];
        let delta_line = between.matches('\n').count() as u32;
        let from = match between.rfind('\n') {
            Some(line) => at + line + 1,
            None => last_start,
        };
        tokens.push(SemanticToken {
            delta_line,
            delta_start: utf_16(from..place.start),
            length: utf_16(place.clone()),
            token_type: *kind,
            token_modifiers_bitset: *modifiers,
        });
        (at, last_start) = (place.start, place.start);
    }
    tokens
}
