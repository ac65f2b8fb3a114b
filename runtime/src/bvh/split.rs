//! Where a list of boxes is split.

use std::cmp::Ordering;

use glam::DVec3;

/// Bins along an axis.
const BINS: usize = 32;

/// So few boxes are split in the best place of all.
pub(super) const FEW: usize = 16;

/// How often a number is halved, rounded up, until 1 is left.
pub(super) fn halvings(count: usize) -> u32 {
    count.next_power_of_two().trailing_zeros()
}

/// Primitives before their order is known.
#[derive(Clone, Copy, Debug)]
pub(super) struct Item {
    pub(super) low: [f32; 3],
    pub(super) high: [f32; 3],
    pub(super) index: u32,
}

impl Item {
    /// Twice the centre, in f64 so that no two sums overflow or coincide by rounding.
    pub(super) fn center(&self, axis: usize) -> f64 {
        f64::from(self.low[axis]) + f64::from(self.high[axis])
    }
}

/// A box that grows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    pub(super) low: [f32; 3],
    pub(super) high: [f32; 3],
}

impl Bounds {
    pub(super) const EMPTY: Self = Self { low: [f32::INFINITY; 3], high: [f32::NEG_INFINITY; 3] };

    pub(super) fn grow(&mut self, low: &[f32; 3], high: &[f32; 3]) {
        for axis in 0..3 {
            self.low[axis] = self.low[axis].min(low[axis]);
            self.high[axis] = self.high[axis].max(high[axis]);
        }
    }

    /// Half its surface, in f64 so that nothing vanishes or overflows.
    pub(super) fn area(&self) -> f64 {
        let side = |axis: usize| f64::from(self.high[axis]) - f64::from(self.low[axis]);
        let (x, y, z) = (side(0), side(1), side(2));
        x * y + y * z + z * x
    }
}

/// Where a list of boxes is split, and how.
#[derive(Clone, Copy, Debug)]
pub(super) struct Split {
    /// Tests to expect, up to what all splits of the list have in common.
    cost: f64,
    pub(super) axis: usize,
    /// How many come first.
    pub(super) count: usize,
    pub(super) how: How,
}

impl Split {
    /// Takes the place of a worse one; of equally good ones, the most even is best.
    fn compete(self, best: &mut Option<Split>, all: usize) {
        let unevenness = |split: &Split| (2 * split.count).abs_diff(all);
        let is_better = best.is_none_or(|best| {
            self.cost < best.cost || self.cost == best.cost && unevenness(&self) < unevenness(&best)
        });
        if is_better {
            *best = Some(self);
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub(super) enum How {
    /// Boxes of bins up to this one come first.
    Bin(usize),
    /// Boxes are sorted.
    Sorted,
}

/// The smallest and largest centre along each axis.
pub(super) fn centers(items: &[Item]) -> (DVec3, DVec3) {
    let all = || items.iter().map(|item| DVec3::from([0, 1, 2].map(|axis| item.center(axis))));
    (all().fold(DVec3::INFINITY, DVec3::min), all().fold(DVec3::NEG_INFINITY, DVec3::max))
}

/// By centre, and then by number, so that the order never depends on chance.
pub(super) fn along(axis: usize, a: &Item, b: &Item) -> Ordering {
    a.center(axis).total_cmp(&b.center(axis)).then(a.index.cmp(&b.index))
}

/// Equal stretches of an axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bins {
    low: f64,
    scale: f64,
}

impl Bins {
    pub(super) fn new(low: f64, high: f64) -> Self {
        Self { low, scale: BINS as f64 / (high - low) }
    }

    /// The bin of a centre; a centre further along is in no lower bin.
    pub(super) fn of(self, center: f64) -> usize {
        (((center - self.low) * self.scale) as usize).min(BINS - 1)
    }
}

/// Whether both sides could still be halved all the way down.
fn fits(first: usize, second: usize, budget: u32) -> bool {
    halvings(first.max(second)) <= budget
}

/// The best split between two bins, of those the budget allows.
pub(super) fn best_bin(items: &[Item], low: DVec3, high: DVec3, budget: u32) -> Option<Split> {
    let mut best: Option<Split> = None;
    for axis in (0..3).filter(|&axis| high[axis] > low[axis]) {
        let bins = Bins::new(low[axis], high[axis]);
        let mut filled = [(Bounds::EMPTY, 0_usize); BINS];
        for item in items {
            let (bounds, count) = &mut filled[bins.of(item.center(axis))];
            bounds.grow(&item.low, &item.high);
            *count += 1;
        }
        // What lies behind each bin.
        let mut behind = [(0.0, 0_usize); BINS];
        let (mut bounds, mut count) = (Bounds::EMPTY, 0);
        for bin in (0..BINS - 1).rev() {
            let (of, more) = &filled[bin + 1];
            bounds.grow(&of.low, &of.high);
            count += more;
            behind[bin] = (if count == 0 { 0.0 } else { bounds.area() }, count);
        }
        let (mut bounds, mut count) = (Bounds::EMPTY, 0);
        for bin in 0..BINS - 1 {
            let (of, more) = &filled[bin];
            bounds.grow(&of.low, &of.high);
            count += more;
            let (area, others) = behind[bin];
            if count == 0 || others == 0 || !fits(count, others, budget) {
                continue;
            }
            let cost = bounds.area() * count as f64 + area * others as f64;
            Split { cost, axis, count, how: How::Bin(bin) }.compete(&mut best, items.len());
        }
    }
    best
}

/// The best split of few boxes in any order of centres, of those the budget allows.
pub(super) fn best_of_few(items: &[Item], budget: u32) -> Option<Split> {
    let mut sorted = [items[0]; FEW];
    let sorted = &mut sorted[..items.len()];
    sorted.copy_from_slice(items);
    let mut best: Option<Split> = None;
    for axis in 0..3 {
        sorted.sort_unstable_by(|a, b| along(axis, a, b));
        let mut behind = [0.0; FEW];
        let mut bounds = Bounds::EMPTY;
        for at in (1..sorted.len()).rev() {
            bounds.grow(&sorted[at].low, &sorted[at].high);
            behind[at] = bounds.area();
        }
        let mut bounds = Bounds::EMPTY;
        for count in 1..sorted.len() {
            bounds.grow(&sorted[count - 1].low, &sorted[count - 1].high);
            let others = sorted.len() - count;
            if !fits(count, others, budget) {
                continue;
            }
            let cost = bounds.area() * count as f64 + behind[count] * others as f64;
            Split { cost, axis, count, how: How::Sorted }.compete(&mut best, items.len());
        }
    }
    best
}
