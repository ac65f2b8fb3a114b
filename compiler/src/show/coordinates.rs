//! How high each vertex stands: as level with its neighbours as the order of its column allows.

use super::compact::close_gaps;
use super::order::Columns;
use super::routes::{Body, Routes};
use super::spacing::distance;
use super::straighten::{make_way, straighten, tidy};

/// Passes over all columns.
const PASSES: usize = 64;
/// The last passes make one wire of each box level where that is nearly so anyway.
const LEVEL_PASSES: usize = 16;
/// How far that may be from where its wires together want it.
const NEARLY: f64 = 40.0;

/// The middle of each vertex; the smallest top is 0.
pub(super) fn coordinates(routes: &Routes, columns: &Columns) -> Vec<f64> {
    let pulls = Pulls::new(routes);
    let mut middles = stacked(routes, columns);
    for pass in 0..PASSES {
        let side = match (pass < PASSES / 2, pass % 2 == 0) {
            (true, true) => Side::Left,
            (true, false) => Side::Right,
            (false, _) => Side::Both,
        };
        let level = pass + LEVEL_PASSES >= PASSES;
        let count = columns.len();
        for step in 0..count {
            let column = &columns[if pass % 2 == 0 { step } else { count - 1 - step }];
            settle(routes, column, &pulls, side, level, &mut middles);
        }
    }
    straighten(routes, columns, &mut middles);
    close_gaps(routes, columns, &mut middles);
    make_way(routes, columns, &mut middles);
    tidy(routes, columns, &mut middles);
    straighten(routes, columns, &mut middles);
    let top = middles.iter().zip(&routes.vertices).map(|(y, vertex)| y - vertex.height / 2.0);
    let top = top.fold(f64::INFINITY, f64::min);
    middles.iter().map(|y| y - top).collect()
}

/// Which neighbours count.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Left,
    Right,
    Both,
}

/// A neighbour: where this vertex would have to stand for the wire to be level.
#[derive(Clone, Copy)]
struct Pull {
    vertex: usize,
    shift: f64,
    weight: f64,
}

struct Pulls {
    left: Vec<Vec<Pull>>,
    right: Vec<Vec<Pull>>,
}

impl Pulls {
    fn new(routes: &Routes) -> Self {
        let mut left = vec![Vec::new(); routes.vertices.len()];
        let mut right = vec![Vec::new(); routes.vertices.len()];
        for segment in &routes.segments {
            let (shift, weight) = (segment.from_offset - segment.to_offset, segment.weight);
            left[segment.to].push(Pull { vertex: segment.from, shift, weight });
            right[segment.from].push(Pull { vertex: segment.to, shift: -shift, weight });
        }
        Self { left, right }
    }

    /// Where `vertex` wants to stand, and how much.
    fn wish(&self, vertex: usize, side: Side, level: bool, middles: &[f64]) -> Option<(f64, f64)> {
        let (left, right) = (&self.left[vertex], &self.right[vertex]);
        let (left, right): (&[Pull], &[Pull]) = match side {
            Side::Left if !left.is_empty() => (left, &[]),
            Side::Right if !right.is_empty() => (&[], right),
            _ => (left, right),
        };
        let wishes = || {
            left.iter().chain(right).map(|pull| (middles[pull.vertex] + pull.shift, pull.weight))
        };
        let weight: f64 = wishes().map(|wish| wish.1).sum();
        if weight == 0.0 {
            return None;
        }
        let mean = wishes().map(|wish| wish.0 * wish.1).sum::<f64>() / weight;
        let nearest = wishes().map(|wish| wish.0).min_by(|a, b| {
            let far = |place: f64| (place - mean).abs();
            far(*a).total_cmp(&far(*b))
        });
        let place = nearest.filter(|place| level && (place - mean).abs() <= NEARLY);
        Some((place.unwrap_or(mean), weight))
    }
}

/// Every column piled up, its middle at 0.
fn stacked(routes: &Routes, columns: &Columns) -> Vec<f64> {
    let mut middles = vec![0.0; routes.vertices.len()];
    for column in columns {
        let places = offsets(routes, column);
        let half = places.last().copied().unwrap_or(0.0) / 2.0;
        for (&vertex, place) in column.iter().zip(places) {
            middles[vertex] = place - half;
        }
    }
    middles
}

/// The middles of a column's vertices when they stand as close as they may, the first at 0.
fn offsets(routes: &Routes, column: &[usize]) -> Vec<f64> {
    let mut places = vec![0.0; column.len()];
    for at in 1..column.len() {
        let (upper, lower) = (column[at - 1], column[at]);
        places[at] = places[at - 1] + distance(&routes.vertices[upper], &routes.vertices[lower]);
    }
    places
}

/// Moves a column's vertices as near to their wishes as their order and distances allow, in the
/// least squares sense: isotonic regression by pooling adjacent violators.
fn settle(
    routes: &Routes,
    column: &[usize],
    pulls: &Pulls,
    side: Side,
    level: bool,
    middles: &mut [f64],
) {
    struct Pool {
        sum: f64,
        weight: f64,
        members: usize,
    }
    let offsets = offsets(routes, column);
    let mut pools: Vec<Pool> = Vec::with_capacity(column.len());
    let wishes: Vec<Option<(f64, f64)>> = column
        .iter()
        .zip(&offsets)
        .map(|(&vertex, offset)| {
            let level = level && routes.vertices[vertex].body != Body::Bend;
            let wish = pulls.wish(vertex, side, level, middles);
            wish.map(|(place, weight)| (place - offset, weight))
        })
        .collect();
    // What no wire holds stands close below what is above it, or above what is below.
    let first = wishes.iter().flatten().next().map_or(0.0, |wish| wish.0);
    for wish in wishes {
        let above = pools.last().map_or(first, |pool| pool.sum / pool.weight);
        let (place, weight) = wish.unwrap_or((above, 1e-3));
        let mut pool = Pool { sum: place * weight, weight, members: 1 };
        while let Some(above) = pools.last() {
            if above.sum / above.weight <= pool.sum / pool.weight {
                break;
            }
            pool.sum += above.sum;
            pool.weight += above.weight;
            pool.members += above.members;
            pools.pop();
        }
        pools.push(pool);
    }
    let places =
        pools.iter().flat_map(|pool| std::iter::repeat_n(pool.sum / pool.weight, pool.members));
    for ((&vertex, offset), place) in column.iter().zip(offsets).zip(places) {
        middles[vertex] = place + offset;
    }
}
