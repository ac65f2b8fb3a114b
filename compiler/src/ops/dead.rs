//! Removal of operations no store depends on, and of sources nothing loads.

use super::{Op, OpId, OpSegment};

/// The segment without its dead operations, renumbered in the same order.
pub fn remove(segment: &OpSegment) -> OpSegment {
    let live = live(segment);
    let mut sources = Vec::new();
    let mut new_source = vec![None; segment.sources.len()];
    let mut new_id: Vec<OpId> = vec![0; segment.ops.len()];
    let mut ops = Vec::with_capacity(segment.ops.len());
    for (id, &op) in segment.ops.iter().enumerate() {
        if !live[id] {
            continue;
        }
        new_id[id] = ops.len() as OpId;
        ops.push(match op {
            Op::Load(source) => {
                let source = source as usize;
                Op::Load(*new_source[source].get_or_insert_with(|| {
                    sources.push(segment.sources[source]);
                    sources.len() as u32 - 1
                }))
            }
            op => op.map_operands(|id| new_id[id as usize]),
        });
    }
    let stores = segment.stores.iter().map(|&(slot, id)| (slot, new_id[id as usize])).collect();
    OpSegment { ops, sources, stores, wanted: segment.wanted.clone() }
}

fn live(segment: &OpSegment) -> Vec<bool> {
    let mut live = vec![false; segment.ops.len()];
    for &(_, id) in &segment.stores {
        live[id as usize] = true;
    }
    for id in (0..segment.ops.len()).rev() {
        if live[id] {
            segment.ops[id].for_each_operand(|operand| live[operand as usize] = true);
        }
    }
    live
}
