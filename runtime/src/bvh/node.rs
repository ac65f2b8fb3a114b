//! The ray test of a node's eight boxes.
//!
//! obvhs has its own, but it drops boxes nearer than 1e-4 and rays along a box face; this one errs
//! on the side of a hit by a bound on every rounding on the way, so that no tree, whatever its
//! shape, loses a hit its primitives have.

use glam::DVec3;
use obvhs::cwbvh::node::CwBvhNode;

use crate::geometry::single;

/// Smallest direction component whose inverse is taken; below it the ray moves less than any box
/// is padded.
const SMALLEST_DIRECTION: f32 = 1e-25;

/// Slack in parts of the distance from the origin to the node: the subtraction, the product, the
/// rounding of the direction, and what the primitives' tests may differ by.
const DISTANCE_SLACK: f32 = 1e-6;

/// Slack in parts of the origin's coordinates, which are rounded to f32: half a unit in the last
/// place, and room.
const ORIGIN_SLACK: f32 = 1.0 / (1 << 23) as f32;

/// Slack in parts of the node's extent: obvhs takes the extent's exponent by an inexact log2.
const EXTENT_SLACK: f32 = 255.0 * 1e-5;

/// A ray made ready for box tests.
#[derive(Clone, Copy, Debug)]
pub(super) struct BoxRay {
    origin: [f32; 3],
    inverse: [f32; 3],
    negative: [bool; 3],
    /// Order in which children are visited, as obvhs encodes it.
    pub(super) octant: u32,
}

impl BoxRay {
    #[inline(always)]
    pub(super) fn new(origin: DVec3, direction: DVec3) -> Self {
        let (origin, direction) = (single(origin), single(direction));
        let inverse = direction.map(|x| {
            let size = if x.abs() < SMALLEST_DIRECTION { SMALLEST_DIRECTION } else { x.abs() };
            (1.0 / size).copysign(x)
        });
        let negative = direction.map(f32::is_sign_negative);
        let bit = |axis: usize, bits: u32| if negative[axis] { 0 } else { bits };
        let octant = bit(0, 0x0404_0404) | bit(1, 0x0202_0202) | bit(2, 0x0101_0101);
        Self { origin, inverse, negative, octant }
    }

    /// Bits of the children whose boxes the ray may meet before `farthest`.
    #[inline(always)]
    pub(super) fn children(&self, node: &CwBvhNode, farthest: f32) -> u32 {
        let corner = [node.p.x, node.p.y, node.p.z];
        let low = [&node.child_min_x, &node.child_min_y, &node.child_min_z];
        let high = [&node.child_max_x, &node.child_max_y, &node.child_max_z];
        let mut enter = [0.0_f32; 8];
        let mut leave = [farthest; 8];
        for axis in 0..3 {
            let extent = f32::from_bits(u32::from(node.e[axis]) << 23);
            let inverse = self.inverse[axis];
            let away = corner[axis] - self.origin[axis];
            let slack = away.abs() * DISTANCE_SLACK
                + self.origin[axis].abs() * ORIGIN_SLACK
                + extent * EXTENT_SLACK;
            let slack = slack * inverse.abs();
            let (scale, base) = (extent * inverse, away * inverse);
            let (first, last) = (base - slack, base + slack);
            let (near, far) = match self.negative[axis] {
                true => (high[axis], low[axis]),
                false => (low[axis], high[axis]),
            };
            for child in 0..8 {
                // A NaN compares false and leaves the interval as it is: a hit.
                let entry = f32::from(near[child]) * scale + first;
                enter[child] = if entry > enter[child] { entry } else { enter[child] };
                let exit = f32::from(far[child]) * scale + last;
                leave[child] = if exit < leave[child] { exit } else { leave[child] };
            }
        }
        let (bits, shifts) = node.get_child_and_index_bits(self.octant);
        let (bits, shifts) = (bits.to_le_bytes(), shifts.to_le_bytes());
        let mut mask = 0;
        for child in 0..8 {
            let met = u32::from(enter[child] <= leave[child]);
            mask |= (u32::from(bits[child]) * met) << shifts[child];
        }
        mask
    }
}
