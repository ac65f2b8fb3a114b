//! A laid out diagram as SVG.

use std::fmt::Write;

use crate::graph::Graph;

use super::build::open_diagram;
use super::diagram::Diagram;
use super::error::{MAX_BOXES, ShowError};
use super::escape::xml;
use super::expressions::close;
use super::layout::{Layout, layout};
use super::legend;
use super::opened::{self, Panel, STYLE, panels};
use super::pen::{Pen, short, tip};
use super::theme::{FAMILY, HEADING, INK, MUTED, PAGE, SMALL};
use super::wires::wires;

/// Round the drawing.
const MARGIN: f64 = 24.0;
/// Height of the heading.
const HEADING_HEIGHT: f64 = 52.0;
/// Narrowest page: the legend must find room.
const NARROWEST_PAGE: f64 = 480.0;
/// Draws `graph` as an SVG document: parameters at the left, roots at the right, wires between
/// sockets in the colour of the type they carry, with a legend. What is never evaluated is
/// faded.
///
/// # Errors
/// More than [`MAX_BOXES`] boxes, or a graph that was not checked.
pub fn draw_svg(graph: &Graph) -> Result<String, ShowError> {
    let open = open_diagram(graph, MAX_BOXES)?;
    let diagram = close(&open, graph);
    Ok(write(&diagram, &layout(&diagram)?, &panels(&open, graph)?))
}

/// The document of a laid out diagram, with a panel for each box that opens.
pub(super) fn write(diagram: &Diagram<'_>, layout: &Layout, panels: &[Panel<'_>]) -> String {
    let sizes = || panels.iter().map(Panel::size);
    let widest = sizes().map(|(width, _)| width).fold(NARROWEST_PAGE, f64::max);
    let inner = layout.width.max(widest);
    let legend = legend::legend(diagram, inner);
    let width = (inner + 2.0 * MARGIN).ceil();
    let legend_top = MARGIN + HEADING_HEIGHT + layout.height + 28.0;
    // Panels may cover the legend.
    let room =
        sizes().map(|(_, height)| height).fold(layout.height + 28.0 + legend.height, f64::max);
    let height = (MARGIN + HEADING_HEIGHT + room + MARGIN).ceil();
    let mut pen = Pen { svg: String::new() };
    let _ = write!(
        pen.svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" role=\"img\" font-family=\"{FAMILY}\">\n\
         <title>{}</title>\n<rect width=\"{width}\" height=\"{height}\" fill=\"{PAGE}\"/>\n",
        xml(&tip(diagram.name)),
    );
    if !panels.is_empty() {
        pen.svg.push_str(STYLE);
    }
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
    pen.svg.push_str("</g>\n");
    if !panels.is_empty() {
        let (x, y) = (short(MARGIN), short(MARGIN + HEADING_HEIGHT));
        let _ = writeln!(pen.svg, "<g transform=\"translate({x} {y})\">");
        opened::write(&mut pen, panels, (diagram, layout), (inner, room));
        pen.svg.push_str("</g>\n");
    }
    pen.svg.push_str("</svg>\n");
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
