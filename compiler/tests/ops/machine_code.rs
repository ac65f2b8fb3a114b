//! Machine code against the interpreter, bit for bit.

use std::sync::Arc;

use phenomenon_compiler::emit::Table;
use phenomenon_compiler::engine::jit::{JitCode, JitError};
use phenomenon_compiler::ops::{Op, OpSegment, dead, fold, split};
use phenomenon_compiler::storage::{FileShape, LANES, Lanes, Source};

use crate::random::Case;
use crate::samples::{File, Kind, Random, yields};

/// Whether there is code on this machine; a machine without has nothing to test here, and must
/// say why.
pub fn available() -> bool {
    match JitCode::available() {
        Ok(()) => true,
        Err(JitError::UnsupportedTarget | JitError::MissingFeature(_)) => false,
        Err(other) => panic!("{other}"),
    }
}

/// Runs segments as machine code.
pub fn run(segments: &[OpSegment], file: &mut File) {
    let code = JitCode::compile(segments, FileShape { uniforms: file.uniforms, slots: file.slots })
        .expect("compiles");
    for index in 0..segments.len() {
        code.run(index, &mut file.lanes, file.blocks);
    }
}

/// Runs `op` over all combinations of hard operands, from slots or with some of them constant.
fn exhaust(op: Op, kinds: &[Kind]) {
    let words: Vec<_> = kinds.iter().map(|kind| kind.words()).collect();
    let points: usize = words.iter().map(Vec::len).product();
    let blocks = points.div_ceil(LANES);
    let arity = kinds.len();
    let mut file = File::new(0, arity + 1, blocks);
    for point in 0..blocks * LANES {
        let mut rest = point % points;
        for (slot, words) in words.iter().enumerate() {
            file.slot(point / LANES, slot as u32).0[point % LANES] = words[rest % words.len()];
            rest /= words.len();
        }
    }
    let mut ops: Vec<_> = (0..arity as u32).map(Op::Load).collect();
    ops.push(op);
    let segment = OpSegment {
        ops,
        sources: (0..arity as u32).map(Source::Slot).collect(),
        stores: vec![(arity as u32, arity as u32)],
        wanted: vec![],
    };
    let kind = yields(op, |id| kinds[id as usize]);
    let mut expected = file.clone();
    expected.interpret(&segment);
    run(std::slice::from_ref(&segment), &mut file);
    let compared = |slot| if slot == arity as u32 { kind } else { Kind::Int };
    file.assert_same(&expected, arity as u32 + 1, compared, &segment.to_string());
}

#[test]
fn every_operation_over_all_hard_operands() {
    use Kind::{Int, Mask, Real};
    if !available() {
        return;
    }
    for op in [Op::Neg(0), Op::Absolute(0), Op::Sqrt(0), Op::Floor(0), Op::Ceil(0)] {
        exhaust(op, &[Real]);
    }
    for op in [Op::Truncate(0), Op::RoundEven(0), Op::ToInt(0)] {
        exhaust(op, &[Real]);
    }
    for op in [Op::Add(0, 1), Op::Sub(0, 1), Op::Mul(0, 1), Op::Div(0, 1)] {
        exhaust(op, &[Real, Real]);
    }
    for op in [Op::Minimum(0, 1), Op::Maximum(0, 1), Op::Less(0, 1), Op::LessEqual(0, 1)] {
        exhaust(op, &[Real, Real]);
    }
    for op in [Op::Equal(0, 1), Op::NotEqual(0, 1)] {
        exhaust(op, &[Real, Real]);
    }
    exhaust(Op::MulAdd(0, 1, 2), &[Real, Real, Real]);
    for op in [Op::IntAdd(0, 1), Op::IntSub(0, 1), Op::IntMul(0, 1), Op::IntEqual(0, 1)] {
        exhaust(op, &[Int, Int]);
    }
    for op in [Op::And(0, 1), Op::Or(0, 1), Op::Xor(0, 1)] {
        exhaust(op, &[Int, Int]);
        exhaust(op, &[Mask, Mask]);
    }
    exhaust(Op::IntLess(0, 1), &[Int, Int]);
    exhaust(Op::ToReal(0), &[Int]);
    static NUMBERS: [f32; 5] = [0.5, -0.0, f32::MAX, 1e-45, -1.0];
    for numbers in [&NUMBERS[..], &NUMBERS[..1]] {
        exhaust(Op::Table(Table::new(numbers), 0), &[Int]);
    }
    exhaust(Op::Not(0), &[Int]);
    exhaust(Op::Not(0), &[Mask]);
    for bits in 0..32 {
        for op in [Op::ShiftLeft(0, bits), Op::ShiftRight(0, bits), Op::ShiftRightSigned(0, bits)] {
            exhaust(op, &[Int]);
        }
    }
    exhaust(Op::Select(0, 1, 2), &[Mask, Real, Real]);
    exhaust(Op::Select(0, 1, 2), &[Mask, Int, Int]);
    exhaust(Op::Select(0, 1, 2), &[Mask, Mask, Mask]);
}

/// A select leaves the bits of a NaN alone, whichever comparison its mask comes from.
#[test]
fn select_keeps_the_payload_of_a_nan() {
    if !available() {
        return;
    }
    let nan = 0x7fa1_2345;
    for compare in [Op::Less(0, 1), Op::IntLess(0, 1), Op::Xor(0, 1)] {
        let segment = OpSegment {
            ops: vec![
                Op::Load(0),
                Op::Load(1),
                compare,
                Op::Constant(nan),
                Op::Select(2, 3, 0),
                Op::Select(2, 1, 3),
            ],
            sources: vec![Source::Slot(0), Source::Uniform(0)],
            stores: vec![(1, 4), (2, 5)],
            wanted: vec![],
        };
        let mut file = File::new(1, 3, 1);
        file.lanes[0] = Lanes([u32::MAX; LANES]);
        *file.slot(0, 0) = Lanes([0, 0, u32::MAX, 0, u32::MAX, 0, 0, u32::MAX]);
        if compare != Op::Xor(0, 1) {
            file.lanes[0] = Lanes([1.0f32.to_bits(); LANES]);
            *file.slot(0, 0) = Lanes([0, 0, 0x4000_0000, 0, 0x4000_0000, 0, 0, 0x4000_0000]);
        }
        let mut expected = file.clone();
        expected.interpret(&segment);
        run(std::slice::from_ref(&segment), &mut file);
        file.assert_same(&expected, 3, |_| Kind::Int, &segment.to_string());
        assert!(file.slot(0, 1).0.contains(&nan) && file.slot(0, 2).0.contains(&nan));
    }
}

#[test]
fn random_segments_whole_folded_and_split() {
    if !available() {
        return;
    }
    for seed in 0..60 {
        let mut random = Random(seed);
        let size = [12, 40, 90, 200][seed as usize % 4];
        let case = Case::new(&mut random, size);
        let blocks = 1 + seed as usize % 33;
        let limit = 5 + random.below(60);
        let folded = dead::remove(&fold::fold(&case.segment));
        let cut = split::split(&folded, limit, case.slots.len() as u32);
        let file = case.file(&mut random, cut.scratch, blocks);
        let mut expected = file.clone();
        expected.interpret(&case.segment);
        let slots = case.slots.len() as u32;
        let kind = |slot: u32| case.slots[slot as usize];
        let what = |form: &str, segment: &OpSegment| format!("seed {seed}, {form}\n{segment}");
        let forms =
            [("whole", vec![case.segment.clone()]), ("folded", vec![folded]), ("split", cut.parts)];
        for (form, segments) in forms {
            let mut file = file.clone();
            run(&segments, &mut file);
            file.assert_same(&expected, slots, kind, &what(form, &case.segment));
        }
    }
}

/// Above the limit for the ordinary register allocator.
#[test]
fn a_huge_segment_is_allocated_in_a_single_pass() {
    if !available() {
        return;
    }
    let mut random = Random(7);
    let case = Case::new(&mut random, 2500);
    let file = case.file(&mut random, 0, 2);
    let (mut expected, mut file) = (file.clone(), file);
    expected.interpret(&case.segment);
    run(std::slice::from_ref(&case.segment), &mut file);
    let kind = |slot: u32| case.slots[slot as usize];
    file.assert_same(&expected, case.slots.len() as u32, kind, "huge");
}

/// Reading and writing one slot reads first.
#[test]
fn a_slot_read_and_written_is_read_first() {
    if !available() {
        return;
    }
    let segment = OpSegment {
        ops: vec![Op::Load(0), Op::Load(1)],
        sources: vec![Source::Slot(0), Source::Slot(1)],
        stores: vec![(1, 0), (0, 1)],
        wanted: vec![],
    };
    for blocks in [1, 2, 5] {
        let mut file = File::new(0, 2, blocks);
        for block in 0..blocks {
            for slot in 0..2 {
                *file.slot(block, slot) = Lanes([(block * 2) as u32 + slot; LANES]);
            }
        }
        run(std::slice::from_ref(&segment), &mut file);
        for block in 0..blocks {
            for slot in 0..2 {
                assert_eq!(file.slot(block, slot).0, [(block * 2) as u32 + 1 - slot; LANES]);
            }
        }
    }
}

fn one_store() -> OpSegment {
    OpSegment {
        ops: vec![Op::Load(0)],
        sources: vec![Source::Uniform(0)],
        stores: vec![(0, 0)],
        wanted: vec![],
    }
}

#[test]
fn malformed_segments_are_refused() {
    if !available() {
        return;
    }
    let refused = |segment: OpSegment, uniforms, slots| {
        matches!(
            JitCode::compile(&[one_store(), segment], FileShape { uniforms, slots }),
            Err(JitError::Malformed { segment: 1, .. })
        )
    };
    assert!(!refused(one_store(), 1, 1));
    assert!(refused(OpSegment { sources: vec![Source::Uniform(1)], ..one_store() }, 1, 1));
    assert!(refused(OpSegment { sources: vec![Source::Slot(1)], ..one_store() }, 1, 1));
    assert!(refused(OpSegment { sources: vec![], ..one_store() }, 1, 1));
    assert!(refused(OpSegment { wanted: vec![Source::Uniform(1)], ..one_store() }, 1, 1));
    assert!(refused(OpSegment { wanted: vec![Source::Slot(1)], ..one_store() }, 1, 1));
    assert!(refused(OpSegment { stores: vec![(1, 0)], ..one_store() }, 1, 1));
    assert!(refused(OpSegment { stores: vec![(0, 1)], ..one_store() }, 1, 1));
    assert!(refused(OpSegment { ops: vec![Op::Neg(0)], ..one_store() }, 1, 1));
    assert!(refused(OpSegment { ops: vec![Op::Load(0), Op::Sin(0)], ..one_store() }, 1, 1));
    assert!(refused(OpSegment { ops: vec![Op::Truth(true)], ..one_store() }, 1, 1));
    let huge = JitCode::compile(&[], FileShape { uniforms: 1, slots: 1 << 27 })
        .expect_err("offsets do not fit");
    assert_eq!(huge, JitError::TooLarge { words: 1 << 27 });
}

#[test]
#[should_panic(expected = "cannot hold 2 blocks")]
fn a_short_file_is_refused() {
    if !available() {
        panic!("cannot hold 2 blocks: there is no code here");
    }
    let code =
        JitCode::compile(&[one_store()], FileShape { uniforms: 1, slots: 1 }).expect("compiles");
    code.run(0, &mut [Lanes::default(); 2], 2);
}

#[test]
fn no_block_is_touched_when_there_is_none() {
    if !available() {
        return;
    }
    let code =
        JitCode::compile(&[one_store()], FileShape { uniforms: 1, slots: 1 }).expect("compiles");
    let before = [Lanes([1; LANES]), Lanes([2; LANES])];
    let mut lanes = before;
    code.run(0, &mut lanes, 0);
    assert_eq!(lanes, before);
}

/// Code is shared between threads and freed with its last owner; its memory is given back.
#[cfg(target_os = "linux")]
#[test]
fn code_is_shared_and_freed() {
    if !available() {
        return;
    }
    let case = Case::new(&mut Random(3), 400);
    let compile = || {
        let slots = case.slots.len();
        Arc::new(
            JitCode::compile(
                std::slice::from_ref(&case.segment),
                FileShape { uniforms: case.uniforms.len(), slots },
            )
            .expect("compiles"),
        )
    };
    let code = compile();
    assert!(code.code_bytes() > 400);
    let file = case.file(&mut Random(4), 0, 3);
    let mut expected = file.clone();
    expected.interpret(&case.segment);
    std::thread::scope(|scope| {
        for _ in 0..3 {
            let (code, mut file, expected, case) = (code.clone(), file.clone(), &expected, &case);
            scope.spawn(move || {
                code.run(0, &mut file.lanes, file.blocks);
                let kind = |slot: u32| case.slots[slot as usize];
                file.assert_same(expected, case.slots.len() as u32, kind, "threads");
            });
        }
    });
    drop(code);
    let executable = || {
        let maps = std::fs::read_to_string("/proc/self/maps").expect("Linux has it");
        maps.lines().filter(|line| line.contains("r-xp") && line.ends_with(" 0 ")).count()
            + maps.lines().filter(|line| line.contains("r-xp") && !line.contains('/')).count()
    };
    let before = executable();
    for _ in 0..50 {
        drop(compile());
    }
    // Other tests of this process come and go meanwhile; a leak would leave 50.
    assert!(executable() < before + 25, "code memory leaks");
}
