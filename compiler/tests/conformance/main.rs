//! Every back end gives the same bits for every operation and function of `emit`, over hard inputs.
//!
//! A new back end earns the whole suite with one line in `back_ends`, a new operation or
//! function with one line in [`cases::cases`].

mod back_ends;
mod cases;
mod inputs;
mod reference;

use phenomenon_compiler::ops::{OpSegment, Tape, legalise};

use back_ends::{Rows, all};
use cases::{Case, Word, cases};

/// Bits compared: NaN is one class, since its payload may differ.
fn same(word: Word, a: u32, b: u32) -> bool {
    let nan = |bits| word == Word::Real && f32::from_bits(bits).is_nan();
    a == b || (nan(a) && nan(b))
}

fn shown(words: &[Word], bits: &[u32]) -> Vec<String> {
    let show = |(word, &bits): (&Word, &u32)| match word {
        Word::Real => format!("{:e} ({bits:#010x})", f32::from_bits(bits)),
        Word::Int => (bits as i32).to_string(),
        Word::Mask => format!("{bits:#x}"),
    };
    words.iter().zip(bits).map(show).collect()
}

/// Panics with the first row on which two sets of results differ.
fn assert_same(case: &Case, name: &str, inputs: &Rows, expected: &Rows, actual: &Rows) {
    assert_eq!(expected.count(), actual.count(), "{}: rows of {name}", case.name);
    for row in 0..inputs.count() {
        let (e, a) = (expected.row(row), actual.row(row));
        let agree = case.outputs.iter().zip(e).zip(a).all(|((&word, &e), &a)| same(word, e, a));
        assert!(
            agree,
            "{} of {:?}\n expected {:?}\n {name} {:?}",
            case.name,
            shown(case.inputs, inputs.row(row)),
            shown(case.outputs, e),
            shown(case.outputs, a),
        );
    }
}

#[test]
fn every_back_end_gives_the_bits_of_the_definition() {
    for case in cases() {
        let inputs = inputs::rows(case.inputs);
        let expected = reference::run(&case, &inputs);
        for (name, run) in all() {
            assert_same(&case, name, &inputs, &expected, &run(&case, &inputs));
        }
    }
}

#[test]
fn the_recorder_records_the_operation_itself() {
    // The reference interprets tapes, so a tape must hold what the case is named after.
    for case in cases().iter().filter(|case| case.primitive) {
        let operation = reference::recorded(case);
        assert_eq!(operation, vec![case.name.to_owned()], "{}", case.name);
    }
}

#[test]
fn every_operation_of_the_table_is_a_case() {
    let cases = cases();
    for operation in phenomenon_compiler::ops::Op::ALL {
        assert!(cases.iter().any(|case| case.name == *operation), "{operation}");
    }
}

#[test]
fn recording_and_then_legalising_records_what_expanding_at_once_does() {
    for case in cases() {
        let (ops, stores) = reference::tape(&case);
        let stores = (0..).zip(stores).collect();
        let segment = OpSegment { ops, stores, ..OpSegment::default() };
        let (ops, stores) = reference::tape_of(&case, Tape::standard());
        let at_once =
            OpSegment { ops, stores: (0..).zip(stores).collect(), ..OpSegment::default() };
        assert_eq!(legalise::legalise(&segment), at_once, "{}", case.name);
    }
}

#[test]
fn a_uniform_input_acts_as_the_same_value_in_every_lane() {
    for case in cases().iter().filter(|case| case.inputs.len() == 2) {
        let all = inputs::rows(case.inputs);
        for row in (0..all.count()).step_by(997) {
            let uniform = all.row(row)[0];
            let mut inputs = Rows::new(2);
            for other in 0..19 {
                inputs.push(&[uniform, all.row((row + other * 31) % all.count())[1]]);
            }
            let expected = reference::run(case, &inputs);
            assert_same(
                case,
                "uniform",
                &inputs,
                &expected,
                &back_ends::with_uniform(case, &inputs),
            );
        }
    }
}

#[test]
fn outputs_may_take_the_slots_of_the_inputs() {
    for case in cases().iter().filter(|case| case.outputs.len() <= case.inputs.len()) {
        let inputs = inputs::rows(case.inputs);
        let expected = reference::run(case, &inputs);
        assert_same(case, "in place", &inputs, &expected, &back_ends::in_place(case, &inputs));
    }
}

#[test]
fn a_source_outside_the_file_is_refused() {
    use phenomenon_compiler::storage::{FileShape, Lanes, Placement, Source};
    let case = &cases()[0];
    for (sources, output) in [
        ([Source::Slot(0), Source::Slot(9)], 0),
        ([Source::Uniform(5), Source::Slot(0)], 0),
        ([Source::Slot(0), Source::Slot(1)], 4),
    ] {
        let outcome = std::panic::catch_unwind(|| {
            let mut file = vec![Lanes::default(); 4];
            let placement = Placement {
                shape: FileShape { uniforms: 0, slots: 2 },
                first: 0,
                blocks: 2,
                sources: &sources,
                output,
            };
            case.code.wide(&mut file, &placement);
        });
        assert!(outcome.is_err(), "{sources:?} {output}");
    }
}
