//! A laid out diagram as SVG.

use std::collections::HashSet;
use std::fmt::Write;

use crate::graph::Graph;
use crate::nodes::NodeLibrary;

use super::dead::Dead;
use super::diagram::{Card, Diagram, Given, InputSocket, OutputSocket, Role, Wire};
use super::error::{MAX_BOXES, ShowError};
use super::escape::xml;
use super::frames::{
    Frame, INDENT, PILL_END, SWATCH, TEXT_GAP, badge_width, given_text, given_value, header,
    name_room,
};
use super::layout::{Layout, Place, Track, layout};
use super::legend;
use super::marks::Look;
use super::text::Font;
use super::theme::{
    Accent, BADGE, FAINT, FAMILY, HEADER, HEADING, INK, MUTED, OUTLINE, PAGE, PAPER, PARAMETER,
    PARAMETER_BOX, PILL, ROOT, ROW, SMALL, STATE_PILL, TITLE, color, srgb,
};
use super::values::Value;

/// Round the drawing.
const MARGIN: f64 = 24.0;
/// Height of the heading.
const HEADING_HEIGHT: f64 = 52.0;
/// Narrowest page: the legend must find room.
const NARROWEST_PAGE: f64 = 480.0;
/// Most characters of a text shown to those who point at something.
const LONGEST_TIP: usize = 4_000;

/// Draws `graph` as an SVG document: parameters at the left, roots at the right, wires between
/// sockets in the colour of the type they carry, with a legend. What is never evaluated is
/// faded.
///
/// # Errors
/// More than [`MAX_BOXES`] boxes, or a graph that was not checked with `library`.
pub fn draw_svg(graph: &Graph, library: &NodeLibrary) -> Result<String, ShowError> {
    let diagram = Diagram::with_limit(graph, library, MAX_BOXES)?;
    Ok(write(&diagram, &layout(&diagram)?))
}

/// The document of a laid out diagram.
pub(super) fn write(diagram: &Diagram<'_>, layout: &Layout) -> String {
    let inner = layout.width.max(NARROWEST_PAGE);
    let legend = legend::legend(diagram, inner);
    let width = (inner + 2.0 * MARGIN).ceil();
    let legend_top = MARGIN + HEADING_HEIGHT + layout.height + 28.0;
    let height = (legend_top + legend.height + MARGIN).ceil();
    let mut pen = Pen { svg: String::new() };
    let _ = write!(
        pen.svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" role=\"img\" font-family=\"{FAMILY}\">\n\
         <title>{}</title>\n<rect width=\"{width}\" height=\"{height}\" fill=\"{PAGE}\"/>\n",
        xml(&tip(diagram.name)),
    );
    heading(&mut pen, diagram, inner);
    let _ = writeln!(
        pen.svg,
        "<g transform=\"translate({} {})\">",
        short(MARGIN),
        short(MARGIN + HEADING_HEIGHT)
    );
    wires(&mut pen, diagram, layout);
    for ((card, frame), place) in diagram.cards.iter().zip(&layout.frames).zip(&layout.places) {
        pen.card(card, frame, *place);
    }
    pen.svg.push_str("</g>\n");
    let _ =
        writeln!(pen.svg, "<g transform=\"translate({} {})\">", short(MARGIN), short(legend_top));
    legend::write(&mut pen, &legend);
    pen.svg.push_str("</g>\n</svg>\n");
    pen.svg
}

fn heading(pen: &mut Pen, diagram: &Diagram<'_>, width: f64) {
    let name = HEADING.fitted(diagram.name, width);
    pen.text(MARGIN, MARGIN + 14.0, HEADING, INK, &name);
    let count = |number: usize, one: &str| match number {
        1 => format!("1 {one}"),
        _ => format!("{number} {one}s"),
    };
    let mut counts = vec![count(diagram.nodes, "node")];
    if diagram.parameters > 0 {
        counts.push(count(diagram.parameters, "parameter"));
    }
    let dead = diagram.cards.iter().filter(|card| card.dead.is_some()).count();
    if dead > 0 {
        counts.push(format!("{dead} dead"));
    }
    pen.text(MARGIN, MARGIN + 31.0, SMALL, MUTED, &counts.join(" · "));
}

/// Wires of one output share a light edge that sets them off from those they cross.
fn wires(pen: &mut Pen, diagram: &Diagram<'_>, layout: &Layout) {
    let mut order: Vec<usize> = (0..diagram.wires.len()).collect();
    // Stable: within an output the order of the file.
    order.sort_by_key(|&at| (!diagram.wires[at].dead, diagram.wires[at].from));
    for group in order.chunk_by(|&a, &b| {
        let key = |at: usize| (diagram.wires[at].dead, diagram.wires[at].from);
        key(a) == key(b)
    }) {
        let tracks = || group.iter().map(|&at| &layout.tracks[at]);
        if tracks().all(|track| track.is_empty()) {
            continue;
        }
        let halo: String = tracks().map(curve).collect();
        let _ = writeln!(
            pen.svg,
            "<path d=\"{halo}\" fill=\"none\" stroke=\"{PAGE}\" stroke-width=\"5\"/>"
        );
        for &at in group {
            if !layout.tracks[at].is_empty() {
                pen.wire(diagram, &diagram.wires[at], &layout.tracks[at]);
            }
        }
    }
    // Outputs that have a wire already, or their sign.
    let drawn = diagram.wires.iter().zip(&layout.tracks).filter(|(_, track)| !track.is_empty());
    let mut told: HashSet<(usize, usize)> = drawn.map(|(wire, _)| wire.from).collect();
    for (wire, track) in diagram.wires.iter().zip(&layout.tracks) {
        if track.is_empty() {
            let (place, frame) = (&layout.places[wire.to.0], &layout.frames[wire.to.0]);
            let value_type = diagram.cards[wire.from.0].outputs[wire.from.1].value_type;
            let y = place.y + frame.inputs[wire.to.1];
            pen.stub(place.x, y, value_type, wire.dead);
            let (place, frame) = (&layout.places[wire.from.0], &layout.frames[wire.from.0]);
            if told.insert(wire.from) {
                let y = place.y + frame.outputs[wire.from.1];
                let dead = diagram.cards[wire.from.0].dead.is_some();
                pen.stub_out(place.x + frame.width, y, value_type, dead);
            }
            let place = &layout.places[wire.to.0];
            if wire.ruled_out {
                pen.crossing_out(place.x - 8.0, y, diagram.cards[wire.to.0].dead.is_some());
            }
        }
    }
}

/// The path of a track.
fn curve(track: &Track) -> String {
    let mut path = String::new();
    for (at, pair) in track.chunks(2).enumerate() {
        let [from, to] = pair else { continue };
        if let Some(last) = at.checked_sub(1).and_then(|before| track.get(2 * before + 1)) {
            let middle = short((last.x + from.x) / 2.0);
            let _ = write!(
                path,
                "C{middle} {} {middle} {} {} {}",
                short(last.y),
                short(from.y),
                short(from.x),
                short(from.y)
            );
        } else {
            let _ = write!(path, "M{} {}", short(from.x), short(from.y));
        }
        if to.x != from.x {
            let _ = write!(path, "H{}", short(to.x));
        }
    }
    path
}

/// Writes elements.
pub(super) struct Pen {
    /// What is written so far.
    pub svg: String,
}

impl Pen {
    /// Text whose middle is at `y`.
    pub fn text(&mut self, x: f64, y: f64, font: Font, fill: &str, text: &str) {
        self.styled_text(x, y, font, fill, "", text);
    }

    /// The same with further attributes.
    pub fn styled_text(&mut self, x: f64, y: f64, font: Font, fill: &str, style: &str, text: &str) {
        let weight = if font.bold { " font-weight=\"700\"" } else { "" };
        let _ = writeln!(
            self.svg,
            "<text x=\"{}\" y=\"{}\" font-size=\"{}\"{weight} fill=\"{fill}\"{style} \
             xml:space=\"preserve\">{}</text>",
            short(x),
            short(y + font.size * 0.35),
            short(font.size),
            xml(text)
        );
    }

    fn tip(&mut self, text: &str) {
        let _ = writeln!(self.svg, "<title>{}</title>", xml(&tip(text)));
    }

    fn wire(&mut self, diagram: &Diagram<'_>, wire: &Wire, track: &Track) {
        let (source, target) = (&diagram.cards[wire.from.0], &diagram.cards[wire.to.0]);
        let (output, input) = (&source.outputs[wire.from.1], &target.inputs[wire.to.1]);
        let dash = match (wire.dead, input.scoped) {
            (true, _) => " stroke-dasharray=\"3 4\" opacity=\"0.5\"",
            (false, true) => " stroke-dasharray=\"7 4\"",
            (false, false) => "",
        };
        let _ = writeln!(
            self.svg,
            "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{dash}>",
            curve(track),
            color(output.value_type)
        );
        let from = match output.name {
            "" => source.title.to_owned(),
            name => format!("{}.{name}", source.title),
        };
        let converted = if wire.converts {
            format!(", {} to {}", output.value_type.name(), input.value_type.name())
        } else {
            String::new()
        };
        let dead = match (wire.ruled_out, wire.dead) {
            (true, _) => ": never evaluated, a constant rules it out",
            (false, true) => ": dead",
            (false, false) => "",
        };
        self.tip(&format!("{from} → {}.{}{converted}{dead}", target.title, input.name));
        self.svg.push_str("</path>\n");
        let Some(end) = track.last() else { return };
        if wire.ruled_out {
            self.crossing_out(end.x - 14.0, end.y, target.dead.is_some());
        } else if wire.converts {
            self.conversion(end.x - 9.0, end.y, wire.dead);
        }
    }

    fn card(&mut self, card: &Card<'_>, frame: &Frame, place: Place) {
        let faded = if card.dead.is_some() { " opacity=\"0.5\"" } else { "" };
        let _ = writeln!(
            self.svg,
            "<g transform=\"translate({} {})\"{faded}>",
            short(place.x),
            short(place.y)
        );
        self.tip(&card_tip(card));
        match card.role {
            Role::Parameter => self.parameter(card, frame),
            Role::Node | Role::Root => self.rows(card, frame),
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
        let room = name_room(input.name);
        self.text(INDENT, y, ROW, ink, &ROW.fitted(input.name, room));
        let x = INDENT + room + TEXT_GAP;
        let width = super::frames::value_room(&input.given);
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

/// `text`, cut where it is absurdly long.
fn tip(text: &str) -> String {
    text.chars().take(LONGEST_TIP).collect()
}

/// A coordinate with a tenth of a pixel.
pub(super) fn short(x: f64) -> String {
    let text = format!("{x:.1}");
    let text = text.strip_suffix(".0").unwrap_or(&text);
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
