//! Legalising gives what a tape of the standard tier records at once, and leaves no function.

use phenomenon_compiler::kernels::BodyForms;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::ops::{Op, OpSegment, Tape, fold, legalise};

fn recorded(code: &BodyForms, inputs: u32, tape: Tape) -> OpSegment {
    let loads: Vec<u32> = (0..inputs).map(|n| tape.push(Op::Load(n))).collect();
    let mut outputs = vec![0; code.outputs()];
    code.record_anew(&tape, &loads, &mut outputs);
    OpSegment { ops: tape.into_ops(), stores: (0..).zip(outputs).collect(), ..OpSegment::default() }
}

/// What the jit records of a body.
fn folded(code: &BodyForms, inputs: u32) -> OpSegment {
    let tape = Tape::new();
    let loads: Vec<u32> = (0..inputs).map(|n| tape.push(Op::Load(n))).collect();
    let mut outputs = vec![0; code.outputs()];
    code.record(&tape, &loads, &mut outputs, &mut Vec::new());
    OpSegment { ops: tape.into_ops(), stores: (0..).zip(outputs).collect(), ..OpSegment::default() }
}

#[test]
fn bodies_are_the_same_operations_expanded_at_once_and_afterwards() {
    let library = NodeLibrary::standard();
    let (mut bodies, mut functions) = (0, 0);
    for definition in library.iter().flat_map(|(_, definition)| definition.settled()) {
        let words = 16 * definition.signature.inputs.len() as u32;
        for overload in &definition.overloads {
            for code in overload.guards.iter().flatten().chain(&overload.code) {
                let plain = recorded(code, words, Tape::new());
                let legal = recorded(code, words, Tape::standard());
                assert_eq!(legalise::legalise(&plain), legal, "{}", definition.signature.name);
                let name = &definition.signature.name;
                assert_eq!(folded(code, words), fold::fold(&legal), "{name}");
                assert_eq!(legalise::legalise(&legal), legal, "{}", definition.signature.name);
                assert!(legal.ops.iter().all(|op| !op.is_function()), "{legal}");
                bodies += 1;
                functions += plain.ops.iter().filter(|op| op.is_function()).count();
            }
        }
    }
    assert!(bodies > 100 && functions > 10, "{bodies} bodies, {functions} functions");
}

#[test]
fn constants_are_rounded_and_lose_their_type() {
    let tape = Tape::new();
    let number = |value| tape.push(Op::Number(phenomenon_compiler::ops::Number::new(value)));
    let ids = [
        number(0.1),
        number(f64::from(0.1_f32)),
        number(0.0),
        tape.push(Op::Integer(0)),
        tape.push(Op::Truth(false)),
        tape.push(Op::Truth(true)),
    ];
    assert_eq!(ids, [0, 1, 2, 3, 4, 5], "on the tape they differ");
    let stores = (0..).zip(ids).collect();
    let segment = OpSegment { ops: tape.into_ops(), stores, ..OpSegment::default() };
    let text = legalise::legalise(&segment).to_string();
    let expected = "\
%0 = constant 0x1.99999ap-4 (0.1)
%1 = constant 0
%2 = constant all
store slot 0, %0
store slot 1, %0
store slot 2, %1
store slot 3, %1
store slot 4, %1
store slot 5, %2
";
    assert_eq!(text, expected);
    let plain =
        "%0 = number 0.1\n%1 = number 0.10000000149011612\n%2 = number 0.0\n%3 = integer 0\n";
    assert!(segment.to_string().starts_with(plain), "{segment}");
}
