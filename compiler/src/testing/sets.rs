//! What a body yields lies in the set its intervals give.

use crate::emit::interval::{Interval, Truth, Whole, Word};
use crate::kernels::BodyForms;
use crate::values::Type;

use super::random::Random;
use super::subjects::Subjects;

/// Boxes tried per body, and points within each.
const BOXES: usize = 1000;
const POINTS: usize = 24;

fn number(random: &mut Random) -> f32 {
    const HARD: [f32; 20] = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        0.5,
        2.0,
        -3.0,
        1e-45,
        -1e-45,
        f32::MIN_POSITIVE,
        0.999_999_94,
        1.000_000_1,
        f32::MAX,
        f32::MIN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        16_777_216.0,
        2_147_483_648.0,
        -2_147_483_648.0,
        262_144.0,
    ];
    match random.below(5) {
        0 => random.pick(&HARD),
        1 => random.unit() * 2.0 - 1.0,
        2 => (random.unit() - 0.5) * 20.0,
        3 => (random.unit() - 0.5) * 10_f32.powf(random.unit() * 80.0 - 42.0),
        _ => {
            let any = f32::from_bits(random.bits() as u32);
            if any.is_nan() { 0.25 } else { any }
        }
    }
}

fn integer(random: &mut Random) -> i32 {
    match random.below(4) {
        0 => random.bits() as i32,
        1 => [0, 1, -1, i32::MIN, i32::MAX, 0x7f80_0000, 23, 127][random.below(8)],
        _ => random.below(9) as i32 - 3,
    }
}

/// A set of numbers, integers or truth.
fn word(random: &mut Random, value_type: Type, identity: u64) -> Word {
    match value_type {
        Type::Boolean => {
            let mut truth = Truth { identity, ..Truth::OPEN };
            match random.below(4) {
                0 => truth.may_fail = false,
                1 => truth.may_hold = false,
                _ => {}
            }
            Word::Truth(truth)
        }
        Type::Integer => {
            let (a, b) = (integer(random), integer(random));
            let b = if random.below(3) == 0 { a } else { b };
            Word::Integer(Whole { low: a.min(b), high: a.max(b), reads: 0, identity })
        }
        _ => {
            let (a, mut b) = (number(random), number(random));
            match random.below(4) {
                0 => b = a,
                1 => b = a + random.unit() * a.abs(),
                _ => {}
            }
            let b = if b.is_nan() { a } else { b };
            let (low, high) = if a.total_cmp(&b).is_le() { (a, b) } else { (b, a) };
            let nan = random.below(12) == 0;
            let smooth = true;
            Word::Number(Interval { low, high, nan, smooth, reads: 0, identity })
        }
    }
}

/// The bits of a value in a set.
fn within(random: &mut Random, word: Word) -> u32 {
    match word {
        Word::Truth(truth) => {
            let holds = truth.decided().unwrap_or_else(|| random.below(2) == 0);
            if holds { u32::MAX } else { 0 }
        }
        Word::Integer(Whole { low, high, .. }) => match random.below(4) {
            0 => low as u32,
            1 => high as u32,
            _ => {
                let count = (i64::from(high) - i64::from(low) + 1) as u64;
                (i64::from(low) + (random.bits() % count) as i64) as u32
            }
        },
        Word::Number(interval) => number_within(random, interval).to_bits(),
    }
}

fn number_within(random: &mut Random, interval: Interval) -> f32 {
    let Interval { low, high, nan, .. } = interval;
    let inside = match random.below(6) {
        0 => low,
        1 => high,
        2 if nan => f32::NAN,
        2 | 3 => number(random),
        // Evenly by bits, which reaches every magnitude.
        4 => {
            let order = |x: f32| {
                let bits = i64::from(x.to_bits() as i32);
                if bits < 0 { i64::from(i32::MIN) - bits - 1 } else { bits }
            };
            let (from, to) = (order(low), order(high));
            let at = from + (random.bits() % (to - from + 1) as u64) as i64;
            let bits = if at < 0 { i64::from(i32::MIN) - at - 1 } else { at };
            f32::from_bits(bits as i32 as u32)
        }
        _ => low + (high - low) * random.unit(),
    };
    let kept = inside.is_nan() && nan || Interval { nan, ..interval }.contains(inside);
    if kept { inside } else { low }
}

/// Runs one body over boxes of inputs of these types.
///
/// # Panics
/// If it yields what is not in the set.
pub fn hold(name: &str, code: &BodyForms, types: &[Type]) {
    hold_knowing(name, code, types, &[]);
}

/// The same where these words are known before shading.
fn hold_knowing(name: &str, code: &BodyForms, types: &[Type], fixed: &[(usize, i32)]) {
    let mut random = Random::new(name.len() as u64);
    for _ in 0..BOXES {
        // Inputs of one identity are one value.
        let names: Vec<u64> = (0..types.len())
            .map(|at| {
                let other = random.below(types.len());
                // What is known before shading is a word of its own.
                let free = |at: usize| fixed.iter().all(|(word, _)| *word != at);
                let same = types[other] == types[at] && free(other) && free(at);
                if random.below(4) == 0 && same { other } else { at }
            })
            .map(|at| at as u64 + 1)
            .collect();
        let first = |name: u64| names.iter().position(|&other| other == name).unwrap();
        let mut inputs: Vec<Word> = Vec::new();
        for (at, value_type) in types.iter().enumerate() {
            let word = match first(names[at]) {
                same if same < at => inputs[same],
                _ => word(&mut random, *value_type, names[at]),
            };
            inputs.push(word);
        }
        for &(word, number) in fixed {
            inputs[word] = Word::Integer(Whole::constant(number));
        }
        let mut sets = vec![Word::UNKNOWN; code.outputs];
        code.intervals(&inputs, &mut sets);
        for _ in 0..POINTS {
            let mut point: Vec<u32> = Vec::new();
            for (at, word) in inputs.iter().enumerate() {
                let same = first(names[at]);
                let own = same == at || fixed.iter().any(|(word, _)| *word == at);
                point.push(if own { within(&mut random, *word) } else { point[same] });
            }
            let mut outputs = vec![0; code.outputs];
            code.scalar(&point, &mut outputs);
            for (output, set) in outputs.iter().zip(&sets) {
                assert!(
                    set.contains(*output),
                    "{name}: {:?} ({output:x}) is not in {set:?}\nat {:?}\nin {inputs:#?}",
                    f32::from_bits(*output),
                    point.iter().map(|&word| f32::from_bits(word)).collect::<Vec<_>>(),
                );
            }
        }
    }
}

/// What a body or a condition yields lies in the set its intervals give.
///
/// # Panics
/// If it does not.
pub fn nodes_stay_in_their_sets(subjects: &Subjects) {
    // The least counts: more of the same takes long.
    let settled = subjects.iter().flat_map(|(_, it)| it.settled().into_iter().take(2));
    for definition in settled {
        for overload in &definition.overloads {
            let mut types: Vec<Type> = Vec::new();
            for input in &definition.signature.inputs {
                let (word, width) = match (input.value_type, overload.generic) {
                    (Type::Generic, Some(generic @ (Type::Integer | Type::Boolean))) => {
                        (generic, 1)
                    }
                    (Type::Generic, Some(generic)) => (Type::Scalar, generic.width()),
                    (Type::Vector | Type::Color, _) => (Type::Scalar, input.value_type.width()),
                    (other, _) => (other, other.width()),
                };
                types.extend(std::iter::repeat_n(word, width));
            }
            for code in overload.guards.iter().flatten().chain(&overload.code) {
                let number = |at: usize| *definition.signature.inputs[at].range.start() as i32;
                let fixed = definition.fixed_words(overload).map(|(at, word)| (word, number(at)));
                let fixed: Vec<_> = fixed.collect();
                hold_knowing(&definition.signature.name, code, &types, &fixed);
            }
        }
    }
}
