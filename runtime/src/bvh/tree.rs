//! Building the tree, and finding the nearest hit or every hit of a ray.

use obvhs::cwbvh::CwBvh;
use obvhs::cwbvh::bvh2_to_cwbvh::bvh2_to_cwbvh;

use super::build::{LEVELS_LIMIT, binary_tree};
use super::node::BoxRay;
use crate::geometry::{PreparedRay, Primitive, RawHit};

/// Entries of the stack of a traversal: one for every level of the tree, at most. A node of eight
/// stands for one or more inner nodes of the binary tree in a row, so on no way down are there more
/// of them than levels below the binary tree's root.
const STACK: usize = LEVELS_LIMIT as usize;

/// Most primitives of a scene.
const PRIMITIVE_LIMIT: usize = 1 << 28;

/// Bytes a primitive takes while the tree is built: its copy and its box here and in `build.rs`,
/// two binary nodes, and in obvhs 14 decisions, its share of nodes, and its index.
const BYTES_TO_BUILD: usize = 440;

/// Why no tree could be built.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TreeError {
    /// The scene has too many primitives.
    #[error("the scene has {0} primitives; the limit is {PRIMITIVE_LIMIT}")]
    TooManyPrimitives(usize),
    /// There is no memory for the tree.
    #[error("there is not enough memory for a tree of {0} primitives")]
    OutOfMemory(usize),
}

/// Which object a primitive belongs to, and its number in it. Ordered: of two hits at the same
/// distance the lower one counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PrimitiveId {
    /// Number of the object.
    pub object: u32,
    /// Primitive number within the object.
    pub primitive: u32,
}

/// Primitives in a bounding volume hierarchy.
#[derive(Debug, Default)]
pub struct Tree {
    nodes: CwBvh,
    /// In the order of the tree's leaves.
    primitives: Vec<Primitive>,
    ids: Vec<PrimitiveId>,
}

impl Tree {
    /// Builds the tree.
    pub fn build(primitives: &[(PrimitiveId, Primitive)]) -> Result<Self, TreeError> {
        if primitives.len() > PRIMITIVE_LIMIT {
            return Err(TreeError::TooManyPrimitives(primitives.len()));
        }
        if primitives.is_empty() {
            return Ok(Self::default());
        }
        let no_memory = |_| TreeError::OutOfMemory(primitives.len());
        // obvhs takes its memory without asking. So all of it is asked for before, and given back.
        let all = Vec::<u8>::new().try_reserve_exact(primitives.len() * BYTES_TO_BUILD);
        all.map_err(no_memory)?;
        let boxes: Vec<_> = primitives.iter().map(|(_, primitive)| primitive.bounds()).collect();
        let binary = binary_tree(&boxes).map_err(no_memory)?;
        drop(boxes);
        let nodes = bvh2_to_cwbvh(&binary, 3, true, false);
        let at = |index: &u32| primitives[*index as usize];
        let (ids, primitives) = nodes.primitive_indices.iter().map(at).unzip();
        Ok(Self { nodes, primitives, ids })
    }

    /// The primitive at a slot.
    #[inline(always)]
    pub fn primitive(&self, slot: u32) -> &Primitive {
        &self.primitives[slot as usize]
    }

    /// The object and number of the primitive at a slot.
    #[inline(always)]
    pub fn id(&self, slot: u32) -> PrimitiveId {
        self.ids[slot as usize]
    }

    /// How many primitives it holds.
    pub fn len(&self) -> usize {
        self.primitives.len()
    }

    /// Bytes it takes in memory.
    pub fn bytes(&self) -> u64 {
        let nodes = size_of_val(self.nodes.nodes.as_slice());
        let numbers = size_of_val(self.nodes.primitive_indices.as_slice());
        let held = size_of_val(self.primitives.as_slice()) + size_of_val(self.ids.as_slice());
        (nodes + numbers + held) as u64
    }

    /// Whether it holds none.
    pub fn is_empty(&self) -> bool {
        self.primitives.is_empty()
    }

    /// Corners of the box round everything; none without primitives.
    pub fn bounds(&self) -> Option<([f32; 3], [f32; 3])> {
        let bounds = self.nodes.total_aabb;
        (!self.is_empty()).then(|| (bounds.min.into(), bounds.max.into()))
    }

    /// The nearest hit at a distance above 0 and at most `farthest`. Of equal distances the lowest
    /// (object, primitive).
    pub fn nearest(&self, ray: &PreparedRay, farthest: f64) -> Option<RawHit> {
        #[cfg(target_arch = "x86_64")]
        {
            #[target_feature(enable = "avx2,bmi1,lzcnt,popcnt")]
            fn native(tree: &Tree, ray: &PreparedRay, farthest: f64) -> Option<RawHit> {
                tree.find_nearest(ray, farthest)
            }
            if has_native() {
                // SAFETY: the features were detected.
                return unsafe { native(self, ray, farthest) };
            }
        }
        self.find_nearest(ray, farthest)
    }

    /// Gives `found` every hit at a distance above 0 and at most `farthest`, in no order, until it
    /// returns false.
    pub fn every(&self, ray: &PreparedRay, farthest: f64, found: impl FnMut(RawHit) -> bool) {
        #[cfg(target_arch = "x86_64")]
        {
            #[target_feature(enable = "avx2,bmi1,lzcnt,popcnt")]
            fn native(
                tree: &Tree,
                ray: &PreparedRay,
                farthest: f64,
                found: impl FnMut(RawHit) -> bool,
            ) {
                tree.find_every(ray, farthest, found);
            }
            if has_native() {
                // SAFETY: the features were detected.
                return unsafe { native(self, ray, farthest, found) };
            }
        }
        self.find_every(ray, farthest, found);
    }

    #[inline(always)]
    fn find_nearest(&self, ray: &PreparedRay, farthest: f64) -> Option<RawHit> {
        let mut best: Option<RawHit> = None;
        let mut limit = farthest;
        self.traverse(ray, farthest, |slot| {
            if let Some(hit) = self.primitives[slot as usize].nearest(ray, slot) {
                let nearer = hit.t < limit
                    || hit.t == limit && best.is_none_or(|best| self.id(slot) < self.id(best.slot));
                if nearer {
                    limit = hit.t;
                    best = Some(hit);
                }
            }
            Some(limit)
        });
        best
    }

    #[inline(always)]
    fn find_every(&self, ray: &PreparedRay, farthest: f64, mut found: impl FnMut(RawHit) -> bool) {
        self.traverse(ray, farthest, |slot| {
            let mut going_on = true;
            self.primitives[slot as usize].every(ray, slot, |hit| {
                going_on = going_on && (hit.t > farthest || found(hit));
            });
            going_on.then_some(farthest)
        });
    }

    /// Calls `visit` with the slots whose boxes the ray may meet. It returns how far hits still
    /// matter, or none to end.
    #[inline(always)]
    fn traverse(
        &self,
        ray: &PreparedRay,
        farthest: f64,
        mut visit: impl FnMut(u32) -> Option<f64>,
    ) {
        if self.nodes.nodes.is_empty() {
            return;
        }
        let boxes = BoxRay::new(ray.origin, ray.direction);
        let mut limit = (farthest as f32).next_up();
        let mut stack = [(0_u32, 0_u32); STACK];
        let mut depth = 0;
        // Children still to visit: the first one's position, and a bit for each (upper byte, in
        // order of visit) over the bits of those that are inner nodes (lowest byte).
        let (mut base, mut children) = (0_u32, 0x8000_0000_u32);
        loop {
            if children & 0xff00_0000 == 0 {
                if depth == 0 {
                    return;
                }
                depth -= 1;
                (base, children) = stack[depth];
            }
            let bit = 31 - children.leading_zeros();
            let inner = children;
            children &= !(1 << bit);
            if children & 0xff00_0000 != 0 {
                stack[depth] = (base, children);
                depth += 1;
            }
            let position = (bit - 24) ^ (boxes.octant & 0xff);
            let rank = (inner & !(u32::MAX << position)).count_ones();
            let node = &self.nodes.nodes[(base + rank) as usize];
            let met = boxes.children(node, limit);
            base = node.child_base_idx;
            children = (met & 0xff00_0000) | u32::from(node.imask);
            let mut primitives = met & 0x00ff_ffff;
            while primitives != 0 {
                let offset = 31 - primitives.leading_zeros();
                primitives &= !(1 << offset);
                match visit(node.primitive_base_idx + offset) {
                    Some(farthest) => limit = (farthest as f32).next_up(),
                    None => return,
                }
            }
        }
    }
}

/// Whether the CPU has what the loops are compiled for besides the baseline: the same operations in
/// the same order, eight boxes at once.
#[cfg(target_arch = "x86_64")]
#[inline]
fn has_native() -> bool {
    std::arch::is_x86_feature_detected!("avx2")
        && std::arch::is_x86_feature_detected!("bmi1")
        && std::arch::is_x86_feature_detected!("lzcnt")
        && std::arch::is_x86_feature_detected!("popcnt")
}
