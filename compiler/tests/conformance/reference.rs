//! What each operation is, in plain Rust over one word: the table of `docs/numerics.md` as code.

use phenomenon_compiler::ops::{Op, Tape};

use crate::back_ends::Rows;
use crate::cases::Case;

/// What a case records: operations, of which `Load(n)` is input `n`, and those of its outputs.
pub fn tape(case: &Case) -> (Vec<Op>, Vec<u32>) {
    let tape = Tape::new();
    let inputs: Vec<u32> = (0..case.inputs.len() as u32).map(|i| tape.push(Op::Load(i))).collect();
    let mut outputs = vec![0; case.outputs.len()];
    (case.code.record)(&tape, &inputs, &mut outputs);
    (tape.into_ops(), outputs)
}

/// Names of the operations a case records, loads aside.
pub fn recorded(case: &Case) -> Vec<String> {
    let name = |op: &Op| format!("{op:?}").split('(').next().unwrap_or_default().to_owned();
    tape(case).0.iter().filter(|op| !matches!(op, Op::Load(_))).map(name).collect()
}

/// Interprets the tape a case records.
pub fn run(case: &Case, inputs: &Rows) -> Rows {
    let (ops, outputs) = tape(case);
    let mut rows = Rows::new(outputs.len());
    let mut values = vec![0; ops.len()];
    for row in 0..inputs.count() {
        for (at, &op) in ops.iter().enumerate() {
            values[at] = evaluate(op, inputs.row(row), &values);
        }
        let results: Vec<u32> = outputs.iter().map(|&id| values[id as usize]).collect();
        rows.push(&results);
    }
    rows
}

fn truth(value: bool) -> u32 {
    if value { u32::MAX } else { 0 }
}

/// One operation. `values` are the results of those before.
fn evaluate(op: Op, inputs: &[u32], values: &[u32]) -> u32 {
    let word = |id: u32| values[id as usize];
    let real = |id: u32| f32::from_bits(word(id));
    let int = |id: u32| word(id) as i32;
    let number = |value: f32| value.to_bits();
    match op {
        Op::Load(source) => inputs[source as usize],
        Op::Constant(bits) => bits,
        Op::Add(a, b) => number(real(a) + real(b)),
        Op::Sub(a, b) => number(real(a) - real(b)),
        Op::Mul(a, b) => number(real(a) * real(b)),
        Op::Div(a, b) => number(real(a) / real(b)),
        Op::Neg(a) => word(a) ^ 0x8000_0000,
        Op::MulAdd(a, b, c) => number(real(a).mul_add(real(b), real(c))),
        Op::Minimum(a, b) => {
            if real(a) < real(b) {
                word(a)
            } else {
                word(b)
            }
        }
        Op::Maximum(a, b) => {
            if real(a) > real(b) {
                word(a)
            } else {
                word(b)
            }
        }
        Op::Absolute(a) => word(a) & 0x7fff_ffff,
        Op::Sqrt(a) => number(real(a).sqrt()),
        Op::Floor(a) => number(real(a).floor()),
        Op::Ceil(a) => number(real(a).ceil()),
        Op::Truncate(a) => number(real(a).trunc()),
        Op::RoundEven(a) => number(real(a).round_ties_even()),
        Op::Less(a, b) => truth(real(a) < real(b)),
        Op::LessEqual(a, b) => truth(real(a) <= real(b)),
        Op::Equal(a, b) => truth(real(a) == real(b)),
        Op::NotEqual(a, b) => truth(real(a) != real(b)),
        Op::ToInt(a) => real(a) as i32 as u32,
        Op::IntAdd(a, b) => int(a).wrapping_add(int(b)) as u32,
        Op::IntSub(a, b) => int(a).wrapping_sub(int(b)) as u32,
        Op::IntMul(a, b) => int(a).wrapping_mul(int(b)) as u32,
        Op::And(a, b) => word(a) & word(b),
        Op::Or(a, b) => word(a) | word(b),
        Op::Xor(a, b) => word(a) ^ word(b),
        Op::Not(a) => !word(a),
        Op::ShiftLeft(a, bits) => word(a) << bits,
        Op::ShiftRight(a, bits) => word(a) >> bits,
        Op::ShiftRightSigned(a, bits) => (int(a) >> bits) as u32,
        Op::IntEqual(a, b) => truth(word(a) == word(b)),
        Op::IntLess(a, b) => truth(int(a) < int(b)),
        Op::ToReal(a) => number(int(a) as f32),
        Op::Select(mask, a, b) => {
            if word(mask) != 0 {
                word(a)
            } else {
                word(b)
            }
        }
    }
}
