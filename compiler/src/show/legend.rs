//! What the colours, shapes and marks mean: those of them a drawing uses.

use std::fmt::Write;

use crate::values::Type;

use super::diagram::{Diagram, Given};
use super::look::Look;
use super::pen::{Pen, short};
use super::theme::{HEADER, MUTED, OUTLINE, PAPER, PARAMETER, SMALL, color};

/// Height of a line.
const LINE: f64 = 18.0;
/// Room for a sign, left of its text.
const SIGN: f64 = 26.0;
/// Between entries.
const GAP: f64 = 22.0;

/// What an entry explains.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Sign {
    Socket(Type),
    Guarded,
    Scoped,
    Conversion,
    Parameter,
    Implied,
    RuledOut,
    Dead,
}

impl Sign {
    fn text(self) -> &'static str {
        match self {
            Sign::Socket(value_type) => value_type.name(),
            Sign::Guarded => "evaluated only where needed",
            Sign::Scoped => "evaluated in the scope of the node",
            Sign::Conversion => "converted",
            Sign::Parameter => "interface parameter",
            Sign::Implied => "default that is evaluated, without a box",
            Sign::RuledOut => "ruled out by a constant",
            Sign::Dead => "dead: never evaluated",
        }
    }
}

/// The entries with their places.
pub(super) struct Legend {
    entries: Vec<(Sign, f64, f64)>,
    /// Height of all lines.
    pub height: f64,
}

/// The legend of a diagram, in lines of at most `width`.
pub(super) fn legend(diagram: &Diagram<'_>, width: f64) -> Legend {
    let (mut x, mut y) = (0.0, 0.0);
    let mut entries = Vec::new();
    for sign in signs(diagram) {
        let entry = SIGN + SMALL.width(sign.text());
        if x > 0.0 && x + entry > width {
            x = 0.0;
            y += LINE;
        }
        entries.push((sign, x, y));
        x += entry + GAP;
    }
    Legend { height: y + LINE, entries }
}

/// What the diagram uses.
fn signs(diagram: &Diagram<'_>) -> Vec<Sign> {
    let cards = &diagram.cards;
    let inputs = || cards.iter().flat_map(|card| &card.inputs);
    let outputs = || cards.iter().flat_map(|card| &card.outputs);
    let has = |value_type: Type| {
        inputs().any(|input| input.value_type == value_type)
            || outputs().any(|output| output.value_type == value_type)
    };
    let mut signs: Vec<Sign> =
        Type::ALL.into_iter().filter(|&value_type| has(value_type)).map(Sign::Socket).collect();
    let marks = [
        (Sign::Guarded, inputs().any(|input| input.guarded)),
        (Sign::Scoped, inputs().any(|input| input.scoped)),
        (Sign::Conversion, diagram.wires.iter().any(|wire| wire.converts)),
        (Sign::Parameter, inputs().any(|input| matches!(input.given, Given::Parameter(_)))),
        (Sign::Implied, inputs().any(|input| matches!(input.given, Given::Implied(_)))),
        (Sign::RuledOut, inputs().any(|input| input.ruled_out)),
        (Sign::Dead, cards.iter().any(|card| card.dead.is_some())),
    ];
    signs.extend(marks.iter().filter(|(_, used)| *used).map(|(sign, _)| *sign));
    signs
}

/// Writes a legend, its left top corner at the origin.
pub(super) fn write(pen: &mut Pen, legend: &Legend) {
    for &(sign, x, top) in &legend.entries {
        let y = top + LINE / 2.0;
        let (look, grey) = (Look::plain(), color(Type::Scalar));
        match sign {
            Sign::Socket(value_type) => pen.socket(x + 12.0, y, value_type, look),
            Sign::Guarded => pen.socket(x + 12.0, y, Type::Scalar, Look { hollow: true, ..look }),
            Sign::Scoped => {
                let _ = writeln!(
                    pen.svg,
                    "<path d=\"M{} {}h14\" stroke=\"{grey}\" stroke-width=\"2\" \
                     stroke-dasharray=\"4 3\"/>",
                    short(x - 6.0),
                    short(y)
                );
                pen.socket(x + 12.0, y, Type::Scalar, Look { double: true, ..look });
            }
            Sign::Conversion => pen.conversion(x + 19.0, y, false),
            Sign::Parameter => {
                let _ = writeln!(
                    pen.svg,
                    "<text x=\"{}\" y=\"{}\" font-size=\"{}\" font-style=\"italic\" \
                     fill=\"{PARAMETER}\">ab</text>",
                    short(x + 7.0),
                    short(y + 3.4),
                    SMALL.size
                );
            }
            Sign::Implied => pen.pill(x + 4.0, y, (SMALL, 18.0), (HEADER, MUTED), ("ab", "")),
            Sign::RuledOut => {
                pen.stroke(x + 2.0, y, color(Type::Scalar));
                pen.crossing_out(x + 14.0, y, false);
            }
            Sign::Dead => {
                let _ = writeln!(
                    pen.svg,
                    "<rect x=\"{}\" y=\"{}\" width=\"16\" height=\"11\" rx=\"3\" fill=\"{PAPER}\" \
                     stroke=\"{OUTLINE}\" stroke-dasharray=\"3 2\" opacity=\"0.6\"/>",
                    short(x + 5.0),
                    short(y - 5.5)
                );
            }
        }
        pen.text(x + SIGN, y, SMALL, MUTED, sign.text());
    }
}
