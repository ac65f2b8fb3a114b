//! What each case records, interpreted operation by operation.

use phenomenon_compiler::ops::{Op, Tape, interpret};

use crate::back_ends::Rows;
use crate::cases::Case;

/// What a case records: operations, of which `Load(n)` is input `n`, and those of its outputs.
pub fn tape(case: &Case) -> (Vec<Op>, Vec<u32>) {
    tape_of(case, Tape::new())
}

/// What it records on this tape.
pub fn tape_of(case: &Case, tape: Tape) -> (Vec<Op>, Vec<u32>) {
    let inputs: Vec<u32> = (0..case.inputs.len() as u32).map(|i| tape.push(Op::Load(i))).collect();
    let mut outputs = vec![0; case.outputs.len()];
    case.code.record_anew(&tape, &inputs, &mut outputs);
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
            let load = |source: u32| inputs.row(row)[source as usize];
            values[at] = interpret::evaluate(op, load, |id| values[id as usize]);
        }
        let results: Vec<u32> = outputs.iter().map(|&id| values[id as usize]).collect();
        rows.push(&results);
    }
    rows
}
