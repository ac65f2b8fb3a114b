//! What is wrong with a layout.

use crate::show::diagram::{Diagram, Wire};
use crate::show::layout::{Layout, Place, Track};

/// Boxes that overlap, wires that do not end at their sockets or run to the left.
pub fn faults(diagram: &Diagram<'_>, layout: &Layout) -> Vec<String> {
    let boxes: Vec<Box> = layout
        .places
        .iter()
        .zip(&layout.frames)
        .map(|(place, frame)| (*place, frame.width, frame.height))
        .collect();
    let mut faults = of_boxes(&boxes, layout);
    for (wire, track) in diagram.wires.iter().zip(&layout.tracks) {
        faults.extend(of_wire(wire, track, layout));
        let (from, to) = (wire.from.0, wire.to.0);
        let near = |point: &Place| {
            let at = |&(place, width, height): &Box| {
                place.x - 6.0 < point.x
                    && point.x < place.x + width + 6.0
                    && place.y - 6.0 < point.y
                    && point.y < place.y + height + 6.0
            };
            boxes.iter().enumerate().any(|(card, it)| card != from && card != to && at(it))
        };
        if points(track).iter().any(near) {
            faults.push(format!("{wire:?} runs behind a box, or too near one"));
        }
    }
    faults
}

/// The left top corner of a box, its width and its height.
type Box = (Place, f64, f64);

fn of_boxes(boxes: &[Box], layout: &Layout) -> Vec<String> {
    let mut faults = Vec::new();
    for (at, (a, a_width, a_height)) in boxes.iter().enumerate() {
        let inside = a.x >= 0.0
            && a.y >= -1e-6
            && a.x + a_width <= layout.width + 1e-6
            && a.y + a_height <= layout.height + 1e-6;
        if !inside {
            faults.push(format!("box {at} leaves the page: {a:?}"));
        }
        for (other, (b, b_width, b_height)) in boxes.iter().enumerate().skip(at + 1) {
            let apart = a.x + a_width + 8.0 <= b.x
                || b.x + b_width + 8.0 <= a.x
                || a.y + a_height + 8.0 <= b.y
                || b.y + b_height + 8.0 <= a.y;
            if !apart {
                faults.push(format!("boxes {at} and {other} overlap"));
            }
        }
    }
    faults
}

fn of_wire(wire: &Wire, track: &Track, layout: &Layout) -> Vec<String> {
    let (Some(start), Some(end)) = (track.first(), track.last()) else { return Vec::new() };
    let mut faults = Vec::new();
    let (from, to) = (wire.from.0, wire.to.0);
    let output = layout.places[from].y + layout.frames[from].outputs[wire.from.1];
    let input = layout.places[to].y + layout.frames[to].inputs[wire.to.1];
    let at_output = start.x == layout.places[from].x + layout.frames[from].width;
    let at_input = end.x == layout.places[to].x;
    if !at_output || !at_input || start.y != output || end.y != input {
        faults.push(format!("{wire:?} misses a socket"));
    }
    if track.windows(2).any(|pair| pair[1].x < pair[0].x) || !track.len().is_multiple_of(2) {
        faults.push(format!("{wire:?} runs to the left"));
    }
    faults
}

/// Points of a wire as it is drawn: curves are cubics whose middle points stand level with their ends,
/// half way.
fn points(track: &Track) -> Vec<Place> {
    let mut points: Vec<Place> = track.clone();
    let Some(inner) = track.get(1..track.len().saturating_sub(1)) else { return points };
    for pair in inner.chunks(2) {
        let &[from, to] = pair else { continue };
        for step in 1..64 {
            let t = f64::from(step) / 64.0;
            let (near, far) = ((1.0 - t).powi(3), t.powi(3));
            let (x, y) = (3.0 * t * (1.0 - t) * (from.x + to.x) / 2.0, t * t * (3.0 - 2.0 * t));
            points
                .push(Place { x: near * from.x + x + far * to.x, y: from.y + y * (to.y - from.y) });
        }
    }
    for pair in inner.windows(2).skip(1).step_by(2) {
        points.extend((0..=64).map(|step| Place {
            x: pair[0].x + (pair[1].x - pair[0].x) * f64::from(step) / 64.0,
            y: pair[0].y,
        }));
    }
    points
}
