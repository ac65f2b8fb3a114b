//! Places for everything in a diagram.

use super::ShowError;
use super::coordinates::coordinates;
use super::diagram::{Diagram, Role};
use super::frames::{Frame, frame};
use super::layers::layers;
use super::order::order;
use super::routes::{Body, Route, Routes, routes};

/// Least room between columns.
const NARROW_GAP: f64 = 60.0;
/// Most room between columns.
const WIDE_GAP: f64 = 160.0;
/// How far wires run level past the boxes of their column before they climb: sockets stay clear, and
/// steep wires keep off corners.
const STUB: f64 = 8.0;

/// A box's place on the page; its left top corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    /// From the left.
    pub x: f64,
    /// From the top.
    pub y: f64,
}

/// The way of a wire: level from the first point to the second, curved to the third, level to the
/// fourth and so on. An even number of points; none if it is not drawn.
pub(super) type Track = Vec<Place>;

/// Places for everything in a diagram.
pub(super) struct Layout {
    /// Measures of the cards.
    pub frames: Vec<Frame>,
    /// Places of the cards.
    pub places: Vec<Place>,
    /// One for each wire.
    pub tracks: Vec<Track>,
    /// Width of all.
    pub width: f64,
    /// Height of all.
    pub height: f64,
}

/// Gives everything its place.
pub(super) fn layout(diagram: &Diagram<'_>) -> Result<Layout, ShowError> {
    let mut frames: Vec<Frame> = diagram.cards.iter().map(frame).collect();
    for role in [Role::Parameter, Role::Root] {
        widen_alike(diagram, role, &mut frames);
    }
    let layers = layers(diagram).map_err(|card| ShowError::Inconsistent {
        place: diagram.cards[card].title.to_owned(),
        problem: "its connections form a cycle".to_owned(),
    })?;
    let routes = routes(diagram, &frames, &layers);
    let columns = order(&routes);
    let middles = coordinates(&routes, &columns);
    let spans = spans(&routes, &frames, &middles, columns.len());
    let places: Vec<Place> = frames
        .iter()
        .enumerate()
        .map(|(card, frame)| {
            let span = spans[layers[card]];
            let free = span.right - span.left - frame.width;
            let x = match diagram.cards[card].role {
                Role::Parameter | Role::Root => span.left,
                Role::Node => span.left + (free / 2.0).round(),
            };
            Place { x, y: middles[card] - frame.height / 2.0 }
        })
        .collect();
    let bottoms = places.iter().zip(&frames).map(|(place, frame)| place.y + frame.height);
    let height = bottoms.chain(middles.iter().copied()).fold(0.0, f64::max);
    let width = spans.last().map_or(0.0, |span| span.right);
    let mut layout = Layout { frames, places, tracks: Vec::new(), width, height };
    layout.tracks = (0..diagram.wires.len())
        .map(|wire| layout.track(diagram, &routes, wire, &layers, &spans, &middles))
        .collect();
    Ok(layout)
}

/// Makes all cards of a role as wide as the widest.
fn widen_alike(diagram: &Diagram<'_>, role: Role, frames: &mut [Frame]) {
    let alike = || diagram.cards.iter().zip(0..).filter(|(card, _)| card.role == role);
    let widest = alike().map(|(_, at): (_, usize)| frames[at].width).fold(0.0, f64::max);
    for (_, at) in alike() {
        frames[at].width = widest;
    }
}

/// Left and right side of a column.
#[derive(Clone, Copy, Debug)]
struct Span {
    left: f64,
    right: f64,
}

/// Columns side by side; where wires climb far they get more room to do so.
fn spans(routes: &Routes, frames: &[Frame], middles: &[f64], count: usize) -> Vec<Span> {
    let mut widths = vec![0.0_f64; count];
    for vertex in &routes.vertices {
        if let Body::Card(card) = vertex.body {
            widths[vertex.layer] = widths[vertex.layer].max(frames[card].width);
        }
    }
    let mut climbs = vec![0.0_f64; count];
    for segment in &routes.segments {
        let from = middles[segment.from] + segment.from_offset;
        let to = middles[segment.to] + segment.to_offset;
        let layer = routes.vertices[segment.from].layer;
        climbs[layer] = climbs[layer].max((to - from).abs());
    }
    let mut left = 0.0;
    widths
        .iter()
        .zip(&climbs)
        .map(|(width, climb)| {
            let span = Span { left, right: left + width };
            left = span.right + (NARROW_GAP + climb * 0.16).min(WIDE_GAP).round();
            span
        })
        .collect()
}

impl Layout {
    fn track(
        &self,
        diagram: &Diagram<'_>,
        routes: &Routes,
        wire: usize,
        layers: &[usize],
        spans: &[Span],
        middles: &[f64],
    ) -> Track {
        let route = &routes.routes[wire];
        if *route == Route::Named {
            return Track::new();
        }
        let ((from, output), (to, input)) = (diagram.wires[wire].from, diagram.wires[wire].to);
        let start = self.places[from].y + self.frames[from].outputs[output];
        let end = self.places[to].y + self.frames[to].inputs[input];
        let mut track = vec![
            Place { x: self.places[from].x + self.frames[from].width, y: start },
            Place { x: spans[layers[from]].right + STUB, y: start },
        ];
        if let Route::Through(bends) = route {
            for &bend in bends {
                let span = spans[routes.vertices[bend].layer];
                track.push(Place { x: span.left - STUB, y: middles[bend] });
                track.push(Place { x: span.right + STUB, y: middles[bend] });
            }
        }
        track.push(Place { x: spans[layers[to]].left - STUB, y: end });
        track.push(Place { x: self.places[to].x, y: end });
        track
    }
}
