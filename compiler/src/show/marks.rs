//! The small signs of a drawing: sockets, pills, and marks on wires.

use std::fmt::Write;

use crate::values::Type;

use super::look::Look;
use super::pen::{Pen, short};
use super::text::Font;
use super::theme::{INK, PAPER, RULED_OUT, Shape, color, shape};

impl Pen {
    /// What is left of a parameter's wire that is not drawn, before the socket at `x`.
    pub fn stub(&mut self, x: f64, y: f64, value_type: Type, dead: bool) {
        let faded = if dead { " opacity=\"0.5\"" } else { "" };
        let _ = writeln!(
            self.svg,
            "<path d=\"M{} {}v8m0 -4h14\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{faded}/>",
            short(x - 14.0),
            short(y - 4.0),
            color(value_type)
        );
    }

    /// The same behind the socket the wire would start from.
    pub fn stub_out(&mut self, x: f64, y: f64, value_type: Type, dead: bool) {
        let faded = if dead { " opacity=\"0.5\"" } else { "" };
        let _ = writeln!(
            self.svg,
            "<path d=\"M{} {}h14m0 -4v8\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{faded}/>",
            short(x),
            short(y),
            color(value_type)
        );
    }

    /// A mark on a wire whose value changes type; its tip is at `x`.
    pub fn conversion(&mut self, x: f64, y: f64, dead: bool) {
        let faded = if dead { " opacity=\"0.5\"" } else { "" };
        let _ = writeln!(
            self.svg,
            "<path d=\"M{} {}l5 4.5l-5 4.5M{} {}l5 4.5l-5 4.5\" fill=\"none\" stroke=\"{INK}\" \
             stroke-width=\"1.6\"{faded}/>",
            short(x - 10.0),
            short(y - 4.5),
            short(x - 5.0),
            short(y - 4.5)
        );
    }

    /// A piece of a dead wire, for the legend.
    pub fn stroke(&mut self, x: f64, y: f64, stroke: &str) {
        let _ = writeln!(
            self.svg,
            "<path d=\"M{} {}h21\" fill=\"none\" stroke=\"{stroke}\" stroke-width=\"2\" \
             stroke-dasharray=\"3 4\" opacity=\"0.6\"/>",
            short(x),
            short(y)
        );
    }

    /// A cross over a wire whose input constants rule out.
    pub fn crossing_out(&mut self, x: f64, y: f64, dead: bool) {
        let faded = if dead { " opacity=\"0.5\"" } else { "" };
        let _ = writeln!(
            self.svg,
            "<path d=\"M{} {}l9 9m-9 0l9 -9\" fill=\"none\" stroke=\"{RULED_OUT}\" \
             stroke-width=\"2.2\" stroke-linecap=\"round\"{faded}/>",
            short(x - 4.5),
            short(y - 4.5)
        );
    }

    /// Text in a pill of that inner width, its left end at `x`.
    pub fn pill(
        &mut self,
        x: f64,
        y: f64,
        (font, width): (Font, f64),
        (fill, ink): (&str, &str),
        (text, style): (&str, &str),
    ) {
        let _ = writeln!(
            self.svg,
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"13\" rx=\"6.5\" fill=\"{fill}\"/>",
            short(x),
            short(y - 6.5),
            short(width)
        );
        let style = format!(" text-anchor=\"middle\"{style}");
        self.styled_text(x + width / 2.0, y, font, ink, &style, text);
    }

    /// A socket round a point.
    pub fn socket(&mut self, x: f64, y: f64, value_type: Type, look: Look) {
        let stroke = color(value_type);
        let fill = if look.hollow { PAPER } else { stroke };
        let radius = if look.small { 3.4 } else { 4.6 };
        if look.double {
            let outer = path(shape(value_type), x, y, radius + 3.4);
            let _ = writeln!(
                self.svg,
                "<path d=\"{outer}\" fill=\"{PAPER}\" stroke=\"{stroke}\" stroke-width=\"1.3\"/>"
            );
        }
        let inner = path(shape(value_type), x, y, radius);
        let edge = if look.hollow { stroke } else { PAPER };
        let width = if look.hollow { "1.8" } else { "1" };
        let _ = writeln!(
            self.svg,
            "<path d=\"{inner}\" fill=\"{fill}\" stroke=\"{edge}\" stroke-width=\"{width}\"/>"
        );
    }
}

/// The outline of a shape of about the area of a circle of radius `r`.
fn path(shape: Shape, x: f64, y: f64, r: f64) -> String {
    let polygon = |corners: &[(f64, f64)]| {
        let mut path = String::new();
        for (at, (dx, dy)) in corners.iter().enumerate() {
            let letter = if at == 0 { 'M' } else { 'L' };
            let _ = write!(path, "{letter}{} {}", short(x + dx * r), short(y + dy * r));
        }
        path + "z"
    };
    match shape {
        Shape::Circle => {
            let (left, d) = (short(x - r), short(2.0 * r));
            format!("M{left} {}a{r} {r} 0 1 0 {d} 0a{r} {r} 0 1 0 -{d} 0z", short(y))
        }
        Shape::Diamond => polygon(&[(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)]),
        Shape::Square => polygon(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)]),
        Shape::Triangle => polygon(&[(-1.0, -1.15), (1.25, 0.0), (-1.0, 1.15)]),
        Shape::Hexagon => polygon(&[
            (-1.15, 0.0),
            (-0.57, -1.0),
            (0.57, -1.0),
            (1.15, 0.0),
            (0.57, 1.0),
            (-0.57, 1.0),
        ]),
    }
}
