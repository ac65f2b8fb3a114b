//! What holds of every segment, whatever pass made it. Asked after each pass in debug builds, and, as
//! far as the safety of running machine code rests on it, of every segment that is compiled.

use std::collections::HashSet;

use super::{Op, OpId, OpSegment};
use crate::storage::{FileShape, Source};

/// Whether all that the segment names exists, and comes before what names it: operands, sources,
/// what is stored; and whether all of it lies within a file of this shape. Machine code relies on it.
///
/// # Errors
/// What is wrong.
pub fn inside(segment: &OpSegment, shape: FileShape) -> Result<(), &'static str> {
    let within = |source: &Source| match *source {
        Source::Uniform(at) | Source::Constant { at, .. } => (at as usize) < shape.uniforms,
        Source::Slot(slot) => (slot as usize) < shape.slots,
    };
    if !segment.sources.iter().all(within) {
        return Err("a source lies outside the file");
    }
    if !segment.wanted.iter().all(within) {
        return Err("a mask of who wants it lies outside the file");
    }
    ordered(segment)?;
    let stored = |&(slot, _): &(u32, OpId)| (slot as usize) < shape.slots;
    if segment.stores.iter().all(stored) { Ok(()) } else { Err("a store lies outside the file") }
}

/// Whether operands come before their users, and loads and stores name what there is.
fn ordered(segment: &OpSegment) -> Result<(), &'static str> {
    for (id, op) in segment.ops.iter().enumerate() {
        let mut ordered = true;
        op.for_each_operand(|operand| ordered &= (operand as usize) < id);
        if !ordered {
            return Err("an operand does not come before its user");
        }
        if let Op::Load(source) = *op
            && source as usize >= segment.sources.len()
        {
            return Err("a load names no source");
        }
    }
    let computed = |&(_, id): &(u32, OpId)| (id as usize) < segment.ops.len();
    if segment.stores.iter().all(computed) { Ok(()) } else { Err("a store names no operation") }
}

/// Whether it is a segment at all: what [`inside`] asks, without a file; no slot is stored twice, nor one
/// that says who wants the segment; and what selects is a mask, all bits set or none.
///
/// # Errors
/// What is wrong.
pub fn whole(segment: &OpSegment) -> Result<(), &'static str> {
    ordered(segment)?;
    let mut stored = HashSet::new();
    for &(slot, _) in &segment.stores {
        if !stored.insert(slot) {
            return Err("a slot is stored twice");
        }
        if segment.wanted.contains(&Source::Slot(slot)) {
            return Err("a mask of who wants it is stored by the segment");
        }
    }
    let masks = masks(&segment.ops);
    let selects = segment.ops.iter().filter_map(|op| match op {
        Op::Select(mask, ..) => Some(*mask),
        _ => None,
    });
    for mask in selects {
        if !masks[mask as usize] {
            return Err("what selects is no mask");
        }
    }
    Ok(())
}

/// Which operations yield masks, those included of which that is not known: what is loaded.
pub fn masks(ops: &[Op]) -> Vec<bool> {
    let mut masks: Vec<bool> = Vec::with_capacity(ops.len());
    for &op in ops {
        let is = |id: OpId| masks.get(id as usize).copied().unwrap_or(false);
        let mask = match op {
            Op::Load(_) => true,
            Op::Constant(bits) => bits == 0 || bits == u32::MAX,
            Op::And(a, b) | Op::Or(a, b) | Op::Xor(a, b) => is(a) && is(b),
            Op::Not(a) => is(a),
            Op::Select(_, a, b) => is(a) && is(b),
            op => op.class() == Some(super::Class::Mask),
        };
        masks.push(mask);
    }
    masks
}

/// Whether it is [`whole`], and of 32-bit operations alone: what [`legalise`](super::legalise) makes and
/// all later passes keep.
///
/// # Errors
/// What is wrong.
pub fn legal(segment: &OpSegment) -> Result<(), &'static str> {
    whole(segment)?;
    let is_typed = |op: &Op| matches!(op, Op::Number(_) | Op::Integer(_) | Op::Truth(_));
    if segment.ops.iter().any(is_typed) {
        return Err("a constant has a type");
    }
    if segment.ops.iter().any(|op| op.is_function()) {
        return Err("a function is not expanded");
    }
    Ok(())
}

/// Whether parts made of `whole` are [`legal`], wanted where it is, and write a scratch slot (from
/// `first_free` on) before they read it; whether they write what it writes, and no slot that they read.
///
/// # Errors
/// What is wrong.
pub fn parts(whole: &OpSegment, parts: &[OpSegment], first_free: u32) -> Result<(), &'static str> {
    let mut written = HashSet::new();
    for part in parts {
        legal(part)?;
        if part.wanted != whole.wanted {
            return Err("a part is wanted elsewhere than the whole");
        }
        for source in &part.sources {
            if let Source::Slot(slot) = *source
                && slot >= first_free
                && !written.contains(&slot)
            {
                return Err("a scratch slot is read before it is written");
            }
        }
        if parts.len() > 1
            && part.stores.iter().any(|(slot, _)| part.sources.contains(&Source::Slot(*slot)))
        {
            return Err("a part reads a slot that it writes");
        }
        written.extend(part.stores.iter().map(|(slot, _)| *slot));
    }
    let own = written.iter().filter(|slot| **slot < first_free).count();
    let all = whole.stores.iter().all(|(slot, _)| written.contains(slot));
    if all && own == whole.stores.len() { Ok(()) } else { Err("the parts write other slots") }
}

/// In debug builds, panics if what a pass made is not right.
pub(crate) fn after(pass: &str, check: impl FnOnce() -> Result<(), &'static str>) {
    if cfg!(debug_assertions)
        && let Err(what) = check()
    {
        panic!("after {pass}: {what}");
    }
}
