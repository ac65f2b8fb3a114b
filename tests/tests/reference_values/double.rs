//! A graph in 64 bits: the operations its nodes recorded, over `f64` and the functions of the standard library.
//! Truth is 1 or 0, integers are whole.

use std::collections::BTreeMap;

use phenomenon_compiler::graph::{Binding, Graph};
use phenomenon_compiler::nodes::{DefaultValue, Kind, Overload};
use phenomenon_compiler::ops::{Op, OpId};
use phenomenon_compiler::state::{Field, State};
use phenomenon_compiler::values::{Literal, Type};

/// Fields of the state that are set; others are those of the default state.
pub type Fields = BTreeMap<Field, Vec<f64>>;

/// Colour and truth of the root.
///
/// # Panics
/// If there are nodes other than those with a body and `state`, or a loop.
pub fn evaluate(graph: &Graph, fields: &Fields) -> (Vec<f64>, bool) {
    let mut outputs: Vec<Vec<Vec<f64>>> = Vec::new();
    for node in &graph.nodes {
        let definition = graph.library.definition(node.node_type);
        let signature = &definition.signature;
        if let Kind::Fields(of) = &signature.kind {
            outputs.push(of.iter().map(|&of| field(of, fields)).collect());
            continue;
        }
        assert_eq!(signature.kind, Kind::Plain, "{} has no body", signature.name);
        let overload = &definition.overloads[node.overload];
        let mut words = Vec::new();
        for (input, binding) in signature.inputs.iter().zip(&node.inputs) {
            let value_type = settled(input.value_type, overload);
            let given = match binding {
                Binding::Default => default(&input.default, value_type, fields),
                binding => bound(binding, &outputs),
            };
            words.extend(converted(given, value_type));
        }
        let all = run(&definition.fixed_words(overload).collect::<Vec<_>>(), overload, &words);
        let mut rest = all.as_slice();
        let mut of_node = Vec::new();
        for output in &signature.outputs {
            let (own, others) = rest.split_at(settled(output.value_type, overload).width());
            of_node.push(own.to_vec());
            rest = others;
        }
        outputs.push(of_node);
    }
    let root = &graph.roots[0];
    let ok = match &root.ok {
        Binding::Default => true,
        binding => bound(binding, &outputs)[0] != 0.0,
    };
    (converted(bound(&root.color, &outputs), Type::Color), ok)
}

fn settled(value_type: Type, overload: &Overload) -> Type {
    if value_type == Type::Generic {
        overload.generic.expect("a form for a type")
    } else {
        value_type
    }
}

fn bound(binding: &Binding, outputs: &[Vec<Vec<f64>>]) -> Vec<f64> {
    match binding {
        Binding::Literal(literal) => literal_numbers(literal),
        Binding::Node { node, output } => outputs[*node][*output].clone(),
        other => panic!("{other:?} has no value here"),
    }
}

fn default(default: &DefaultValue, value_type: Type, fields: &Fields) -> Vec<f64> {
    match default {
        DefaultValue::Literal(literal) => converted(literal_numbers(literal), value_type),
        DefaultValue::State(of) => field(*of, fields),
        // What no case reads: the light of a sample, say.
        _ => vec![0.0; value_type.width()],
    }
}

fn literal_numbers(literal: &Literal) -> Vec<f64> {
    numbers(&literal.words(), literal.value_type())
}

fn numbers(words: &[u32], value_type: Type) -> Vec<f64> {
    let number = |&word: &u32| match value_type {
        Type::Boolean => f64::from(u8::from(word != 0)),
        Type::Integer | Type::String => f64::from(word as i32),
        _ => f64::from(f32::from_bits(word)),
    };
    words.iter().map(number).collect()
}

/// Numbers become greys.
fn converted(mut given: Vec<f64>, value_type: Type) -> Vec<f64> {
    if given.len() == 1 && value_type.width() > 1 {
        given.resize(value_type.width().min(3), given[0]);
        if value_type == Type::Color {
            given.push(1.0);
        }
    }
    given
}

fn field(of: Field, fields: &Fields) -> Vec<f64> {
    fields.get(&of).cloned().unwrap_or_else(|| {
        let mut words = vec![0; of.value_type().width()];
        of.read(&State::default(), &mut words);
        numbers(&words, of.value_type())
    })
}

/// The output words of a body.
fn run(fixed: &[(usize, usize)], overload: &Overload, words: &[f64]) -> Vec<f64> {
    let code = overload.code.expect("the node has a body");
    let fixed: Vec<(usize, i32)> =
        fixed.iter().map(|&(_, word)| (word, words[word] as i32)).collect();
    let code = code.with_fixed(&fixed);
    let recorded = code.recorded();
    let mut values: Vec<f64> = Vec::with_capacity(recorded.ops.len());
    for &op in &recorded.ops {
        values.push(one(op, words, &|id: OpId| values[id as usize]));
    }
    recorded.outputs.iter().map(|&id| values[id as usize]).collect()
}

fn one(op: Op, words: &[f64], x: &dyn Fn(OpId) -> f64) -> f64 {
    let truth = |holds: bool| f64::from(u8::from(holds));
    let int = |id| x(id) as i64 as i32;
    let whole = |value: i32| f64::from(value);
    match op {
        Op::Load(word) => words[word as usize],
        Op::Constant(bits) => panic!("{bits:x} may mean anything"),
        Op::Number(number) => number.value(),
        Op::Integer(value) => whole(value),
        Op::Truth(value) => truth(value),
        Op::Table(table, index) => f64::from(table.at(int(index))),
        Op::Add(a, b) => x(a) + x(b),
        Op::Sub(a, b) => x(a) - x(b),
        Op::Mul(a, b) => x(a) * x(b),
        Op::Div(a, b) => x(a) / x(b),
        Op::Neg(a) => -x(a),
        Op::MulAdd(a, b, c) => x(a).mul_add(x(b), x(c)),
        Op::Minimum(a, b) => {
            if x(a) < x(b) {
                x(a)
            } else {
                x(b)
            }
        }
        Op::Maximum(a, b) => {
            if x(b) < x(a) {
                x(a)
            } else {
                x(b)
            }
        }
        Op::Absolute(a) => x(a).abs(),
        Op::Sqrt(a) => x(a).sqrt(),
        Op::Floor(a) => x(a).floor(),
        Op::Ceil(a) => x(a).ceil(),
        Op::Truncate(a) => x(a).trunc(),
        Op::RoundEven(a) => x(a).round_ties_even(),
        Op::Less(a, b) | Op::IntLess(a, b) => truth(x(a) < x(b)),
        Op::LessEqual(a, b) => truth(x(a) <= x(b)),
        Op::Equal(a, b) | Op::IntEqual(a, b) => truth(x(a) == x(b)),
        Op::NotEqual(a, b) => truth(x(a) != x(b)),
        Op::ToInt(a) => whole(x(a) as i32),
        Op::ToReal(a) => x(a),
        Op::IntAdd(a, b) => whole(int(a).wrapping_add(int(b))),
        Op::IntSub(a, b) => whole(int(a).wrapping_sub(int(b))),
        Op::IntMul(a, b) => whole(int(a).wrapping_mul(int(b))),
        Op::And(a, b) => whole(int(a) & int(b)),
        Op::Or(a, b) => whole(int(a) | int(b)),
        Op::Xor(a, b) => whole(int(a) ^ int(b)),
        // Of truth, which alone is negated by bodies.
        Op::Not(a) => truth(x(a) == 0.0),
        Op::ShiftLeft(a, bits) => whole(int(a) << bits),
        Op::ShiftRight(a, bits) => whole((int(a) as u32 >> bits) as i32),
        Op::ShiftRightSigned(a, bits) => whole(int(a) >> bits),
        Op::Select(mask, a, b) => {
            if x(mask) == 0.0 {
                x(b)
            } else {
                x(a)
            }
        }
        Op::Sin(a) => x(a).sin(),
        Op::Cos(a) => x(a).cos(),
        Op::Tan(a) => x(a).tan(),
        Op::Asin(a) => x(a).asin(),
        Op::Acos(a) => x(a).acos(),
        Op::Atan(a) => x(a).atan(),
        Op::Atan2(a, b) => x(a).atan2(x(b)),
        Op::Exp(a) => x(a).exp(),
        Op::Exp2(a) => x(a).exp2(),
        Op::Expm1(a) => x(a).exp_m1(),
        Op::Sinh(a) => x(a).sinh(),
        Op::Cosh(a) => x(a).cosh(),
        Op::Tanh(a) => x(a).tanh(),
        Op::Ln(a) => x(a).ln(),
        Op::Log2(a) => x(a).log2(),
        Op::Log1p(a) => x(a).ln_1p(),
        Op::Pow(a, b) => x(a).powf(x(b)),
    }
}
