//! Building the binary tree that is folded into the one rays go through.
//!
//! Boxes are split from the top down where the surface area heuristic (MacDonald and Booth 1990)
//! expects the fewest tests: between 32 bins along each axis (Wald 2007), and between all orders of
//! the centres once there are few. That alone is neither balanced nor fast: of boxes one within
//! another it may cut off one at a time, and of equal boxes none. So every node has a *budget*, the
//! most levels there may be below it. A split counts only if both sides could still be halved all
//! the way down within the budget; where none does, the boxes are halved, by their order along the
//! widest axis or, round one centre, by size.
//!
//! *Depth.* Let b(n) be the least number of times n is halved, rounded up, until 1 is left. A node
//! of n boxes is entered with a budget of at least b(n): the root by [`budget`], a side of a split
//! that counts by the rule, a half because b of half of n, rounded up, is b(n) - 1. A node of one
//! box has no children, and every level takes 1 of the budget. So no leaf is deeper than the root's
//! budget, 2 b(n) + 16 and at most [`LEVELS_LIMIT`], whatever the boxes.
//!
//! *Time.* A level looks at each box a fixed number of times: bounds, bins, one partition or the
//! selection of a median. (Sorting happens for at most [`FEW`] boxes.) There are at most 2 b(n) +
//! 17 levels: n log n, whatever the boxes.

use std::collections::TryReserveError;

use glam::{DVec3, Vec3A};
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::node::Bvh2Node;

use super::split::{
    Bins, Bounds, FEW, How, Item, Split, along, best_bin, best_of_few, centers, halvings,
};

/// Most levels below the root.
pub(super) const LEVELS_LIMIT: u32 = 60;

/// From so many boxes on, the two sides are built in parallel.
const MANY: usize = 8192;

/// How many levels there may be below a node of that many boxes that is the root.
fn budget(count: usize) -> u32 {
    (2 * halvings(count) + 16).min(LEVELS_LIMIT)
}

/// A binary tree of boxes, one to a leaf. There is at least one box, and no coordinate is infinite
/// or no number.
pub(super) fn binary_tree(boxes: &[([f32; 3], [f32; 3])]) -> Result<Bvh2, TryReserveError> {
    let mut items = Vec::new();
    items.try_reserve_exact(boxes.len())?;
    items.extend(boxes.iter().enumerate().map(|(index, &(low, high))| Item {
        low,
        high,
        index: index as u32,
    }));
    let mut nodes = Vec::new();
    nodes.try_reserve_exact(2 * boxes.len() - 1)?;
    nodes.resize(2 * boxes.len() - 1, Bvh2Node::default());
    let mut primitive_indices = Vec::new();
    primitive_indices.try_reserve_exact(boxes.len())?;
    let (root, below) = nodes.split_at_mut(1);
    let part = Part { items: &mut items, first_item: 0, node: &mut root[0], below, first_below: 1 };
    part.build(budget(boxes.len()));
    primitive_indices.extend(items.iter().map(|item| item.index));
    Ok(Bvh2 { nodes, primitive_indices, ..Bvh2::default() })
}

/// A part of the tree that is still to be built.
struct Part<'a> {
    items: &'a mut [Item],
    /// Position of the first item among all.
    first_item: u32,
    node: &'a mut Bvh2Node,
    /// The nodes below it, two for every item but one.
    below: &'a mut [Bvh2Node],
    /// Position of the first of them among all nodes.
    first_below: u32,
}

impl Part<'_> {
    fn build(self, budget: u32) {
        let Part { items, first_item, node, below, first_below } = self;
        let mut bounds = Bounds::EMPTY;
        items.iter().for_each(|item| bounds.grow(&item.low, &item.high));
        let aabb = Aabb::new(Vec3A::from(bounds.low), Vec3A::from(bounds.high));
        if items.len() == 1 {
            *node = Bvh2Node::new(aabb, 1, first_item);
            return;
        }
        *node = Bvh2Node::new(aabb, 0, first_below);
        let is_many = items.len() >= MANY;
        let middle = divide(items, budget - 1);
        let (first, second) = items.split_at_mut(middle);
        let (children, below) = below.split_at_mut(2);
        let (first_child, second_child) = children.split_at_mut(1);
        let of_first = 2 * middle - 2;
        let (below_first, below_second) = below.split_at_mut(of_first);
        let first = Part {
            items: first,
            first_item,
            node: &mut first_child[0],
            below: below_first,
            first_below: first_below + 2,
        };
        let second = Part {
            items: second,
            first_item: first_item + middle as u32,
            node: &mut second_child[0],
            below: below_second,
            first_below: first_below + 2 + of_first as u32,
        };
        if is_many {
            rayon::join(|| first.build(budget - 1), || second.build(budget - 1));
        } else {
            first.build(budget - 1);
            second.build(budget - 1);
        }
    }
}

/// Orders at least two boxes so that the first so many are one side, and as many others as can be
/// halved within the budget the other.
fn divide(items: &mut [Item], budget: u32) -> usize {
    let (low, high) = centers(items);
    let split = match items.len() <= FEW {
        true => best_of_few(items, budget),
        false => best_bin(items, low, high, budget),
    };
    match split {
        Some(Split { axis, count, how: How::Sorted, .. }) => {
            items.sort_unstable_by(|a, b| along(axis, a, b));
            count
        }
        Some(Split { axis, count, how: How::Bin(last), .. }) => {
            let bins = Bins::new(low[axis], high[axis]);
            let middle = partition(items, |item| bins.of(item.center(axis)) <= last);
            debug_assert_eq!(middle, count);
            middle
        }
        None => {
            halve(items, low, high);
            items.len() / 2
        }
    }
}

/// Puts the lesser half first: along the axis the centres differ most on, or the smaller boxes
/// where all have one centre.
fn halve(items: &mut [Item], low: DVec3, high: DVec3) {
    let width = high - low;
    let middle = items.len() / 2;
    let size = |item: &Item| Bounds { low: item.low, high: item.high }.area();
    if width == DVec3::ZERO {
        items.select_nth_unstable_by(middle, |a, b| {
            size(a).total_cmp(&size(b)).then(a.index.cmp(&b.index))
        });
        return;
    }
    let axis = (0..3).max_by(|a, b| width[*a].total_cmp(&width[*b])).unwrap_or(0);
    items.select_nth_unstable_by(middle, |a, b| along(axis, a, b));
}

/// Puts the boxes that are wanted first; how many there are.
fn partition(items: &mut [Item], is_first: impl Fn(&Item) -> bool) -> usize {
    let mut count = 0;
    for at in 0..items.len() {
        if is_first(&items[at]) {
            items.swap(at, count);
            count += 1;
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    type Box3 = ([f32; 3], [f32; 3]);

    /// Levels below the root, and how often a box lies in an inner node: what building costs, up to
    /// a factor. On the way every node is found to hold its children, and every box to be in one
    /// leaf.
    fn measured(boxes: &[Box3]) -> (u32, u64) {
        let tree = binary_tree(boxes).unwrap();
        let (mut deepest, mut looks) = (0, 0);
        let mut seen = vec![false; boxes.len()];
        // Children stand behind their parents: from the end, what is below is known.
        let mut counts = vec![0_u64; tree.nodes.len()];
        for at in (0..tree.nodes.len()).rev() {
            let node = &tree.nodes[at];
            let bounds = node.aabb();
            let inside =
                |aabb: &Aabb| bounds.min.cmple(aabb.min).all() && bounds.max.cmpge(aabb.max).all();
            if node.prim_count == 0 {
                let children = [node.first_index as usize, node.first_index as usize + 1];
                assert!(
                    children.iter().all(|&child| child > at && inside(tree.nodes[child].aabb()))
                );
                counts[at] = children.iter().map(|&child| counts[child]).sum();
                looks += counts[at];
            } else {
                counts[at] = 1;
                let index = tree.primitive_indices[node.first_index as usize] as usize;
                let (low, high) = boxes[index];
                assert!(inside(&Aabb::new(Vec3A::from(low), Vec3A::from(high))));
                assert!(!std::mem::replace(&mut seen[index], true));
            }
        }
        assert!(seen.iter().all(|seen| *seen));
        let mut open = vec![(0, 0)];
        while let Some((at, level)) = open.pop() {
            deepest = deepest.max(level);
            let node: &Bvh2Node = &tree.nodes[at];
            if node.prim_count == 0 {
                open.extend([0, 1].map(|child| (node.first_index as usize + child, level + 1)));
            }
        }
        (deepest, looks)
    }

    fn cube(center: [f32; 3], size: f32) -> Box3 {
        (center.map(|x| x - size), center.map(|x| x + size))
    }

    /// Lists of boxes that make builders deep or slow.
    fn hard(count: usize) -> Vec<(&'static str, Vec<Box3>)> {
        let list = |of: &dyn Fn(usize) -> Box3| (0..count).map(of).collect::<Vec<_>>();
        let power = |at: usize| (24.0 * at as f64 / count as f64 - 12.0).exp2() as f32;
        let growing = |at: usize| 10f32.powf(12.0 * at as f32 / count as f32 - 6.0);
        vec![
            ("equal", list(&|_| cube([0.5; 3], 1.0))),
            ("equal points", list(&|_| cube([0.5; 3], 0.0))),
            ("two places", list(&|at| cube([(at % 2) as f32; 3], 0.25))),
            ("concentric", list(&|at| cube([0.0; 3], growing(at)))),
            ("nested in a corner", list(&|at| ([0.0; 3], [growing(at); 3]))),
            ("geometric row", list(&|at| cube([power(at) * 3.0, 0.0, 0.0], power(at)))),
            ("geometric points", list(&|at| cube([0.0, growing(at) * growing(at), 0.0], 0.0))),
            ("touching row", list(&|at| ([at as f32, 0.0, 0.0], [at as f32 + 1.0, 1.0, 1.0]))),
            ("points on a line", list(&|at| cube([0.0, 0.0, at as f32], 0.0))),
            ("fan", list(&|at| ([0.0; 3], [at as f32, 1.0, 0.0]))),
            (
                "as far as may be",
                list(&|at| cube([if at == 0 { 1e12 } else { 1e-30 * at as f32 }; 3], 0.0)),
            ),
            ("subnormal", list(&|at| cube([f32::from_bits(at as u32), 0.0, 0.0], 0.0))),
        ]
    }

    #[test]
    fn no_boxes_make_the_tree_deep_or_slow() {
        for count in [1, 2, 3, 4, 5, 15, 16, 17, 65, 300, 500, 4097] {
            for (name, boxes) in hard(count) {
                let (levels, looks) = measured(&boxes);
                assert!(levels <= budget(count), "{name} of {count}: {levels} levels");
                assert!(looks <= count as u64 * u64::from(budget(count)), "{name} of {count}");
            }
        }
    }

    #[test]
    fn what_would_take_minutes_in_quadratic_time_is_built() {
        for (name, boxes) in hard(100_000) {
            let (levels, _) = measured(&boxes);
            assert!(levels <= budget(boxes.len()), "{name}: {levels} levels");
        }
    }

    #[test]
    fn budgets_are_enough_to_halve_and_fit_the_stack() {
        for count in (1..70).chain([1 << 20, (1 << 20) + 1, 1 << 28]) {
            assert!((halvings(count)..=LEVELS_LIMIT).contains(&budget(count)), "{count}");
            assert!(1_usize << halvings(count) >= count);
        }
    }

    #[test]
    fn equal_boxes_are_halved_evenly_and_separate_ones_apart() {
        let (levels, _) = measured(&vec![cube([0.0; 3], 1.0); 1024]);
        assert_eq!(levels, 10);
        // Two clusters: the root's children do not overlap.
        let boxes: Vec<Box3> = (0..100)
            .map(|at| cube([if at % 3 == 0 { 10.0 } else { -10.0 } + at as f32 * 0.01; 3], 0.1))
            .collect();
        let tree = binary_tree(&boxes).unwrap();
        let (first, second) = (tree.nodes[1].aabb(), tree.nodes[2].aabb());
        assert!(first.max.x < second.min.x || second.max.x < first.min.x);
    }
}
