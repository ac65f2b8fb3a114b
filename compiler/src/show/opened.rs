//! The inside of the box of an expression, as a drawing of its own: a panel that a click on the box opens. It takes no
//! script: a link names the panel, and style shows what is named. A viewer without style shows the closed boxes.

use std::collections::HashMap;
use std::fmt::Write;

use crate::graph::Graph;

use super::ShowError;
use super::diagram::{Card, Diagram, Given, InputSocket, OutputSocket, Role, Wire};
use super::expressions::groups;
use super::layout::{Layout, Place, layout};
use super::pen::{Pen, short};
use super::theme::{INK, OUTLINE, PAGE, PARAMETER, SMALL, TITLE};
use super::wires::wires;

/// Hides panels but the one that the address of the drawing names.
pub(super) const STYLE: &str = "<style>.panel{display:none}.panel:target{display:inline}a:hover rect{stroke:#1a5fb4}</style>\n";

/// Round what a panel shows.
const MARGIN: f64 = 16.0;
/// Height of its heading.
const HEADING_HEIGHT: f64 = 26.0;
/// Narrowest panel: text and link must find room.
const NARROWEST: f64 = 220.0;
/// What closes a panel.
const CLOSE: &str = "close";

/// The inside of a box.
pub(super) struct Panel<'a> {
    /// The expression, by position in the graph: what a card opens.
    expression: usize,
    text: &'a str,
    diagram: Diagram<'a>,
    layout: Layout,
}

/// The inside of each box of `graph`, of whose nodes `open` is the diagram.
pub(super) fn panels<'a>(
    open: &Diagram<'a>,
    graph: &'a Graph,
) -> Result<Vec<Panel<'a>>, ShowError> {
    let groups = groups(open, graph);
    let mut panels = Vec::new();
    for (expression, of) in graph.expressions.iter().enumerate() {
        // One that only names something became no node, and has no box.
        if groups.contains(&Some(expression)) {
            let diagram = inside(open, graph, &groups, expression);
            let layout = layout(&diagram)?;
            panels.push(Panel { expression, text: &of.text, diagram, layout });
        }
    }
    Ok(panels)
}

/// The nodes of an expression, with what they read at the left, and what is read of them at the right.
fn inside<'a>(
    open: &Diagram<'a>,
    graph: &'a Graph,
    groups: &[Option<usize>],
    expression: usize,
) -> Diagram<'a> {
    let within = |card: usize| groups[card] == Some(expression);
    let (mut sources, mut results) = (Vec::new(), Vec::new());
    for wire in &open.wires {
        let list = match (within(wire.from.0), within(wire.to.0)) {
            (false, true) => &mut sources,
            (true, false) => &mut results,
            _ => continue,
        };
        if !list.contains(&wire.from) {
            list.push(wire.from);
        }
    }
    let mut cards: Vec<Card<'a>> = Vec::new();
    for &(card, output) in &sources {
        let text = groups[card].map(|group| graph.expressions[group].text.as_str());
        cards.push(source(&open.cards[card], output, text));
    }
    let mut places = HashMap::new();
    for card in (0..open.cards.len()).filter(|&card| within(card)) {
        places.insert(card, cards.len());
        cards.push(own(&open.cards[card]));
    }
    let end = cards.len();
    cards.push(value(open, &results));
    let mut wires = Vec::new();
    for wire in &open.wires {
        let from = places.get(&wire.from.0).map(|&card| (card, wire.from.1));
        let to = places.get(&wire.to.0).map(|&card| (card, wire.to.1));
        let place = |list: &[(usize, usize)]| list.iter().position(|known| *known == wire.from);
        match (from, to) {
            (Some(from), Some(to)) => wires.push(Wire { from, to, ..*wire }),
            (None, Some(to)) => {
                let source = place(&sources).map(|at| (at, 0));
                wires.extend(source.map(|from| Wire { from, to, ..*wire }));
            }
            (Some(from), None) => {
                let to = place(&results).map(|at| (end, at));
                let new = to.filter(|to| !wires.iter().any(|wire: &Wire| wire.to == *to));
                wires.extend(new.map(|to| Wire { from, to, converts: false, ..*wire }));
            }
            (None, None) => {}
        }
    }
    Diagram { name: open.name, wires, parameters: sources.len(), nodes: places.len(), cards }
}

/// What an expression reads: a node's output, a parameter, or another expression with its text.
fn source<'a>(of: &Card<'a>, output: usize, text: Option<&'a str>) -> Card<'a> {
    let output = &of.outputs[output];
    let (title, subtitle) = match (text, of.role) {
        (Some(text), _) => (text, "expression"),
        (None, Role::Parameter) => (of.title, of.subtitle),
        (None, _) => (of.title, output.name),
    };
    Card {
        role: Role::Parameter,
        title,
        subtitle,
        badge: None,
        inputs: Vec::new(),
        outputs: vec![OutputSocket { name: "", value_type: output.value_type }],
        opens: None,
        ..of.clone()
    }
}

/// A node of the expression: its name is none of the file's, so its type is told.
fn own<'a>(of: &Card<'a>) -> Card<'a> {
    Card { title: of.subtitle, subtitle: "", opens: None, ..of.clone() }
}

/// What is read of an expression.
fn value<'a>(open: &Diagram<'a>, results: &[(usize, usize)]) -> Card<'a> {
    let input = |&(card, output): &(usize, usize)| InputSocket {
        name: "value".into(),
        value_type: open.cards[card].outputs[output].value_type,
        guarded: false,
        scoped: false,
        ruled_out: false,
        given: Given::Wire,
    };
    Card {
        role: Role::Root,
        title: "expression",
        subtitle: "",
        doc: "",
        badge: None,
        dead: None,
        value: None,
        inputs: results.iter().map(input).collect(),
        outputs: Vec::new(),
        opens: None,
    }
}

impl Panel<'_> {
    /// Its width and height.
    pub fn size(&self) -> (f64, f64) {
        let width = self.layout.width.max(NARROWEST);
        (width + 2.0 * MARGIN, self.layout.height + HEADING_HEIGHT + 2.0 * MARGIN)
    }

    /// The box that opens it, by position among the cards of a drawing.
    fn card(&self, of: &Diagram<'_>) -> Option<usize> {
        of.cards.iter().position(|card| card.opens == Some(self.expression))
    }
}

/// Writes panels over a drawing, each below its box as far as the room allows.
pub(super) fn write(
    pen: &mut Pen,
    panels: &[Panel<'_>],
    (of, over): (&Diagram<'_>, &Layout),
    room: (f64, f64),
) {
    for panel in panels {
        let Some(card) = panel.card(of) else { continue };
        let (place, frame) = (over.places[card], &over.frames[card]);
        let (width, height) = panel.size();
        let left = place.x + frame.width / 2.0 - width / 2.0;
        let x = left.min(room.0 - width).max(0.0);
        let y = (place.y + frame.height + 6.0).min(room.1 - height).max(0.0);
        pen.panel(panel, Place { x, y });
    }
}

impl Pen {
    fn panel(&mut self, panel: &Panel<'_>, place: Place) {
        let (width, height) = panel.size();
        let _ = writeln!(
            self.svg,
            "<g id=\"expression-{}\" class=\"panel\" display=\"none\" transform=\"translate({} {})\">\n\
             <rect width=\"{}\" height=\"{}\" rx=\"8\" fill=\"{PAGE}\" stroke=\"{OUTLINE}\" stroke-width=\"1.5\"/>",
            panel.expression,
            short(place.x),
            short(place.y),
            short(width),
            short(height),
        );
        let closing = SMALL.width(CLOSE);
        let right = width - MARGIN - closing;
        let text = TITLE.fitted(panel.text, right - 2.0 * MARGIN);
        self.text(MARGIN, MARGIN + 4.0, TITLE, INK, &text);
        self.svg.push_str("<a href=\"#\">\n");
        self.text(right, MARGIN + 4.0, SMALL, PARAMETER, CLOSE);
        self.svg.push_str("</a>\n");
        let top = short(MARGIN + HEADING_HEIGHT);
        let _ = writeln!(self.svg, "<g transform=\"translate({} {top})\">", short(MARGIN));
        wires(self, &panel.diagram, &panel.layout);
        let Panel { diagram, layout, .. } = panel;
        for ((card, frame), place) in diagram.cards.iter().zip(&layout.frames).zip(&layout.places) {
            self.card(card, frame, *place);
        }
        self.svg.push_str("</g>\n</g>\n");
    }
}
