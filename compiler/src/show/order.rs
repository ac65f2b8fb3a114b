//! Who stands above whom in a column, so that few wires cross: barycentre sweeps, then exchanges of
//! neighbours.

use super::routes::{Body, Routes};

/// Sweeps to the right and back.
const SWEEPS: usize = 24;
/// Rounds of exchanging neighbours.
const EXCHANGES: usize = 8;
/// Above this many segments fewer sweeps are made and no exchanges.
const MANY_SEGMENTS: usize = 8_000;

/// Columns, each with its vertices from the top.
pub(super) type Columns = Vec<Vec<usize>>;

/// Orders the vertices of each column.
pub(super) fn order(routes: &Routes) -> Columns {
    let links = Links::new(routes);
    let mut columns = initial(routes, &links);
    let many = routes.segments.len() > MANY_SEGMENTS;
    let mut best = columns.clone();
    let mut fewest = links.crossings(&columns);
    for sweep in 0..if many { 4 } else { SWEEPS } {
        if fewest == 0 {
            break;
        }
        links.sweep(&mut columns, sweep % 2 == 0);
        let crossings = links.crossings(&columns);
        if crossings < fewest {
            fewest = crossings;
            best.clone_from(&columns);
        }
    }
    if !many {
        for _ in 0..EXCHANGES {
            if !links.exchange(&mut best) {
                break;
            }
        }
    }
    best
}

/// The end of a segment as seen from its other end.
#[derive(Clone, Copy)]
struct End {
    vertex: usize,
    /// Where on that vertex, -0.5 to 0.5 of its height.
    port: f64,
    /// Where on the vertex it is seen from.
    own_port: f64,
}

struct Links {
    left: Vec<Vec<End>>,
    right: Vec<Vec<End>>,
}

impl Links {
    fn new(routes: &Routes) -> Self {
        let mut left = vec![Vec::new(); routes.vertices.len()];
        let mut right = vec![Vec::new(); routes.vertices.len()];
        for segment in &routes.segments {
            let from_port = segment.from_offset / routes.vertices[segment.from].height;
            let to_port = segment.to_offset / routes.vertices[segment.to].height;
            left[segment.to].push(End { vertex: segment.from, port: from_port, own_port: to_port });
            right[segment.from].push(End {
                vertex: segment.to,
                port: to_port,
                own_port: from_port,
            });
        }
        Self { left, right }
    }

    /// Orders each column by where its vertices' wires come from in the column before it.
    fn sweep(&self, columns: &mut Columns, to_the_right: bool) {
        let mut place = vec![0.0; self.left.len()];
        for column in columns.iter() {
            number(column, &mut place);
        }
        let links = if to_the_right { &self.left } else { &self.right };
        let count = columns.len();
        for step in 1..count {
            let at = if to_the_right { step } else { count - 1 - step };
            let column = &mut columns[at];
            let mut keyed: Vec<(f64, usize)> = column
                .iter()
                .map(|&vertex| (barycentre(&links[vertex], &place, place[vertex]), vertex))
                .collect();
            // Stable: equals keep their order.
            keyed.sort_by(|a, b| a.0.total_cmp(&b.0));
            for (slot, (_, vertex)) in column.iter_mut().zip(keyed) {
                *slot = vertex;
            }
            number(column, &mut place);
        }
    }

    /// How many pairs of segments cross.
    fn crossings(&self, columns: &Columns) -> u64 {
        let mut place = vec![0.0; self.left.len()];
        for column in columns {
            for (at, &vertex) in column.iter().enumerate() {
                place[vertex] = at as f64;
            }
        }
        let mut total = 0;
        for column in columns {
            let mut ends: Vec<(f64, f64)> = Vec::new();
            for &vertex in column {
                let here = self.right[vertex].iter();
                ends.extend(
                    here.map(|end| (place[vertex] + end.own_port, place[end.vertex] + end.port)),
                );
            }
            ends.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
            total += inversions(ends.into_iter().map(|(_, to)| to).collect());
        }
        total
    }

    /// Exchanges neighbours where that removes crossings; whether it did anywhere.
    fn exchange(&self, columns: &mut Columns) -> bool {
        let mut place = vec![0.0; self.left.len()];
        for column in columns.iter() {
            for (at, &vertex) in column.iter().enumerate() {
                place[vertex] = at as f64;
            }
        }
        let mut changed = false;
        for column in columns.iter_mut() {
            for at in 1..column.len() {
                let (upper, lower) = (column[at - 1], column[at]);
                let crossed = |links: &[Vec<End>], upper: usize, lower: usize| {
                    pairs_crossed(&links[upper], &links[lower], &place)
                };
                let now = crossed(&self.left, upper, lower) + crossed(&self.right, upper, lower);
                let then = crossed(&self.left, lower, upper) + crossed(&self.right, lower, upper);
                if then < now {
                    column.swap(at - 1, at);
                    place[lower] = (at - 1) as f64;
                    place[upper] = at as f64;
                    changed = true;
                }
            }
        }
        changed
    }
}

/// Numbers a column's vertices from 0 to 1, so that columns of different lengths compare.
fn number(column: &[usize], place: &mut [f64]) {
    let length = column.len() as f64;
    for (at, &vertex) in column.iter().enumerate() {
        place[vertex] = (at as f64 + 0.5) / length;
    }
}

/// Mean place of the other ends; `own` where there are none.
fn barycentre(ends: &[End], place: &[f64], own: f64) -> f64 {
    if ends.is_empty() {
        return own;
    }
    // The port decides between vertices wired to the same card.
    let sum: f64 = ends.iter().map(|end| place[end.vertex] + end.port * 1e-3).sum();
    sum / ends.len() as f64
}

/// How many wires cross if `upper` stands above `lower`.
fn pairs_crossed(upper: &[End], lower: &[End], place: &[f64]) -> usize {
    let far = |end: &End| place[end.vertex] + end.port;
    upper.iter().map(|u| lower.iter().filter(|l| far(l) < far(u)).count()).sum()
}

/// Pairs that stand in the wrong order, by merge sort from below.
fn inversions(mut values: Vec<f64>) -> u64 {
    let mut merged = values.clone();
    let mut total = 0;
    let mut width = 1;
    while width < values.len() {
        for start in (0..values.len()).step_by(2 * width) {
            let middle = (start + width).min(values.len());
            let end = (start + 2 * width).min(values.len());
            let (mut left, mut right) = (start, middle);
            for slot in &mut merged[start..end] {
                if right == end || (left < middle && values[left] <= values[right]) {
                    *slot = values[left];
                    left += 1;
                } else {
                    *slot = values[right];
                    right += 1;
                    total += (middle - left) as u64;
                }
            }
        }
        std::mem::swap(&mut values, &mut merged);
        width *= 2;
    }
    total
}

/// The order in which a walk from the roots, then from all other ends, meets the vertices: what
/// belongs together starts together, and dead parts come last.
fn initial(routes: &Routes, links: &Links) -> Columns {
    let count = routes.vertices.iter().map(|vertex| vertex.layer + 1).max().unwrap_or(0);
    let mut columns: Columns = vec![Vec::new(); count];
    let mut met = vec![false; routes.vertices.len()];
    let last = count.saturating_sub(1);
    let cards = routes.vertices.iter().filter(|vertex| vertex.body != Body::Bend).count();
    let in_last = (0..cards).filter(|&vertex| routes.vertices[vertex].layer == last);
    let ends = (0..cards).filter(|&vertex| links.right[vertex].is_empty());
    for start in in_last.chain(ends).chain(0..routes.vertices.len()) {
        let mut open = vec![start];
        while let Some(vertex) = open.pop() {
            if std::mem::replace(&mut met[vertex], true) {
                continue;
            }
            columns[routes.vertices[vertex].layer].push(vertex);
            open.extend(links.left[vertex].iter().rev().map(|end| end.vertex));
        }
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inversions_are_counted() {
        assert_eq!(inversions(vec![]), 0);
        assert_eq!(inversions(vec![1.0, 1.0, 1.0]), 0);
        assert_eq!(inversions(vec![3.0, 2.0, 1.0]), 3);
        assert_eq!(inversions(vec![2.0, 4.0, 1.0, 3.0, 5.0]), 3);
    }
}
