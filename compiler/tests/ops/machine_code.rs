//! Machine code against the interpreter, bit for bit.

use std::sync::Arc;

use phenomenon_compiler::emit::Table;
use phenomenon_compiler::engine::jit::{Generator, JitCode, JitError};
use phenomenon_compiler::ops::{Op, OpSegment, dead, fold, split};
use phenomenon_compiler::storage::{FileShape, LANES, Lanes, Source};
use phenomenon_compiler::testing::random::Random;

use crate::random::Case;
use crate::samples::{File, Kind, yields};

/// Who makes code here: each generator there is on this machine, ours with few registers as well. A machine
/// without any has nothing to test here, and must say why.
pub fn makers() -> Vec<Maker> {
    let mut makers = Vec::new();
    for generator in Generator::ALL {
        match generator.available() {
            Ok(()) => makers.push(Maker::Generator(generator)),
            Err(JitError::UnsupportedTarget | JitError::MissingFeature { .. }) => {}
            Err(other) => panic!("{other}"),
        }
    }
    #[cfg(target_arch = "x86_64")]
    if Generator::Native.available().is_ok() {
        makers.extend([5, 8].map(Maker::Registers));
    }
    makers
}

#[derive(Clone, Copy, Debug)]
pub enum Maker {
    Generator(Generator),
    /// Ours, in so many registers.
    #[cfg(target_arch = "x86_64")]
    Registers(u32),
}

impl Maker {
    fn compile(self, segments: &[OpSegment], shape: FileShape) -> Result<JitCode, JitError> {
        match self {
            Maker::Generator(generator) => JitCode::compile(generator, segments, shape),
            #[cfg(target_arch = "x86_64")]
            Maker::Registers(count) => JitCode::compile_with_registers(count, segments, shape),
        }
    }

    /// Runs segments as machine code.
    pub fn run(self, segments: &[OpSegment], file: &mut File) {
        let shape = FileShape { uniforms: file.uniforms, slots: file.slots };
        let code = self.compile(segments, shape).expect("compiles");
        code.run(0..segments.len(), &mut file.lanes, 0..file.blocks);
    }
}

/// Asserts that every maker's code for `segments` leaves in `file` what interpreting `segment` does.
fn agree(
    segment: &OpSegment,
    segments: &[OpSegment],
    file: &File,
    slots: u32,
    kind: impl Fn(u32) -> Kind,
    what: &str,
) {
    let mut expected = file.clone();
    expected.interpret(segment);
    for maker in makers() {
        let mut file = file.clone();
        maker.run(segments, &mut file);
        file.assert_same(&expected, slots, &kind, &format!("{maker:?}, {what}\n{segment}"));
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
    let compared = |slot| if slot == arity as u32 { kind } else { Kind::Int };
    agree(&segment, std::slice::from_ref(&segment), &file, arity as u32 + 1, compared, "alone");
}

#[test]
fn every_operation_over_all_hard_operands() {
    use Kind::{Int, Mask, Real};
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
        agree(&segment, std::slice::from_ref(&segment), &file, 3, |_| Kind::Int, "payload");
        file.interpret(&segment);
        assert!(file.slot(0, 1).0.contains(&nan) && file.slot(0, 2).0.contains(&nan));
    }
}

#[test]
fn random_segments_whole_folded_and_split() {
    for seed in 0..60 {
        let mut random = Random::new(seed);
        let size = [12, 40, 90, 200][seed as usize % 4];
        let case = Case::new(&mut random, size);
        let blocks = 1 + seed as usize % 33;
        let limit = 5 + random.below(60);
        let folded = dead::remove(&fold::fold(&case.segment));
        let cut = split::split(&folded, limit, case.slots.len() as u32);
        let file = case.file(&mut random, cut.scratch, blocks);
        let slots = case.slots.len() as u32;
        let kind = |slot: u32| case.slots[slot as usize];
        let forms =
            [("whole", vec![case.segment.clone()]), ("folded", vec![folded]), ("split", cut.parts)];
        for (form, segments) in forms {
            let what = format!("seed {seed}, {form}");
            agree(&case.segment, &segments, &file, slots, kind, &what);
        }
    }
}

/// Above the limit for the ordinary register allocator.
#[test]
fn a_huge_segment_is_allocated_in_a_single_pass() {
    let mut random = Random::new(7);
    let case = Case::new(&mut random, 2500);
    let file = case.file(&mut random, 0, 2);
    let kind = |slot: u32| case.slots[slot as usize];
    let slots = case.slots.len() as u32;
    agree(&case.segment, std::slice::from_ref(&case.segment), &file, slots, kind, "huge");
}

/// A segment that reads slots and stores to the same ones reads first: words only fetched, computed ones, all of
/// them at once, and with every register taken in between.
#[test]
fn a_slot_read_and_written_is_read_first() {
    let load = |count: u32| (0..count).map(Op::Load).collect::<Vec<_>>();
    let slots = |count: u32| (0..count).map(Source::Slot).collect::<Vec<_>>();
    let swap = OpSegment {
        ops: load(2),
        sources: slots(2),
        stores: vec![(1, 0), (0, 1)],
        ..OpSegment::default()
    };
    // What is computed from slot 0 goes there, and slot 0 is used after.
    let computed = OpSegment {
        ops: [load(2), vec![Op::IntAdd(0, 1), Op::IntSub(0, 2), Op::IntMul(3, 2)]].concat(),
        sources: slots(2),
        stores: vec![(0, 2), (2, 4), (1, 3)],
        wanted: vec![],
    };
    // Every slot moves on by one, and more of them than there are registers.
    let count = 40;
    let turn = OpSegment {
        ops: load(count),
        sources: slots(count),
        stores: (0..count).map(|slot| ((slot + 1) % count, slot)).collect(),
        wanted: vec![],
    };
    // The same, each with one added, computed before any is stored.
    let sums = (0..count).map(|slot| Op::IntAdd(slot, (slot + 7) % count));
    let turn_of_sums = OpSegment {
        ops: load(count).into_iter().chain(sums).collect(),
        sources: slots(count),
        stores: (0..count).map(|slot| ((slot + 1) % count, count + slot)).collect(),
        wanted: vec![],
    };
    // One slot twice: what is stored last stays.
    let twice = OpSegment {
        ops: [load(2), vec![Op::IntAdd(0, 1), Op::IntSub(0, 1)]].concat(),
        sources: slots(2),
        stores: vec![(2, 3), (2, 2), (3, 0), (3, 3)],
        wanted: vec![],
    };
    for segment in [swap, computed, turn, turn_of_sums, twice] {
        for blocks in [1, 2, 5, 9] {
            let mut file = File::new(1, count as usize, blocks);
            for block in 0..blocks {
                for slot in 0..count {
                    let first = (block as u32 * count + slot) * LANES as u32;
                    *file.slot(block, slot) = Lanes([0, 1, 2, 3, 4, 5, 6, 7].map(|n| first + n));
                }
            }
            let segments = std::slice::from_ref(&segment);
            agree(&segment, segments, &file, count, |_| Kind::Int, "in place");
        }
    }
}

/// A fused multiplication overwrites an operand: whichever dies, is in memory, comes twice, or has a sign.
#[test]
fn fused_multiplications_of_all_shapes() {
    for shape in 0..4 * 4 * 4 * 8 * 4 {
        let operand = |digit: u32| (shape / 4u32.pow(digit)) % 4;
        let signs = shape / 64 % 8;
        // 0 and 1: slots in memory; 2 and 3: computed, in registers.
        let mut ops: Vec<Op> = (0..2).map(Op::Load).collect();
        ops.extend([Op::Add(0, 1), Op::Sub(1, 0)]);
        let mut ids = [operand(0), operand(1), operand(2)];
        for (at, id) in ids.iter_mut().enumerate() {
            if signs >> at & 1 == 1 {
                ops.push(Op::Neg(*id));
                *id = ops.len() as u32 - 1;
            }
        }
        ops.push(Op::MulAdd(ids[0], ids[1], ids[2]));
        let fused = ops.len() as u32 - 1;
        let mut stores = vec![(2, fused)];
        // Who lives on.
        let alive = shape / 512;
        for (at, slot) in [(0, 3), (1, 4)] {
            if alive >> at & 1 == 1 {
                ops.push(Op::Add(fused, 2 + at));
                stores.push((slot, ops.len() as u32 - 1));
            }
        }
        let segment = OpSegment {
            ops,
            sources: vec![Source::Slot(0), Source::Slot(1)],
            stores,
            wanted: vec![],
        };
        let mut file = File::new(0, 5, 1);
        *file.slot(0, 0) =
            Lanes([0.5f32, -1.25, 3.0, -0.0, 1e-3, 7.5, -2.0, 0.1].map(f32::to_bits));
        *file.slot(0, 1) = Lanes([2.0f32, 0.75, -3.5, 1.0, 1e4, -0.5, 9.0, 0.3].map(f32::to_bits));
        agree(&segment, std::slice::from_ref(&segment), &file, 5, |_| Kind::Real, "fused");
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
    for maker in makers() {
        let refused = |segment: OpSegment, uniforms, slots| {
            matches!(
                maker.compile(&[one_store(), segment], FileShape { uniforms, slots }),
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
        let ops = |last: Op| OpSegment {
            ops: vec![Op::Load(0), last],
            stores: vec![(0, 1)],
            ..one_store()
        };
        assert!(!refused(ops(Op::Neg(0)), 1, 1));
        assert!(refused(ops(Op::Sin(0)), 1, 1));
        assert!(refused(ops(Op::Truth(true)), 1, 1));
        let huge = maker
            .compile(&[], FileShape { uniforms: 1, slots: 1 << 27 })
            .expect_err("offsets do not fit");
        assert_eq!(huge, JitError::TooLarge { words: 1 << 27 });
    }
}

#[test]
#[should_panic(expected = "cannot hold 2 blocks")]
fn a_short_file_is_refused() {
    let Some(maker) = makers().first().copied() else {
        panic!("cannot hold 2 blocks: there is no code here");
    };
    let code =
        maker.compile(&[one_store()], FileShape { uniforms: 1, slots: 1 }).expect("compiles");
    code.run(0..1, &mut [Lanes::default(); 2], 0..2);
}

#[test]
fn no_block_is_touched_when_there_is_none() {
    for maker in makers() {
        let shape = FileShape { uniforms: 1, slots: 1 };
        let code = maker.compile(&[one_store()], shape).expect("compiles");
        let before = [Lanes([1; LANES]), Lanes([2; LANES])];
        let mut lanes = before;
        code.run(0..1, &mut lanes, 0..0);
        assert_eq!(lanes, before);
    }
}

/// Code is shared between threads and freed with its last owner; its memory is given back.
#[cfg(target_os = "linux")]
#[test]
fn code_is_shared_and_freed() {
    for maker in makers() {
        let case = Case::new(&mut Random::new(3), 400);
        let compile = || {
            let shape = FileShape { uniforms: case.uniforms.len(), slots: case.slots.len() };
            let code = maker.compile(std::slice::from_ref(&case.segment), shape);
            Arc::new(code.expect("compiles"))
        };
        let code = compile();
        assert!(code.code_bytes() > 400);
        let file = case.file(&mut Random::new(4), 0, 3);
        let mut expected = file.clone();
        expected.interpret(&case.segment);
        std::thread::scope(|scope| {
            for _ in 0..3 {
                let (code, mut file) = (code.clone(), file.clone());
                let (expected, case) = (&expected, &case);
                scope.spawn(move || {
                    code.run(0..1, &mut file.lanes, 0..file.blocks);
                    let kind = |slot: u32| case.slots[slot as usize];
                    file.assert_same(expected, case.slots.len() as u32, kind, "threads");
                });
            }
        });
        drop(code);
        let before = mappings();
        for _ in 0..50 {
            drop(compile());
        }
        // Other tests of this process come and go meanwhile; a leak would leave 50.
        let after = mappings();
        assert!(after.executable < before.executable + 25, "code memory leaks");
        // Of no page that can be executed anything can be written, at any time.
        assert_eq!(before.both + after.both, 0, "memory is writable and executable at once");
    }
}

/// Anonymous pieces of memory of this process that can be executed, and that can be written too.
#[cfg(target_os = "linux")]
struct Mappings {
    executable: usize,
    both: usize,
}

#[cfg(target_os = "linux")]
fn mappings() -> Mappings {
    let maps = std::fs::read_to_string("/proc/self/maps").expect("Linux has it");
    let with = |rights: &str| {
        maps.lines().filter(|line| line.contains(rights) && !line.contains('/')).count()
    };
    Mappings { executable: with(" r-xp ") + with(" --xp "), both: with(" rwxp ") + with(" -wxp ") }
}
