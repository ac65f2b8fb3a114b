//! What the tests in files of nodes use: a body evaluated for one point, inputs by name.

use super::{DefaultValue, Definition, Overload};
use crate::state::{Objects, Place};
use crate::values::{Literal, Type};

/// The numbers of an output: `numbers!(a = 1.0, b = 2.0 => result)`. Inputs that are not given have
/// their defaults, over the default place.
#[macro_export]
macro_rules! numbers {
    ($($input:ident = $value:expr),* => $output:ident) => {
        $crate::nodes::harness::numbers(
            &super::definition(),
            &[$((stringify!($input), $crate::values::Literal::from($value))),*],
            stringify!($output),
        )
    };
}

/// The one number of an output; see `numbers!`.
#[macro_export]
macro_rules! number {
    ($($input:ident = $value:expr),* => $output:ident) => {
        $crate::numbers!($($input = $value),* => $output)[0]
    };
}

/// The truth of an output; see `numbers!`.
#[macro_export]
macro_rules! truth {
    ($($input:ident = $value:expr),* => $output:ident) => {
        $crate::number!($($input = $value),* => $output).to_bits() != 0
    };
}

/// Whether an input is demanded; see `numbers!`.
#[macro_export]
macro_rules! demanded {
    ($($input:ident = $value:expr),* => $guarded:ident) => {
        $crate::nodes::harness::demanded(
            &super::definition(),
            &[$((stringify!($input), $crate::values::Literal::from($value))),*],
            stringify!($guarded),
        )
    };
}

/// Words of an output as numbers, the overload chosen by the first generic input given.
///
/// # Panics
/// If the node has no such input or output, or its native and portable forms differ.
pub fn numbers(definition: &Definition, given: &[(&str, Literal)], output: &str) -> Vec<f32> {
    let signature = &definition.signature;
    let overload = overload(definition, given);
    let inputs = words(definition, overload, given);
    let code = overload.code.expect("the node has a body");
    let code = code.with_fixed(&fixed(definition, overload, &inputs));
    let mut outputs = vec![0; code.outputs];
    code.scalar(&inputs, &mut outputs);
    let mut portable = vec![0; code.outputs];
    code.scalar_portable(&inputs, &mut portable);
    assert_eq!(outputs, portable, "native and portable forms differ");
    let at = signature.output(output).expect("the node has this output");
    let width = |at: usize| settled(signature.outputs[at].value_type, overload).width();
    let start: usize = (0..at).map(width).sum();
    outputs[start..start + width(at)].iter().map(|&word| f32::from_bits(word)).collect()
}

/// The numbers that the body of a scope gives the fields it changes, one after another.
///
/// # Panics
/// If the node is no scope or has no such input, or its native and portable forms differ.
pub fn changed(definition: &Definition, given: &[(&str, Literal)]) -> Vec<f32> {
    let overload = &definition.overloads[0];
    let inputs = words(definition, overload, given);
    let code = overload.code.expect("a scope has a body");
    let code = code.with_fixed(&fixed(definition, overload, &inputs));
    let (mut changes, mut portable) = (vec![0; code.outputs], vec![0; code.outputs]);
    code.scalar(&inputs, &mut changes);
    code.scalar_portable(&inputs, &mut portable);
    assert_eq!(changes, portable, "native and portable forms differ");
    changes.into_iter().map(f32::from_bits).collect()
}

/// Whether the guard of an input holds.
///
/// # Panics
/// If the node has no such input, or that has no guard.
pub fn demanded(definition: &Definition, given: &[(&str, Literal)], input: &str) -> bool {
    let overload = overload(definition, given);
    let at = definition.signature.input(input).expect("the node has this input");
    let inputs = words(definition, overload, given);
    let guard = overload.guards[at].expect("the input is guarded");
    let guard = guard.with_fixed(&fixed(definition, overload, &inputs));
    let mut holds = [0];
    guard.scalar(&inputs, &mut holds);
    holds[0] != 0
}

/// Holds that values are within `relative` of what is expected, or within `absolute`.
///
/// # Panics
/// If they are not.
#[track_caller]
pub fn assert_close(values: &[f32], expected: &[f64], relative: f64, absolute: f64) {
    assert_eq!(values.len(), expected.len());
    for (&value, &expected) in values.iter().zip(expected) {
        let error = (f64::from(value) - expected).abs();
        assert!(
            error <= relative * expected.abs() || error <= absolute,
            "{value:e} for {expected:e}, off by {error:e}"
        );
    }
}

/// A division of integers, rounded down, as 64 bits have it.
#[derive(Clone, Copy, Debug)]
pub struct Division {
    /// What is divided.
    pub a: i32,
    /// What it is divided by.
    pub b: i32,
    /// The quotient.
    pub quotient: i32,
    /// What is left.
    pub remainder: i32,
}

/// Divisions of hard integers by each other.
pub fn floored_divisions() -> impl Iterator<Item = Division> {
    let hard = [i32::MIN, i32::MIN + 1, -16_777_217, -3, -1, 1, 2, 3, 10, 4097, 16_777_217];
    let hard = hard.into_iter().chain([i32::MAX - 1, i32::MAX]);
    hard.clone().flat_map(move |a| hard.clone().map(move |b| (a, b))).map(|(a, b)| {
        let (wide, by) = (i64::from(a), i64::from(b));
        let down = wide.div_euclid(by) - i64::from(by < 0 && wide.rem_euclid(by) != 0);
        // Only the least number by -1 does not fit, and wraps.
        Division { a, b, quotient: down as i32, remainder: (wide - down * by) as i32 }
    })
}

/// The type with [`Type::Generic`] replaced.
///
/// # Panics
/// If the overload is not for a type.
pub fn settled(value_type: Type, overload: &Overload) -> Type {
    match value_type {
        Type::Generic => overload.generic.expect("a generic input has a generic overload"),
        known => known,
    }
}

/// What is known before shading, among these input words.
fn fixed(definition: &Definition, overload: &Overload, words: &[u32]) -> Vec<(usize, i32)> {
    definition.fixed_words(overload).map(|(_, word)| (word, words[word] as i32)).collect()
}

fn overload<'a>(definition: &'a Definition, given: &[(&str, Literal)]) -> &'a Overload {
    let signature = &definition.signature;
    let generic = given.iter().find_map(|(name, literal)| {
        let input = &signature.inputs[signature.input(name).expect("the node has this input")];
        (input.value_type == Type::Generic).then(|| literal.value_type())
    });
    definition
        .overloads
        .iter()
        .find(|overload| generic.is_none() || overload.generic == generic)
        .expect("the node takes this type")
}

fn words(definition: &Definition, overload: &Overload, given: &[(&str, Literal)]) -> Vec<u32> {
    let mut words = Vec::new();
    for input in &definition.signature.inputs {
        let value_type = settled(input.value_type, overload);
        let literal = given.iter().find(|(name, _)| input.name == *name).map(|(_, value)| value);
        if let Some(literal) = literal {
            assert_eq!(literal.value_type(), value_type, "type of `{}`", input.name);
            words.extend(literal.words());
            continue;
        }
        match &input.default {
            DefaultValue::Literal(literal) => {
                words.extend(literal.as_default(value_type).expect("a default").words());
            }
            DefaultValue::State(field) => {
                let first = words.len();
                words.resize(first + value_type.width(), 0);
                let place = Place::default();
                Objects::of_place(&place).read(*field, &place.state, &mut words[first..]);
            }
            DefaultValue::Required | DefaultValue::Node(_) => {
                words.extend(std::iter::repeat_n(0, value_type.width()));
            }
        }
    }
    words
}
