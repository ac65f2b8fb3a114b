//! How large each card is, and where its rows and sockets lie in it.

use super::diagram::{Card, Given, Role};
use super::theme::{BADGE, ROW, SMALL, TITLE};
use super::values::Value;

/// Height of a header of two lines.
pub(super) const HEADER: f64 = 34.0;
/// Height of the header of a root, which has one line.
pub(super) const ROOT_HEADER: f64 = 22.0;
/// Height of a row.
pub(super) const ROW_HEIGHT: f64 = 17.0;
/// Room round the rows.
pub(super) const PADDING: f64 = 5.0;
/// From the side of a box to its text, past the socket.
pub(super) const INDENT: f64 = 11.0;
/// Side of the square that shows a colour.
pub(super) const SWATCH: f64 = 9.0;
/// From the end of a pill to its text.
pub(super) const PILL_END: f64 = 6.0;
/// Between two texts of a row.
pub(super) const TEXT_GAP: f64 = 8.0;

/// Widest box.
const WIDEST: f64 = 250.0;
/// Narrowest box.
const NARROWEST: f64 = 84.0;
/// Widest text left of an output's name.
const WIDEST_VALUE: f64 = 110.0;
/// Widest name of a socket.
const WIDEST_NAME: f64 = 120.0;

/// A measured card. Offsets are from the box's top.
#[derive(Clone, Debug)]
pub(super) struct Frame {
    /// Width of the box.
    pub width: f64,
    /// Height of the box.
    pub height: f64,
    /// Middle of each input's row.
    pub inputs: Vec<f64>,
    /// Middle of each output's row.
    pub outputs: Vec<f64>,
}

/// Height of the header of `card`.
pub(super) fn header(card: &Card<'_>) -> f64 {
    if card.role == Role::Root { ROOT_HEADER } else { HEADER }
}

/// What is written on a box that opens.
pub(super) const OPEN: &str = "open";

/// Width of a badge with `text`.
pub(super) fn badge_width(text: &str) -> f64 {
    BADGE.width(text) + 10.0
}

/// Text beside the name of an input.
pub(super) fn given_text(given: &Given) -> &str {
    match given {
        Given::Wire => "",
        Given::Parameter(name) => name,
        Given::Literal(value) | Given::Default(value) => &value.text,
        Given::Implied(implied) => &implied.text,
    }
}

/// The value a row shows, if any.
pub(super) fn given_value(given: &Given) -> Option<&Value> {
    match given {
        Given::Literal(value) | Given::Default(value) => Some(value),
        Given::Wire | Given::Parameter(_) | Given::Implied(_) => None,
    }
}

/// Room a value may take beside the name of its input.
pub(super) fn value_room(given: &Given) -> f64 {
    let swatch = given_value(given).is_some_and(|value| value.swatch.is_some());
    let text = ROW.width(given_text(given)).min(WIDEST_VALUE);
    match given {
        Given::Implied(_) => text + 2.0 * PILL_END,
        _ if swatch => text + SWATCH + 3.0,
        _ => text,
    }
}

/// Room the name of a socket may take.
pub(super) fn name_room(name: &str) -> f64 {
    ROW.width(name).min(WIDEST_NAME)
}

/// Measures `card`.
pub(super) fn frame(card: &Card<'_>) -> Frame {
    match card.role {
        Role::Parameter => parameter_frame(card),
        Role::Node | Role::Root => rows_frame(card),
    }
}

fn parameter_frame(card: &Card<'_>) -> Frame {
    let value = card.value.as_ref();
    let swatch = value.is_some_and(|value| value.swatch.is_some());
    let text = value.map_or("", |value| &value.text);
    let second = SMALL.width(card.subtitle)
        + TEXT_GAP
        + SMALL.width(text).min(WIDEST_VALUE)
        + if swatch { SWATCH + 3.0 } else { 0.0 };
    let content = TITLE.width(card.title).max(second);
    let width = (content + 2.0 * INDENT).clamp(NARROWEST, WIDEST);
    let height = HEADER + 4.0;
    Frame { width, height, inputs: Vec::new(), outputs: vec![height / 2.0] }
}

fn rows_frame(card: &Card<'_>) -> Frame {
    let rows = card.inputs.len().max(card.outputs.len());
    let badge = card.badge.as_ref().map_or(0.0, |badge| TEXT_GAP + badge_width(badge.text));
    let badge = badge + if card.opens.is_some() { TEXT_GAP + SMALL.width(OPEN) } else { 0.0 };
    let subtitle = match card.role {
        Role::Root => 0.0,
        Role::Parameter | Role::Node => SMALL.width(card.subtitle) + badge,
    };
    // A title may be cut, the parts of a row are bounded one by one.
    let title = TITLE.width(card.title).max(subtitle).min(WIDEST - 2.0 * INDENT);
    let content = (0..rows).map(|row| row_width(card, row)).fold(title, f64::max);
    let top = header(card);
    let middle = |row: usize| top + PADDING + (row as f64 + 0.5) * ROW_HEIGHT;
    let body = if rows == 0 { 0.0 } else { 2.0 * PADDING + rows as f64 * ROW_HEIGHT };
    Frame {
        width: (content + 2.0 * INDENT).max(NARROWEST).ceil(),
        height: top + body,
        inputs: (0..card.inputs.len()).map(middle).collect(),
        outputs: (0..card.outputs.len()).map(middle).collect(),
    }
}

/// Width of the texts of a row.
fn row_width(card: &Card<'_>, row: usize) -> f64 {
    let left = card.inputs.get(row).map_or(0.0, |input| {
        let value = value_room(&input.given);
        name_room(&input.name) + if value > 0.0 { TEXT_GAP + value } else { 0.0 }
    });
    let right = card.outputs.get(row).map_or(0.0, |output| name_room(output.name));
    let gap = if left > 0.0 && right > 0.0 { 2.0 * TEXT_GAP } else { 0.0 };
    left + gap + right
}
