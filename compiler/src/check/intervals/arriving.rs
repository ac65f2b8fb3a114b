//! What arrives at a node.

use crate::emit::interval::Word;
use crate::nodes::{Definition, Overload};
use crate::values::Type;

use super::given::is_alpha;
use super::value::Value;

/// A type of a signature as an overload has it.
pub fn of_overload(value_type: Type, overload: &Overload) -> Type {
    match (value_type, overload.generic) {
        (Type::Generic, Some(generic)) => generic,
        (other, _) => other,
    }
}

/// The type of an input as an overload has it.
pub fn settled(definition: &Definition, overload: usize, input: usize) -> Type {
    of_overload(definition.signature.inputs[input].value_type, &definition.overloads[overload])
}

/// What arrives at a node.
pub struct Arriving {
    pub words: Vec<Value>,
    /// The sets of the words, numbered.
    pub sets: Vec<Word>,
    /// First word of each input, and after them the count of words.
    pub first: Vec<usize>,
    /// Whether each input is given: a default is no choice of the author.
    pub given: Vec<bool>,
    /// Whether each input is never demanded.
    pub never: Vec<bool>,
}

/// How inputs lie to their declared ranges.
#[derive(Clone, Copy, PartialEq)]
pub enum Fit {
    /// All that arrives is in range.
    Within,
    /// What was given may be all that is in range.
    AsWide,
}

impl Arriving {
    /// Of a node with so many inputs, none of which has arrived yet.
    pub fn new(inputs: usize) -> Self {
        let mut first = Vec::with_capacity(inputs + 1);
        first.push(0);
        Self {
            words: Vec::new(),
            sets: Vec::new(),
            first,
            given: vec![false; inputs],
            never: vec![false; inputs],
        }
    }

    /// The words of an input.
    pub fn of(&self, input: usize) -> &[Value] {
        &self.words[self.first[input]..self.first[input + 1]]
    }

    /// Numbers the words, so that what a body makes of them tells which it reads.
    pub fn number(&mut self) {
        let words = self.words.iter().enumerate();
        self.sets = words.map(|(at, value)| value.word.read_from(1 << at.min(63))).collect();
    }

    /// The sources of the words among `reads`.
    pub fn sources(&self, reads: u64) -> u64 {
        let words = self.words.iter().enumerate();
        words
            .filter(|(at, _)| reads >> at.min(&63) & 1 != 0)
            .fold(0, |sources, (_, value)| sources | value.sources)
    }

    /// What bodies take as plain numbers, each with its word; none unless all of it is known, and in
    /// range: only then can a body be run.
    pub fn fixed(&self, definition: &Definition) -> Option<Vec<(usize, i32)>> {
        let inputs = definition.signature.inputs.iter().enumerate();
        let fixed = inputs.filter(|(_, input)| input.fixed);
        fixed
            .map(|(at, input)| match self.of(at) {
                [Value { word: Word::Integer(whole), .. }]
                    if whole.low == whole.high && input.range.contains(&f64::from(whole.low)) =>
                {
                    Some((self.first[at], whole.low))
                }
                _ => None,
            })
            .collect()
    }

    /// Whether all inputs lie so to their declared ranges.
    pub fn fits(&self, definition: &Definition, overload: &Overload, fit: Fit) -> bool {
        definition.signature.inputs.iter().enumerate().all(|(at, input)| {
            let value_type = of_overload(input.value_type, overload);
            let (low, high) = (*input.range.start() as f32, *input.range.end() as f32);
            let looked_at = match fit {
                Fit::Within => !self.never[at],
                Fit::AsWide => self.given[at] && !self.never[at],
            };
            !looked_at
                || self.of(at).iter().enumerate().all(|(component, value)| {
                    is_alpha(value_type, component)
                        || match (value.word, fit) {
                            (Word::Truth(_), Fit::Within) => true,
                            (Word::Truth(truth), Fit::AsWide) => truth.decided().is_none(),
                            (Word::Number(number), Fit::Within) => number.is_within(low, high),
                            (Word::Number(number), Fit::AsWide) => {
                                number.low <= low && high <= number.high
                            }
                            (Word::Integer(whole), Fit::Within) => {
                                low <= whole.low as f32 && whole.high as f32 <= high
                            }
                            (Word::Integer(whole), Fit::AsWide) => {
                                whole.low as f32 <= low && high <= whole.high as f32
                            }
                        }
                })
        })
    }
}
