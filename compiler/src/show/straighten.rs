//! Makes wires level that nearly are, and those that pass columns level over as many as possible.

use super::order::Columns;
use super::routes::{Body, Routes};
use super::spacing::distance;

/// How far a box moves for one of its wires.
const LITTLE: f64 = 16.0;
/// How far something moves to let a wire pass.
const FAR: f64 = 24.0;
/// A wire that climbs less is level to the eye.
const EVEN: f64 = 0.05;

/// Makes the bends of a wire level over as many columns as there is room for.
pub(super) fn straighten(routes: &Routes, columns: &Columns, middles: &mut [f64]) {
    let bends = Bends::new(routes, columns, middles);
    for bends_of_wire in &bends.runs {
        let mut run = Vec::new();
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for &vertex in bends_of_wire {
            let column = &columns[routes.vertices[vertex].layer];
            let (own_low, own_high) = freedom(routes, column, bends.rows[vertex], middles);
            if own_low.max(low) > own_high.min(high) {
                bends.level(&run, (low, high), middles);
                run.clear();
                (low, high) = (own_low, own_high);
            } else {
                (low, high) = (low.max(own_low), high.min(own_high));
            }
            run.push(vertex);
        }
        bends.level(&run, (low, high), middles);
        if let (Some(&first), true) = (run.first(), run.len() == bends_of_wire.len()) {
            bends.follow(routes, columns, (first, &run), (low, high), middles);
        }
    }
}

/// Makes the bends of a wire level over all columns where boxes in its way can give way a little;
/// the longest wires first, and what they have made level stays.
pub(super) fn make_way(routes: &Routes, columns: &Columns, middles: &mut [f64]) {
    let bends = Bends::new(routes, columns, middles);
    let mut longest: Vec<&Vec<usize>> = bends.runs.iter().filter(|run| run.len() > 1).collect();
    longest.sort_by_key(|run| std::cmp::Reverse(run.len()));
    let mut settled = vec![false; middles.len()];
    for run in longest {
        let mut heights: Vec<f64> = run.iter().map(|&bend| middles[bend]).collect();
        heights.sort_by(f64::total_cmp);
        let height = heights[heights.len() / 2];
        let moved: Option<Vec<_>> = run
            .iter()
            .map(|&bend| {
                let column = &columns[routes.vertices[bend].layer];
                pushed(routes, column, bends.rows[bend], height, (middles, &settled))
            })
            .collect();
        let Some(moved) = moved else { continue };
        for (vertex, middle) in moved.into_iter().flatten() {
            middles[vertex] = middle;
        }
        for &bend in run {
            settled[bend] = true;
        }
    }
}

/// Where the vertices of a column go when the one in `row` goes to `height`: those in its way make
/// way, and those in theirs. None where one would have to go far, or is settled.
fn pushed(
    routes: &Routes,
    column: &[usize],
    row: usize,
    height: f64,
    (middles, settled): (&[f64], &[bool]),
) -> Option<Vec<(usize, f64)>> {
    if settled[column[row]] || (height - middles[column[row]]).abs() > FAR {
        return None;
    }
    let mut moved = vec![(column[row], height)];
    let mut push = |rows: &mut dyn Iterator<Item = usize>, down: bool| {
        let mut last = (column[row], height);
        for row in rows {
            let vertex = column[row];
            let (upper, lower) = if down { (last.0, vertex) } else { (vertex, last.0) };
            let least = distance(&routes.vertices[upper], &routes.vertices[lower]);
            let limit = if down { last.1 + least } else { last.1 - least };
            let free = if down { middles[vertex] >= limit } else { middles[vertex] <= limit };
            if free {
                return true;
            }
            if settled[vertex] || (limit - middles[vertex]).abs() > FAR {
                return false;
            }
            moved.push((vertex, limit));
            last = (vertex, limit);
        }
        true
    };
    let free = push(&mut (0..row).rev(), false) && push(&mut (row + 1..column.len()), true);
    free.then_some(moved)
}

/// The bends of a drawing.
struct Bends {
    /// Of each output that has some, from left to right.
    runs: Vec<Vec<usize>>,
    /// Per vertex, its place in its column.
    rows: Vec<usize>,
    /// Per first bend, where the wire comes from.
    source: Vec<Option<f64>>,
    /// Per last bend, where a wire goes to.
    target: Vec<Option<f64>>,
    /// Per first bend, the box its wire comes from, if that has no other wire, with the offset.
    alone: Vec<Option<(usize, f64)>>,
}

impl Bends {
    fn new(routes: &Routes, columns: &Columns, middles: &[f64]) -> Self {
        let count = routes.vertices.len();
        let (mut source, mut target, mut next) =
            (vec![None; count], vec![None; count], vec![None; count]);
        let mut starts = Vec::new();
        let mut alone = vec![None; count];
        let mut wires = vec![0_usize; count];
        for segment in &routes.segments {
            wires[segment.from] += 1;
            wires[segment.to] += 1;
        }
        let is_bend = |vertex: usize| routes.vertices[vertex].body == Body::Bend;
        for segment in &routes.segments {
            match (is_bend(segment.from), is_bend(segment.to)) {
                (true, true) => next[segment.from] = Some(segment.to),
                (false, true) => {
                    starts.push(segment.to);
                    source[segment.to] = Some(middles[segment.from] + segment.from_offset);
                    if wires[segment.from] == 1 {
                        alone[segment.to] = Some((segment.from, segment.from_offset));
                    }
                }
                (true, false) => {
                    target[segment.from] = Some(middles[segment.to] + segment.to_offset);
                }
                (false, false) => {}
            }
        }
        let runs = starts
            .into_iter()
            .map(|start| std::iter::successors(Some(start), |&bend| next[bend]).collect())
            .collect();
        let mut rows = vec![0; count];
        for column in columns {
            for (row, &vertex) in column.iter().enumerate() {
                rows[vertex] = row;
            }
        }
        Self { runs, rows, source, target, alone }
    }

    /// Moves a whole wire with the box it comes from, which has no other, a little to where the wire
    /// is level to its end.
    fn follow(
        &self,
        routes: &Routes,
        columns: &Columns,
        (first, run): (usize, &[usize]),
        (low, high): (f64, f64),
        middles: &mut [f64],
    ) {
        let end = run.last().and_then(|&last| self.target[last]);
        let (Some((card, offset)), Some(end)) = (self.alone[first], end) else { return };
        let column = &columns[routes.vertices[card].layer];
        let (lowest, highest) = freedom(routes, column, self.rows[card], middles);
        let fits = (low..=high).contains(&end) && (lowest..=highest).contains(&(end - offset));
        if fits && (end - offset - middles[card]).abs() <= LITTLE {
            middles[card] = end - offset;
            for &bend in run {
                middles[bend] = end;
            }
        }
    }

    /// Puts a run of bends at one height between `low` and `high`: level with one of its ends if
    /// there is room, so that the wire climbs once.
    fn level(&self, run: &[usize], (low, high): (f64, f64), middles: &mut [f64]) {
        let (Some(&first), Some(&last)) = (run.first(), run.last()) else { return };
        let mut heights: Vec<f64> = run.iter().map(|&vertex| middles[vertex]).collect();
        heights.sort_by(f64::total_cmp);
        let usual = heights[heights.len() / 2].max(low).min(high);
        let ends = [self.source[first], self.target[last]].into_iter().flatten();
        let height = ends
            .filter(|end| (low..=high).contains(end))
            .min_by(|a, b| (a - usual).abs().total_cmp(&(b - usual).abs()))
            .unwrap_or(usual);
        for &vertex in run {
            middles[vertex] = height;
        }
    }
}

/// How high and how low the vertex in `row` may go while its neighbours stay.
fn freedom(routes: &Routes, column: &[usize], row: usize, middles: &[f64]) -> (f64, f64) {
    let vertex = |row: usize| &routes.vertices[column[row]];
    let low = match row.checked_sub(1) {
        Some(above) => middles[column[above]] + distance(vertex(above), vertex(row)),
        None => f64::NEG_INFINITY,
    };
    let high = match column.get(row + 1) {
        Some(&below) => middles[below] - distance(vertex(row), vertex(row + 1)),
        None => f64::INFINITY,
    };
    // Rounding may leave them a hair apart in the wrong order.
    (low, high.max(low))
}

/// Moves each box a little where that makes one of its wires level and none uneven that was level:
/// a wire that climbs by two pixels looks like a mistake.
pub(super) fn tidy(routes: &Routes, columns: &Columns, middles: &mut [f64]) {
    let mut wires: Vec<Vec<usize>> = vec![Vec::new(); routes.vertices.len()];
    for (at, segment) in routes.segments.iter().enumerate() {
        wires[segment.from].push(at);
        wires[segment.to].push(at);
    }
    for column in columns {
        for (row, &vertex) in column.iter().enumerate() {
            if routes.vertices[vertex].body == Body::Bend {
                continue;
            }
            // How far the vertex would have to move down for each of its wires to be level, and
            // whether the wire comes in: those are behind the sweep, and stay where they are.
            let moves: Vec<(bool, f64)> = wires[vertex]
                .iter()
                .map(|&at| {
                    let segment = &routes.segments[at];
                    let climb = middles[segment.to] + segment.to_offset
                        - middles[segment.from]
                        - segment.from_offset;
                    if segment.from == vertex { (false, climb) } else { (true, -climb) }
                })
                .collect();
            if moves.iter().any(|(_, by)| by.abs() < EVEN) {
                continue;
            }
            let (low, high) = freedom(routes, column, row, middles);
            let least = moves
                .into_iter()
                .filter(|(_, by)| by.abs() <= LITTLE)
                .filter(|(_, by)| (low..=high).contains(&(middles[vertex] + by)))
                .min_by(|a, b| b.0.cmp(&a.0).then(a.1.abs().total_cmp(&b.1.abs())));
            middles[vertex] += least.map_or(0.0, |(_, by)| by);
        }
    }
}
