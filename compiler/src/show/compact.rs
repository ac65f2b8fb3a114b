//! Closes empty bands: what stands below a gap that goes through all columns moves up, where that
//! makes the wires across it no longer. The passes that give each column its heights cannot: they
//! move one column at a time, and a group of boxes that hold one another level stays where it is.

use super::order::Columns;
use super::routes::{Body, Routes};
use super::spacing::distance;

/// Most steps (boxes times what they are compared with); larger drawings stay as they are.
const MOST_STEPS: usize = 20_000_000;
/// What a pixel of height costs, against a pixel of climb of a wire of weight 1.
const HEIGHT: f64 = 1.0;
/// A gap not worth closing.
const LEAST: f64 = 1.0;

/// Moves parts of the drawing up, from the top to the bottom.
pub(super) fn close_gaps(routes: &Routes, columns: &Columns, middles: &mut [f64]) {
    let is_card = |vertex: &usize| routes.vertices[*vertex].body != Body::Bend;
    let mut cards: Vec<usize> = (0..middles.len()).filter(is_card).collect();
    if cards.len() * (middles.len() + routes.segments.len()) > MOST_STEPS {
        return;
    }
    let top =
        |middles: &[f64], vertex: usize| middles[vertex] - routes.vertices[vertex].height / 2.0;
    cards.sort_by(|&a, &b| top(middles, a).total_cmp(&top(middles, b)).then(a.cmp(&b)));
    for card in cards {
        let line = top(middles, card) - 1e-6;
        let below: Vec<bool> =
            (0..middles.len()).map(|vertex| top(middles, vertex) >= line).collect();
        let room = room(routes, columns, middles, &below);
        let Some(shift) = best_shift(routes, middles, &below, room) else { continue };
        for (middle, _) in middles.iter_mut().zip(below).filter(|(_, below)| *below) {
            *middle -= shift;
        }
    }
}

/// How far what is below may move up until it meets what is above.
fn room(routes: &Routes, columns: &Columns, middles: &[f64], below: &[bool]) -> f64 {
    let mut room = f64::INFINITY;
    for pair in columns.iter().flat_map(|column| column.windows(2)) {
        let (upper, lower) = (pair[0], pair[1]);
        if !below[upper] && below[lower] {
            let least = distance(&routes.vertices[upper], &routes.vertices[lower]);
            room = room.min(middles[lower] - middles[upper] - least);
        }
    }
    room
}

/// The shift, up to `room`, that costs least; none where moving costs more than staying.
fn best_shift(routes: &Routes, middles: &[f64], below: &[bool], room: f64) -> Option<f64> {
    if !(LEAST..f64::INFINITY).contains(&room) {
        return None;
    }
    // How far below its upper end the lower end of each wire across the gap is, and its weight.
    let climbs: Vec<(f64, f64)> = routes
        .segments
        .iter()
        .filter(|segment| below[segment.from] != below[segment.to])
        .map(|segment| {
            let from = middles[segment.from] + segment.from_offset;
            let to = middles[segment.to] + segment.to_offset;
            (if below[segment.to] { to - from } else { from - to }, segment.weight)
        })
        .collect();
    let cost = |shift: f64| {
        let wires: f64 = climbs
            .iter()
            .map(|(climb, weight)| ((climb - shift).abs() - climb.abs()) * weight)
            .sum();
        wires - shift * HEIGHT
    };
    // The cost is convex, with its corners where a wire is level.
    let corners = climbs.iter().map(|(climb, _)| *climb).filter(|climb| *climb < room);
    let shifts = corners.filter(|shift| *shift >= LEAST).chain([room]);
    let best = shifts.map(|shift| (cost(shift), shift)).min_by(|a, b| a.0.total_cmp(&b.0));
    best.filter(|(cost, _)| *cost < 0.0).map(|(_, shift)| shift)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::show::routes::{Segment, Vertex};

    /// Four boxes of height 40 in two columns, each wired level to its neighbour, and a wire of the
    /// given weight from the upper left one to the lower right one.
    fn two_rows(weight: f64) -> (Routes, Columns) {
        let card = |card, layer| Vertex { body: Body::Card(card), layer, height: 40.0 };
        let wire =
            |from, to, weight| Segment { from, from_offset: 0.0, to, to_offset: 0.0, weight };
        let routes = Routes {
            vertices: vec![card(0, 0), card(1, 0), card(2, 1), card(3, 1)],
            segments: vec![wire(0, 2, 1.0), wire(1, 3, 1.0), wire(0, 3, weight)],
            routes: Vec::new(),
        };
        (routes, vec![vec![0, 1], vec![2, 3]])
    }

    #[test]
    fn what_is_below_an_empty_band_moves_up() {
        let (routes, columns) = two_rows(0.5);
        let mut middles = [20.0, 520.0, 20.0, 520.0];
        close_gaps(&routes, &columns, &mut middles);
        let least = distance(&routes.vertices[0], &routes.vertices[1]);
        let expected = [20.0, 20.0 + least, 20.0, 20.0 + least];
        assert!(middles.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6), "{middles:?}");
    }

    #[test]
    fn a_level_wire_across_the_band_keeps_it() {
        let (mut routes, columns) = two_rows(2.0);
        routes.segments[2].from_offset = 500.0;
        let before = [20.0, 520.0, 20.0, 520.0];
        let mut middles = before;
        close_gaps(&routes, &columns, &mut middles);
        assert_eq!(middles, before);
        // A light one is worth less than the room.
        routes.segments[2].weight = 0.5;
        close_gaps(&routes, &columns, &mut middles);
        assert!(middles[3] < 200.0, "{middles:?}");
    }
}
