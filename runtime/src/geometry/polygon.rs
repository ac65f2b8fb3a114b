//! Cutting faces into triangles.
//!
//! A face is looked at in its own plane: along its area vector (Newell's normal), the sum of the
//! cross products of its edges, which is the best plane there is where the corners do not lie in
//! one. Seen so, a face whose fan from its first corner covers it is cut into that fan, and any
//! other has its ears clipped. The signs that decide are those of exact arithmetic on the projected
//! corners (`robust`, after Shewchuk), so the ears of a simple polygon never run out, as Meisters
//! proved.

use std::collections::{TryReserveError, VecDeque};

use glam::DVec3;
use robust::{Coord, orient2d};

use super::vector::double;

/// Most corners of a face that is no fan: clipping ears takes, at worst, the square of their
/// number.
pub const CONCAVE_CORNERS_LIMIT: usize = 16_384;

/// Doubled area of an ear in parts of its longest edge squared, from which on it is clipped at
/// once. Thinner ears wait: a corner that lies on an edge but for rounding had better become a
/// corner of a wide triangle.
const WIDE: f64 = 1e-3;

/// Why a face could not be cut.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum CutError {
    /// It is no fan and has too many corners.
    TooManyCorners,
    /// There is no memory for it.
    OutOfMemory,
}

impl From<TryReserveError> for CutError {
    fn from(_: TryReserveError) -> Self {
        CutError::OutOfMemory
    }
}

/// Whether three points lie on one line, or are not even three: decided exactly.
pub(super) fn is_flat([a, b, c]: [[f32; 3]; 3]) -> bool {
    // Products of these coordinates neither overflow nor underflow in f64. Points lie on one line
    // if they do seen along every axis.
    [(0, 1), (1, 2), (2, 0)].into_iter().all(|(x, y)| {
        let [a, b, c] = [a, b, c].map(|point| Coord { x: point[x], y: point[y] });
        orient2d(a, b, c) == 0.0
    })
}

/// Cuts a face of at least 3 corners into triangles, two fewer than it has corners, each with the
/// orientation of the face. Where the face crosses itself, what is left at the end is cut as a fan.
pub(super) fn cut(corners: &[[f32; 3]]) -> Result<Vec<[u32; 3]>, CutError> {
    let mut triangles = Vec::new();
    triangles.try_reserve_exact(corners.len().saturating_sub(2))?;
    let points = match corners.len() {
        0..=3 => None,
        _ => projected(corners)?,
    };
    match points {
        Some(points) if !is_fan(&points) => {
            if points.len() > CONCAVE_CORNERS_LIMIT {
                return Err(CutError::TooManyCorners);
            }
            Clipping::new(&points).run(&mut triangles);
        }
        _ => triangles.extend((2..corners.len() as u32).map(|last| [0, last - 1, last])),
    }
    Ok(triangles)
}

/// The corners seen along the area vector, counter-clockwise; none where it vanishes.
fn projected(corners: &[[f32; 3]]) -> Result<Option<Vec<Coord<f64>>>, CutError> {
    let origin = double(corners[0]);
    let spoke = |corner: [f32; 3]| double(corner) - origin;
    let edges = corners[1..].windows(2);
    let area: DVec3 = edges.map(|edge| spoke(edge[0]).cross(spoke(edge[1]))).sum();
    let largest = area.abs().max_element();
    if largest == 0.0 {
        return Ok(None);
    }
    // Scaled by a power of two, and no more: what is exact stays exact, so that corners on one line
    // with round coordinates are seen on one line.
    let power = f64::from_bits(largest.to_bits() & (0x7ff << 52));
    let normal = area / power;
    let size = normal.abs();
    let least = match (size.x <= size.y && size.x <= size.z, size.y <= size.z) {
        (true, _) => DVec3::X,
        (_, true) => DVec3::Y,
        _ => DVec3::Z,
    };
    let right = normal.cross(least);
    let up = normal.cross(right);
    let mut points = Vec::new();
    points.try_reserve_exact(corners.len())?;
    points.extend(corners.iter().map(|corner| {
        let corner = double(*corner);
        Coord { x: right.dot(corner), y: up.dot(corner) }
    }));
    Ok(Some(points))
}

/// Whether every triangle from the first corner to an edge has an area and the face's orientation.
fn is_fan(points: &[Coord<f64>]) -> bool {
    points[1..].windows(2).all(|edge| orient2d(points[0], edge[0], edge[1]) > 0.0)
}

/// Which ears are clipped.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Stage {
    /// Those that are not thin.
    Wide,
    /// All that have an area.
    Any,
    /// Corners on the line between their neighbours too.
    Flat,
}

/// A polygon whose ears are being clipped.
struct Clipping<'p> {
    points: &'p [Coord<f64>],
    next: Vec<u32>,
    previous: Vec<u32>,
    is_gone: Vec<bool>,
    /// Whether the inner angle at a corner is at least half a turn. Only such a corner can lie in
    /// an ear of others: where a corner pokes in, so does a reflex one.
    is_reflex: Vec<bool>,
    /// The corners that were reflex at the start, from left to right. None becomes reflex later.
    from_left: Vec<u32>,
    /// Corners to look at. A corner that is no ear becomes one only when a neighbour is clipped.
    open: VecDeque<u32>,
    is_open: Vec<bool>,
}

impl<'p> Clipping<'p> {
    fn new(points: &'p [Coord<f64>]) -> Self {
        let count = points.len() as u32;
        let mut clipping = Self {
            points,
            next: (0..count).map(|corner| (corner + 1) % count).collect(),
            previous: (0..count).map(|corner| (corner + count - 1) % count).collect(),
            is_gone: vec![false; points.len()],
            is_reflex: Vec::new(),
            from_left: Vec::new(),
            open: (0..count).collect(),
            is_open: vec![true; points.len()],
        };
        clipping.is_reflex = (0..count).map(|corner| clipping.turn(corner) <= 0.0).collect();
        clipping.from_left =
            (0..count).filter(|corner| clipping.is_reflex[*corner as usize]).collect();
        clipping
            .from_left
            .sort_by(|a, b| points[*a as usize].x.total_cmp(&points[*b as usize].x).then(a.cmp(b)));
        clipping
    }

    fn run(mut self, triangles: &mut Vec<[u32; 3]>) {
        let mut left = self.points.len();
        let mut stage = Stage::Wide;
        while left > 3 {
            let Some(corner) = self.open.pop_front() else {
                stage = match stage {
                    Stage::Wide => Stage::Any,
                    Stage::Any => Stage::Flat,
                    Stage::Flat => break,
                };
                self.open
                    .extend((0..self.points.len() as u32).filter(|&at| !self.is_gone[at as usize]));
                self.open.iter().for_each(|&at| self.is_open[at as usize] = true);
                continue;
            };
            self.is_open[corner as usize] = false;
            if self.is_gone[corner as usize] || !self.is_ear(corner, stage) {
                continue;
            }
            triangles.push(self.clip(corner));
            left -= 1;
        }
        let first = self.is_gone.iter().position(|is_gone| !is_gone).unwrap_or(0) as u32;
        let mut second = self.next[first as usize];
        for _ in 2..left {
            let third = self.next[second as usize];
            triangles.push([first, second, third]);
            second = third;
        }
    }

    /// Twice the area of the triangle of a corner and its neighbours, below 0 at a reflex corner.
    fn turn(&self, corner: u32) -> f64 {
        let [a, b, c] = self.ear(corner).map(|at| self.points[at as usize]);
        orient2d(a, b, c)
    }

    fn ear(&self, corner: u32) -> [u32; 3] {
        [self.previous[corner as usize], corner, self.next[corner as usize]]
    }

    fn is_ear(&self, corner: u32, stage: Stage) -> bool {
        let ear = self.ear(corner);
        let [a, b, c] = ear.map(|at| self.points[at as usize]);
        let area = orient2d(a, b, c);
        if area <= 0.0 {
            return area == 0.0 && stage == Stage::Flat;
        }
        let squared = |a: Coord<f64>, b: Coord<f64>| (b.x - a.x).powi(2) + (b.y - a.y).powi(2);
        let longest = squared(a, b).max(squared(b, c)).max(squared(c, a));
        if stage == Stage::Wide && area < longest * WIDE {
            return false;
        }
        let (left, right) = (a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x));
        let (low, high) = (a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y));
        let start = self.from_left.partition_point(|&at| self.points[at as usize].x < left);
        for &at in &self.from_left[start..] {
            let point = self.points[at as usize];
            if point.x > right {
                break;
            }
            let is_apart = point.y < low
                || point.y > high
                || self.is_gone[at as usize]
                || !self.is_reflex[at as usize]
                || ear.contains(&at)
                // Where the polygon touches itself, as at the bridge to a hole.
                || [a, b, c].contains(&point);
            let is_within = |from, to| orient2d(from, to, point) >= 0.0;
            if !is_apart && is_within(a, b) && is_within(b, c) && is_within(c, a) {
                return false;
            }
        }
        true
    }

    fn clip(&mut self, corner: u32) -> [u32; 3] {
        let ear = self.ear(corner);
        let [before, _, after] = ear;
        self.is_gone[corner as usize] = true;
        self.next[before as usize] = after;
        self.previous[after as usize] = before;
        for neighbour in [before, after] {
            self.is_reflex[neighbour as usize] = self.turn(neighbour) <= 0.0;
            if !std::mem::replace(&mut self.is_open[neighbour as usize], true) {
                self.open.push_back(neighbour);
            }
        }
        ear
    }
}
