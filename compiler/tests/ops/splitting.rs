//! Cutting long segments: the parts together do what the whole does.

use phenomenon_compiler::ops::{Op, OpSegment, split};
use phenomenon_compiler::storage::Source;
use phenomenon_compiler::testing::random::Random;

use crate::random::Case;
use crate::samples::{File, Kind};

#[test]
fn parts_do_what_the_whole_does() {
    for seed in 0..80 {
        let mut random = Random::new(1000 + seed);
        let size = 30 + random.below(300);
        let case = Case::new(&mut random, size);
        let limit = 1 + random.below(50);
        let first_free = case.slots.len() as u32;
        let cut = split::split(&case.segment, limit, first_free);
        let mut whole = case.file(&mut random, cut.scratch, 2);
        let mut parts = whole.clone();
        whole.interpret(&case.segment);
        for part in &cut.parts {
            check_part(part, limit, first_free + cut.scratch);
            parts.interpret(part);
        }
        let what = format!("seed {seed}, limit {limit}\n{}", case.segment);
        parts.assert_same(&whole, first_free, |slot| case.slots[slot as usize], &what);
    }
}

fn check_part(part: &OpSegment, limit: usize, slots: u32) {
    let work = part.ops.iter().filter(|op| !op.is_fetch()).count();
    assert!(work <= limit, "{work} operations, at most {limit} were asked for");
    for &(slot, _) in &part.stores {
        assert!(slot < slots);
        assert!(!part.sources.contains(&Source::Slot(slot)), "slot {slot} is read and written");
    }
}

#[test]
fn a_short_segment_stays_whole() {
    let case = Case::new(&mut Random::new(5), 60);
    let cut = split::split(&case.segment, split::COMFORTABLE, 99);
    assert_eq!((cut.parts.as_slice(), cut.scratch), (&[case.segment][..], 0));
}

/// A chain in which one value crosses each cut needs two scratch slots, however long it is: one is
/// read while the other is written.
#[test]
fn scratch_slots_are_used_again() {
    let mut ops = vec![Op::Load(0), Op::Constant(0x3f80_0001)];
    for id in 1..400 {
        ops.push(if id == 1 { Op::Mul(0, 1) } else { Op::Mul(id, 1) });
    }
    let last = ops.len() as u32 - 1;
    let segment =
        OpSegment { ops, sources: vec![Source::Slot(0)], stores: vec![(1, last)], wanted: vec![] };
    let cut = split::split(&segment, 20, 2);
    assert!(cut.parts.len() >= 20);
    assert_eq!(cut.scratch, 2);
}

/// The segment swaps two slots; the first part must not overwrite what a later one reads.
#[test]
fn a_slot_read_later_is_not_overwritten_before() {
    let segment = OpSegment {
        ops: vec![Op::Load(0), Op::Neg(0), Op::Load(1), Op::Neg(2), Op::Neg(3), Op::Neg(4)],
        sources: vec![Source::Slot(0), Source::Slot(1)],
        stores: vec![(1, 1), (0, 5)],
        wanted: vec![],
    };
    let cut = split::split(&segment, 1, 2);
    assert!(cut.parts.len() > 2);
    let mut whole = File::new(0, 2 + cut.scratch as usize, 1);
    whole.slot(0, 0).0 = [1.0f32.to_bits(); 8];
    whole.slot(0, 1).0 = [2.0f32.to_bits(); 8];
    let mut parts = whole.clone();
    whole.interpret(&segment);
    cut.parts.iter().for_each(|part| parts.interpret(part));
    parts.assert_same(&whole, 2, |_| Kind::Real, &segment.to_string());
    assert_eq!(whole.slot(0, 1).0[0], (-1.0f32).to_bits());
}
