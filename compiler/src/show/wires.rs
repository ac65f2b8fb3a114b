//! Wires, and what is left of those that are not drawn.

use std::collections::HashSet;
use std::fmt::Write;

use super::diagram::{Diagram, Wire};
use super::layout::{Layout, Track};
use super::pen::{Pen, short};
use super::theme::{PAGE, color};

/// Wires of one output share a light edge that sets them off from those they cross.
pub(super) fn wires(pen: &mut Pen, diagram: &Diagram<'_>, layout: &Layout) {
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

impl Pen {
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
}
