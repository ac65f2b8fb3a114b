//! What must fold, what must not, and that folding changes no bit.

use phenomenon_compiler::ops::{Op, OpSegment, dead, fold};
use phenomenon_compiler::storage::Source;
use phenomenon_compiler::testing::random::Random;

use crate::random::Case;

const ZERO: Op = Op::Constant(0);
const MINUS_ZERO: Op = Op::Constant(0x8000_0000);
const ONE: Op = Op::Constant(0x3f80_0000);
const MINUS_ONE: Op = Op::Constant(0xbf80_0000);
const ALL: Op = Op::Constant(u32::MAX);

/// The folded form of operations behind `%0 = x`, `%1 = y`, `%2 = m` (the last is stored), on one
/// line, without the loads: `x`, `y` and `m` stand for them.
fn folded(ops: &[Op]) -> String {
    let mut list = vec![Op::Load(0), Op::Load(1), Op::Load(2)];
    list.extend(ops);
    let stores = vec![(9, list.len() as u32 - 1)];
    let sources = vec![Source::Slot(0), Source::Slot(1), Source::Slot(2)];
    let segment = OpSegment { ops: list, sources, stores, wanted: vec![] };
    let segment = dead::remove(&fold::fold(&segment));
    let name = |id: u32| match segment.ops[id as usize] {
        Op::Load(n) => match segment.sources[n as usize] {
            Source::Slot(slot) => ["x", "y", "m"][slot as usize].to_owned(),
            Source::Uniform(_) | Source::Constant { .. } => unreachable!("there is none"),
        },
        _ => format!("%{id}"),
    };
    let mut text = Vec::new();
    for op in &segment.ops {
        if matches!(op, Op::Load(_)) {
            continue;
        }
        let mut line = op.to_string();
        op.for_each_operand(|id| line = line.replacen(&format!("%{id}"), &name(id), 1));
        text.push(line);
    }
    if text.is_empty() { name(segment.stores[0].1) } else { text.join("; ") }
}

macro_rules! folds {
    ($test:ident: $([$($op:expr),+] => $expected:literal,)+) => {
        #[test]
        fn $test() {
            $(assert_eq!(folded(&[$($op),+]), $expected, "{}", stringify!($($op),+));)+
        }
    };
}

folds! { neutral_operands_fold:
    [ONE, Op::Mul(0, 3)] => "x",
    [ONE, Op::Mul(3, 0)] => "x",
    [ONE, Op::Div(0, 3)] => "x",
    [MINUS_ZERO, Op::Add(0, 3)] => "x",
    [MINUS_ZERO, Op::Add(3, 0)] => "x",
    [ZERO, Op::Sub(0, 3)] => "x",
    [MINUS_ZERO, Op::Sub(3, 0)] => "neg x",
    [MINUS_ONE, Op::Mul(0, 3)] => "neg x",
    [MINUS_ONE, Op::Div(0, 3)] => "neg x",
    [ONE, Op::MulAdd(0, 3, 1)] => "add x, y",
    [MINUS_ZERO, Op::MulAdd(0, 1, 3)] => "mul x, y",
    [Op::Minimum(0, 0)] => "x",
    [Op::Maximum(0, 0)] => "x",
    [Op::Select(2, 0, 0)] => "x",
}

folds! { signs_fold:
    [Op::Neg(0), Op::Neg(3)] => "x",
    [Op::Neg(1), Op::Add(0, 3)] => "sub x, y",
    [Op::Neg(0), Op::Add(3, 1)] => "sub y, x",
    [Op::Neg(1), Op::Sub(0, 3)] => "add x, y",
    [Op::Neg(0), Op::Neg(1), Op::Mul(3, 4)] => "mul x, y",
    [Op::Neg(0), Op::Absolute(3)] => "absolute x",
    [Op::Absolute(0), Op::Absolute(3)] => "absolute x",
    [Op::Floor(0), Op::Ceil(3)] => "floor x",
    [Op::ToReal(0), Op::RoundEven(3)] => "to_real x",
    [Op::Constant(0x4080_0000), Op::Div(0, 3)] => "constant 0x1.0p-2 (0.25); mul x, %1",
}

folds! { masks_and_integers_fold:
    [ALL, Op::Select(3, 0, 1)] => "x",
    [ZERO, Op::Select(3, 0, 1)] => "y",
    [ALL, ZERO, Op::Select(2, 3, 4)] => "m",
    [ALL, ZERO, Op::Select(2, 4, 3)] => "not m",
    [Op::Not(2), Op::Select(3, 0, 1)] => "select m, y, x",
    [Op::Not(2), Op::Not(3)] => "m",
    [Op::Equal(0, 1), Op::Not(3)] => "not_equal x, y",
    [Op::NotEqual(0, 1), Op::Not(3)] => "equal x, y",
    [ALL, Op::And(2, 3)] => "m",
    [ZERO, Op::And(2, 3)] => "constant 0",
    [ALL, Op::Or(3, 2)] => "constant all",
    [ZERO, Op::Or(3, 2)] => "m",
    [ZERO, Op::Xor(2, 3)] => "m",
    [ALL, Op::Xor(2, 3)] => "not m",
    [Op::And(2, 2)] => "m",
    [Op::Or(2, 2)] => "m",
    [Op::Xor(2, 2)] => "constant 0",
    [Op::Less(0, 0)] => "constant 0",
    [Op::IntSub(0, 0)] => "constant 0",
    [Op::IntEqual(0, 0)] => "constant all",
    [ZERO, Op::IntAdd(0, 3)] => "x",
    [Op::Constant(1), Op::IntMul(0, 3)] => "x",
    [ZERO, Op::IntMul(0, 3)] => "constant 0",
    [Op::ShiftLeft(0, 0)] => "x",
}

folds! { constants_fold:
    [ONE, Op::Add(3, 3)] => "constant 0x1.0p1 (2.0)",
    [ONE, Op::Constant(0x3380_0000), Op::Add(3, 4)] => "constant 0x1.0p0 (1.0)",
    [ZERO, ONE, Op::Div(4, 3)] => "constant inf",
    [MINUS_ONE, Op::ShiftRight(3, 31)] => "constant 0x00000001 (integer 1)",
    [ONE, Op::Less(3, 3)] => "constant 0",
    [Op::Constant(0x4f80_0000), Op::ToInt(3)] => "constant 0x7fffffff (integer 2147483647)",
}

folds! { equal_operations_are_found_whatever_their_order:
    [Op::Add(0, 1), Op::Add(1, 0), Op::Xor(3, 4)] => "constant 0",
    [Op::MulAdd(0, 1, 2), Op::MulAdd(1, 0, 2), Op::Xor(3, 4)] => "constant 0",
    [Op::Sub(0, 1), Op::Sub(1, 0), Op::Xor(3, 4)] => "sub x, y; sub y, x; xor %2, %3",
    [Op::Minimum(0, 1), Op::Minimum(1, 0), Op::Xor(3, 4)] => "minimum x, y; minimum y, x; xor %2, %3",
}

// Each would change -0, an infinity or a NaN.
folds! { what_would_change_bits_stays:
    [ZERO, Op::Add(0, 3)] => "constant 0; add x, %1",
    [MINUS_ZERO, Op::Sub(0, 3)] => "constant -0x0.0p0 (-0); sub x, %1",
    [ZERO, Op::Sub(3, 0)] => "constant 0; sub %1, x",
    [ZERO, Op::Mul(0, 3)] => "constant 0; mul x, %1",
    [ZERO, Op::Div(3, 0)] => "constant 0; div %1, x",
    [ZERO, Op::MulAdd(0, 3, 1)] => "constant 0; mul_add x, %2, y",
    [ZERO, Op::MulAdd(0, 1, 3)] => "constant 0; mul_add x, y, %2",
    [Op::Sub(0, 0)] => "sub x, x",
    [Op::Div(0, 0)] => "div x, x",
    [Op::Equal(0, 0)] => "equal x, x",
    [Op::NotEqual(0, 0)] => "not_equal x, x",
    [Op::LessEqual(0, 0)] => "less_equal x, x",
    [Op::Less(0, 1), Op::Not(3)] => "less x, y; not %2",
    [Op::Sqrt(0), Op::Absolute(3)] => "sqrt x; absolute %1",
    [Op::Constant(0x4040_0000), Op::Div(0, 3)] => "constant 0x1.8p1 (3.0); div x, %1",
    // The reciprocal of 2^127 is subnormal, that of the smallest number infinite.
    [Op::Constant(0x7f00_0000), Op::Div(0, 3)] => "constant 0x1.0p127 (1.7014118e38); div x, %1",
    [Op::Constant(1), Op::Div(0, 3)] => "constant 0x00000001 (integer 1); div x, %1",
    [Op::Mul(0, 1), Op::Div(3, 1)] => "mul x, y; div %2, y",
    [Op::Constant(0x7fc0_0000), Op::Mul(0, 3)] => "constant 0x7fc00000 (integer 2143289344); mul x, %1",
}

#[test]
fn folding_changes_no_bit() {
    for seed in 0..400 {
        let mut random = Random::new(seed);
        let size = 10 + random.below(120);
        let case = Case::new(&mut random, size);
        let mut plain = case.file(&mut random, 0, 2);
        let mut fold_file = plain.clone();
        plain.interpret(&case.segment);
        let folded = dead::remove(&fold::fold(&case.segment));
        assert!(folded.ops.len() <= case.segment.ops.len());
        fold_file.interpret(&folded);
        let what = format!("seed {seed}\n{}\nfolded:\n{folded}", case.segment);
        let kind = |slot: u32| case.slots[slot as usize];
        fold_file.assert_same(&plain, case.slots.len() as u32, kind, &what);
    }
}
