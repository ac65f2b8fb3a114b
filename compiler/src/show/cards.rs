//! Boxes with their rows.

use std::fmt::Write;

use super::diagram::{Card, Dead, Given, InputSocket, OutputSocket, Role};
use super::frames::{
    Frame, INDENT, OPEN, PILL_END, SWATCH, TEXT_GAP, badge_width, given_text, given_value, header,
    name_room, value_room,
};
use super::layout::Place;
use super::look::Look;
use super::pen::{Pen, short};
use super::text::Font;
use super::theme::{
    Accent, BADGE, FAINT, HEADER, INK, MUTED, OUTLINE, PAPER, PARAMETER, PARAMETER_BOX, PILL, ROOT,
    ROW, SMALL, STATE_PILL, TITLE, srgb,
};
use super::values::Value;

impl Pen {
    /// A box at its place.
    pub fn card(&mut self, card: &Card<'_>, frame: &Frame, place: Place) {
        let faded = if card.dead.is_some() { " opacity=\"0.5\"" } else { "" };
        let _ = writeln!(
            self.svg,
            "<g transform=\"translate({} {})\"{faded}>",
            short(place.x),
            short(place.y)
        );
        if let Some(expression) = card.opens {
            let _ = writeln!(self.svg, "<a href=\"#expression-{expression}\">");
        }
        self.tip(&card_tip(card));
        match card.role {
            Role::Parameter => self.parameter(card, frame),
            Role::Node | Role::Root => self.rows(card, frame),
        }
        if card.opens.is_some() {
            self.svg.push_str("</a>\n");
        }
        self.svg.push_str("</g>\n");
    }

    fn outline(&mut self, frame: &Frame, radius: f64, fill: &str, dead: bool) {
        let dash = if dead { " stroke-dasharray=\"4 3\"" } else { "" };
        let _ = writeln!(
            self.svg,
            "<rect width=\"{}\" height=\"{}\" rx=\"{radius}\" fill=\"{fill}\" \
             stroke=\"{OUTLINE}\"{dash}/>",
            short(frame.width),
            short(frame.height)
        );
    }

    fn parameter(&mut self, card: &Card<'_>, frame: &Frame) {
        self.outline(frame, frame.height / 2.0, PARAMETER_BOX, card.dead.is_some());
        let room = frame.width - 2.0 * INDENT;
        self.text(INDENT, 13.0, TITLE, PARAMETER, &TITLE.fitted(card.title, room));
        let y = 28.0;
        self.text(INDENT, y, SMALL, MUTED, card.subtitle);
        if let Some(value) = &card.value {
            let x = INDENT + SMALL.width(card.subtitle) + TEXT_GAP;
            self.value(x, y, frame.width - INDENT - x, SMALL, (INK, ""), value);
        }
        for (output, y) in card.outputs.iter().zip(&frame.outputs) {
            self.socket(frame.width, *y, output.value_type, Look::plain());
        }
    }

    fn rows(&mut self, card: &Card<'_>, frame: &Frame) {
        let top = header(card);
        self.outline(frame, 6.0, PAPER, card.dead.is_some());
        let (fill, ink) = match (card.role, &card.badge) {
            (Role::Root, _) => (ROOT, PAPER),
            (_, Some(badge)) => (badge.accent.colors().0, INK),
            (_, None) => (HEADER, INK),
        };
        let _ = writeln!(self.svg, "<path d=\"{}\" fill=\"{fill}\"/>", header_path(frame, top));
        let room = frame.width - 2.0 * INDENT;
        let title = TITLE.fitted(card.title, room);
        if card.opens.is_some() {
            // What a click does is told where the type of a node stands.
            let badge = card.badge.as_ref().map_or(0.0, |badge| badge_width(badge.text));
            let x = frame.width - INDENT - badge - SMALL.width(OPEN);
            self.text(x, 25.5, SMALL, PARAMETER, OPEN);
        }
        if card.role == Role::Root {
            self.text(INDENT, top / 2.0, TITLE, ink, &title);
        } else {
            self.text(INDENT, 12.5, TITLE, ink, &title);
            self.second_line(card, frame);
        }
        for (input, y) in card.inputs.iter().zip(&frame.inputs) {
            self.input(input, *y);
        }
        for (output, y) in card.outputs.iter().zip(&frame.outputs) {
            self.output(output, frame.width, *y);
        }
    }

    fn second_line(&mut self, card: &Card<'_>, frame: &Frame) {
        let y = 25.5;
        let mut room = frame.width - 2.0 * INDENT;
        if let Some(badge) = &card.badge {
            let width = badge_width(badge.text);
            let x = frame.width - 6.0 - width;
            room -= width + TEXT_GAP - (INDENT - 6.0);
            let dark = badge.accent.colors().1;
            // Hollow where only a default asks.
            let colors = if badge.by_default { (PAPER, dark) } else { (dark, PAPER) };
            self.pill(x, y, (BADGE, width), colors, (badge.text, ""));
        }
        self.text(INDENT, y, SMALL, MUTED, &SMALL.fitted(card.subtitle, room));
    }

    fn input(&mut self, input: &InputSocket, y: f64) {
        let wired = matches!(input.given, Given::Wire | Given::Parameter(_));
        let look = Look { hollow: input.guarded, double: input.scoped, small: !wired };
        self.socket(0.0, y, input.value_type, look);
        let ink = if matches!(input.given, Given::Default(_)) { FAINT } else { INK };
        let room = name_room(&input.name);
        self.text(INDENT, y, ROW, ink, &ROW.fitted(&input.name, room));
        let x = INDENT + room + TEXT_GAP;
        let width = value_room(&input.given);
        let (fill, slant) = match &input.given {
            Given::Wire => return,
            Given::Parameter(_) => (PARAMETER, " font-style=\"italic\""),
            Given::Literal(_) => (INK, ""),
            Given::Default(_) | Given::Implied(_) => (FAINT, ""),
        };
        let struck = if input.ruled_out { " text-decoration=\"line-through\"" } else { "" };
        let style = format!("{slant}{struck}");
        match (&input.given, given_value(&input.given)) {
            (Given::Implied(implied), _) => {
                let text = ROW.fitted(&implied.text, width - 2.0 * PILL_END);
                let live = implied.accent.filter(|_| !input.ruled_out);
                let colors = live.map_or((PILL, MUTED), |accent| match accent {
                    // The state is read everywhere: it must not shout.
                    Accent::State => (STATE_PILL, accent.colors().1),
                    _ => accent.colors(),
                });
                self.pill(x, y, (ROW, width), colors, (&text, &style));
            }
            (_, Some(value)) => self.value(x, y, width, ROW, (fill, &style), value),
            (_, None) => {
                let text = ROW.fitted(given_text(&input.given), width);
                self.styled_text(x, y, ROW, fill, &style, &text);
            }
        }
    }

    fn value(
        &mut self,
        mut x: f64,
        y: f64,
        mut room: f64,
        font: Font,
        (fill, style): (&str, &str),
        value: &Value,
    ) {
        if let Some(linear) = value.swatch {
            let _ = writeln!(
                self.svg,
                "<rect x=\"{}\" y=\"{}\" width=\"{SWATCH}\" height=\"{SWATCH}\" fill=\"{}\" \
                 stroke=\"{OUTLINE}\" stroke-width=\"0.7\"/>",
                short(x),
                short(y - SWATCH / 2.0),
                srgb(linear)
            );
            x += SWATCH + 3.0;
            room -= SWATCH + 3.0;
        }
        self.styled_text(x, y, font, fill, style, &font.fitted(&value.text, room));
    }

    fn output(&mut self, output: &OutputSocket<'_>, width: f64, y: f64) {
        let room = name_room(output.name);
        let name = ROW.fitted(output.name, room);
        self.styled_text(width - INDENT, y, ROW, MUTED, " text-anchor=\"end\"", &name);
        self.socket(width, y, output.value_type, Look::plain());
    }
}

/// The inside of a header, rounded where the box is.
fn header_path(frame: &Frame, top: f64) -> String {
    let inner = short(frame.width - 11.0);
    if frame.height > top {
        return format!("M.5 {top}V5.5a5 5 0 0 1 5 -5h{inner}a5 5 0 0 1 5 5V{top}z");
    }
    let low = short(top - 5.5);
    format!(
        "M.5 5.5a5 5 0 0 1 5 -5h{inner}a5 5 0 0 1 5 5V{low}a5 5 0 0 1 -5 5h-{inner}\
         a5 5 0 0 1 -5 -5z"
    )
}

/// What is told of a card to those who point at it.
fn card_tip(card: &Card<'_>) -> String {
    let mut text = match card.role {
        Role::Root => format!("root {}", card.title),
        Role::Parameter | Role::Node => format!("{}: {}", card.title, card.subtitle),
    };
    match card.dead {
        Some(Dead::Unreached) => text.push_str(" (dead: no root reaches it)"),
        Some(Dead::RuledOut) => text.push_str(" (dead: constants rule out all that reads it)"),
        None => {}
    }
    if let Some(value) = &card.value {
        let _ = write!(text, " = {}", value.text);
    }
    for input in &card.inputs {
        let given = match &input.given {
            Given::Implied(implied) => &implied.told,
            given => given_text(given),
        };
        if !given.is_empty() {
            let ruled_out = if input.ruled_out { " (never evaluated)" } else { "" };
            let _ = write!(text, "\n{} = {given}{ruled_out}", input.name);
        }
    }
    if !card.doc.is_empty() {
        let _ = write!(text, "\n\n{}", card.doc);
    }
    text
}
