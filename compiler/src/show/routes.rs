//! Which columns each wire passes, as vertices one column apart from each other.

use super::diagram::{Diagram, Role};
use super::frames::Frame;

/// Height kept free for a wire that passes a column.
const LANE: f64 = 8.0;
/// Most bends of a drawing; past it the longest wires run straight, behind the boxes.
const MAX_BENDS: usize = 60_000;
/// Columns a parameter's wire may cross. Longer ones are not drawn: its name stands at the input.
const PARAMETER_REACH: usize = 3;

/// What takes room in a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Body {
    /// This card.
    Card(usize),
    /// A wire that passes.
    Bend,
}

/// Something that takes room in a column.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vertex {
    /// What it is.
    pub body: Body,
    /// Its column.
    pub layer: usize,
    /// Its height.
    pub height: f64,
}

/// A wire, or what several wires from one output share, from a column to the next.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment {
    /// Left vertex.
    pub from: usize,
    /// Where it leaves it, from its middle.
    pub from_offset: f64,
    /// Right vertex.
    pub to: usize,
    /// Where it meets it, from its middle.
    pub to_offset: f64,
    /// How much it wants to be level.
    pub weight: f64,
}

/// How a wire is drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Route {
    /// Through these bends.
    Through(Vec<usize>),
    /// Straight, behind what is in its way.
    Straight,
    /// Not at all: the row of the input tells the parameter.
    Named,
}

/// Vertices, segments and the way of each wire.
pub(super) struct Routes {
    /// Cards first, by their positions; then bends.
    pub vertices: Vec<Vertex>,
    /// Between vertices of neighbouring columns.
    pub segments: Vec<Segment>,
    /// One for each wire.
    pub routes: Vec<Route>,
}

/// Where a wire from one output passes; wires from the same output share it.
#[derive(Clone, Default)]
struct Trunk {
    /// A bend for each column, from the one right of the card.
    bends: Vec<usize>,
}

/// Finds the ways of all wires.
pub(super) fn routes(diagram: &Diagram<'_>, frames: &[Frame], layers: &[usize]) -> Routes {
    let cards = frames.iter().zip(layers).enumerate();
    let vertices = cards.map(|(card, (frame, &layer))| Vertex {
        body: Body::Card(card),
        layer,
        height: frame.height,
    });
    let mut all = Routes { vertices: vertices.collect(), segments: Vec::new(), routes: Vec::new() };
    let reach = reach(diagram, layers);
    let mut trunks: Vec<Vec<Trunk>> =
        diagram.cards.iter().map(|card| vec![Trunk::default(); card.outputs.len()]).collect();
    for wire in &diagram.wires {
        let (from, output) = wire.from;
        let (to, input) = wire.to;
        let passed = layers[to] - layers[from] - 1;
        let route = if diagram.cards[from].role == Role::Parameter && passed > PARAMETER_REACH {
            Route::Named
        } else if passed > reach {
            Route::Straight
        } else {
            let start = frames[from].outputs[output] - frames[from].height / 2.0;
            let end = frames[to].inputs[input] - frames[to].height / 2.0;
            let trunk = &mut trunks[from][output];
            all.grow(trunk, (from, start), layers[from], passed);
            let (last, offset) = match passed {
                0 => (from, start),
                _ => (trunk.bends[passed - 1], 0.0),
            };
            let weight = if passed == 0 { 1.0 } else { 2.0 };
            let ends = Segment { from: last, from_offset: offset, to, to_offset: end, weight };
            all.segments.push(ends);
            Route::Through(trunk.bends[..passed].to_vec())
        };
        all.routes.push(route);
    }
    all
}

impl Routes {
    /// Lengthens a trunk to `length` bends.
    fn grow(&mut self, trunk: &mut Trunk, start: (usize, f64), layer: usize, length: usize) {
        while trunk.bends.len() < length {
            let bend = self.vertices.len();
            let layer = layer + 1 + trunk.bends.len();
            self.vertices.push(Vertex { body: Body::Bend, layer, height: LANE });
            let (from, from_offset, weight) = match trunk.bends.last() {
                Some(&last) => (last, 0.0, 8.0),
                None => (start.0, start.1, 2.0),
            };
            self.segments.push(Segment { from, from_offset, to: bend, to_offset: 0.0, weight });
            trunk.bends.push(bend);
        }
    }
}

/// Most columns a wire may pass so that there are no more than [`MAX_BENDS`] bends.
fn reach(diagram: &Diagram<'_>, layers: &[usize]) -> usize {
    let mut passed: Vec<usize> =
        diagram.wires.iter().map(|wire| layers[wire.to.0] - layers[wire.from.0] - 1).collect();
    passed.sort_unstable();
    // Wires that share a trunk are counted apart: the bound errs on the safe side.
    let mut bends = 0;
    for (at, &length) in passed.iter().enumerate() {
        bends += length;
        if bends > MAX_BENDS {
            return at.checked_sub(1).map_or(0, |before| passed[before].min(length - 1));
        }
    }
    usize::MAX
}
