//! How far apart things of one column stand.

use super::routes::{Body, Vertex};

/// Between two boxes.
const CARD_GAP: f64 = 22.0;
/// Between a box and a passing wire.
const WIRE_GAP: f64 = 15.0;
/// Between two passing wires.
const LANE_GAP: f64 = 4.0;

/// Least distance of the middles of two vertices, the first above the second.
pub(super) fn distance(upper: &Vertex, lower: &Vertex) -> f64 {
    let gap = match (upper.body, lower.body) {
        (Body::Bend, Body::Bend) => LANE_GAP,
        (Body::Card(_), Body::Card(_)) => CARD_GAP,
        _ => WIRE_GAP,
    };
    upper.height / 2.0 + gap + lower.height / 2.0
}
