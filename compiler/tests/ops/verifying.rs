//! What is said of segments that a pass broke.

use phenomenon_compiler::ops::{Number, Op, OpSegment, dead, fold, legalise, split, verify};
use phenomenon_compiler::storage::{FileShape, Source};
use phenomenon_compiler::testing::random::Random;

use crate::random::Case;

fn good() -> OpSegment {
    OpSegment {
        ops: vec![Op::Load(0), Op::Load(1), Op::Less(0, 1), Op::Select(2, 0, 1), Op::Neg(3)],
        sources: vec![Source::Slot(0), Source::Uniform(1)],
        stores: vec![(1, 4), (2, 2)],
        wanted: vec![Source::Slot(3)],
    }
}

const SHAPE: FileShape = FileShape { uniforms: 2, slots: 4 };

#[test]
fn what_every_pass_makes_is_right() {
    for seed in 0..40 {
        let mut random = Random::new(seed);
        let case = Case::new(&mut random, 150);
        verify::whole(&case.segment).expect("it was made with care");
        let legal = legalise::legalise(&case.segment);
        verify::legal(&legal).expect("legalised");
        let folded = dead::remove(&fold::fold(&legal));
        verify::legal(&folded).expect("folded");
        let first_free = case.slots.len() as u32;
        let cut = split::split(&folded, 20, first_free);
        verify::parts(&folded, &cut.parts, first_free).expect("split");
    }
}

#[test]
fn what_a_segment_names_is_there_and_before_it() {
    let broken = |change: fn(&mut OpSegment)| {
        let mut segment = good();
        change(&mut segment);
        let whole = verify::whole(&segment).expect_err("it is broken");
        assert_eq!(verify::inside(&segment, SHAPE), Err(whole));
        whole
    };
    let late = "an operand does not come before its user";
    assert_eq!(broken(|it| it.ops[2] = Op::Less(0, 2)), late);
    assert_eq!(broken(|it| it.ops[4] = Op::Neg(5)), late);
    assert_eq!(broken(|it| it.ops[1] = Op::Load(2)), "a load names no source");
    assert_eq!(broken(|it| it.stores[0].1 = 5), "a store names no operation");
}

#[test]
fn all_of_it_lies_within_the_file() {
    let broken = |change: fn(&mut OpSegment)| {
        let mut segment = good();
        change(&mut segment);
        verify::whole(&segment).expect("it has no file");
        verify::inside(&segment, SHAPE).expect_err("it lies outside")
    };
    verify::inside(&good(), SHAPE).expect("it is good");
    assert_eq!(broken(|it| it.sources[0] = Source::Slot(4)), "a source lies outside the file");
    assert_eq!(broken(|it| it.sources[1] = Source::Uniform(2)), "a source lies outside the file");
    assert_eq!(broken(|it| it.stores[0].0 = 4), "a store lies outside the file");
    let mask = "a mask of who wants it lies outside the file";
    assert_eq!(broken(|it| it.wanted[0] = Source::Slot(4)), mask);
}

#[test]
fn a_segment_is_whole_and_legal() {
    let broken = |change: fn(&mut OpSegment)| {
        let mut segment = good();
        change(&mut segment);
        verify::legal(&segment).expect_err("it is broken")
    };
    verify::legal(&good()).expect("it is good");
    assert_eq!(broken(|it| it.stores[1].0 = 1), "a slot is stored twice");
    let mask = "a mask of who wants it is stored by the segment";
    assert_eq!(broken(|it| it.stores[1].0 = 3), mask);
    assert_eq!(broken(|it| it.ops[2] = Op::Add(0, 1)), "what selects is no mask");
    assert_eq!(broken(|it| it.ops[2] = Op::Constant(1)), "what selects is no mask");
    assert_eq!(broken(|it| it.ops[4] = Op::Sin(3)), "a function is not expanded");
    assert_eq!(broken(|it| it.ops[4] = Op::Number(Number::new(1.0))), "a constant has a type");
}

#[test]
fn parts_are_parts_of_the_whole() {
    let part = |load: u32, store: u32| OpSegment {
        ops: vec![Op::Load(0), Op::Neg(0)],
        sources: vec![Source::Slot(load)],
        stores: vec![(store, 1)],
        wanted: vec![Source::Slot(3)],
    };
    let whole = OpSegment { ops: vec![Op::Load(0), Op::Neg(0), Op::Neg(1)], ..part(0, 1) };
    verify::parts(&whole, &[part(0, 4), part(4, 1)], 4).expect("they are good");
    let broken = |parts: &[OpSegment]| verify::parts(&whole, parts, 4).expect_err("broken");
    let early = "a scratch slot is read before it is written";
    assert_eq!(broken(&[part(4, 1), part(0, 4)]), early);
    assert_eq!(broken(&[part(0, 4), part(4, 2)]), "the parts write other slots");
    assert_eq!(broken(&[part(0, 4)]), "the parts write other slots");
    assert_eq!(broken(&[part(0, 4), part(4, 4)]), "a part reads a slot that it writes");
    let always = OpSegment { wanted: vec![], ..part(4, 1) };
    assert_eq!(broken(&[part(0, 4), always]), "a part is wanted elsewhere than the whole");
}
