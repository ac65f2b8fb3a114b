//! One form of a node with many inputs, and what its native, portable and recorded forms yield.

use std::ops::RangeInclusive;

use crate::kernels::BodyForms;
use crate::nodes::{Definition, Overload, finite, harness::settled};
use crate::ops::{Op, Tape, interpret};
use crate::storage::{FileShape, LANES, Lanes, Placement, Source};
use crate::values::Type;

use super::random::Random;

/// Points tried per overload; a multiple of the lanes of a block.
const POINTS: usize = 4096;

/// A number of a range, often at its ends or where arithmetic goes wrong; any bits if `anywhere`.
fn number(random: &mut Random, range: &RangeInclusive<f64>, anywhere: bool) -> f32 {
    if anywhere && random.chance(50) {
        return f32::from_bits(random.bits() as u32);
    }
    let (low, high) = (*range.start(), *range.end());
    let value = match random.below(4) {
        0 => low + (high - low).min(f64::MAX) * random.fine_unit(),
        1 => random.pick(&[low, high, 0.0, -0.0, 1.0, -1.0, 0.5, 2.0]),
        2 => f64::from(random.pick(&[1e-45, -1e-45, f32::MIN_POSITIVE, 0.9999999, 1.0000001])),
        // Any magnitude.
        _ => {
            let sign = (random.fine_unit() - 0.5).signum();
            sign * 10_f64.powf(random.fine_unit() * 84.0 - 45.0)
        }
    };
    value.clamp(low, high) as f32
}

/// The words of an input value, in its range unless `anywhere`.
fn words(
    random: &mut Random,
    value_type: Type,
    range: &RangeInclusive<f64>,
    anywhere: bool,
) -> Vec<u32> {
    let mut number = |range| number(random, range, anywhere).to_bits();
    match value_type {
        Type::Boolean => vec![if random.chance(50) { 0 } else { u32::MAX }],
        Type::Integer if anywhere => vec![random.bits() as u32],
        Type::Integer => {
            let (low, high) = (range.start().max(-2e9), range.end().min(2e9));
            vec![(low + (high - low) * random.fine_unit()).round() as i32 as u32]
        }
        Type::Color => [range, range, range, &finite::UNIT].map(number).into(),
        _ => (0..value_type.width()).map(|_| number(range)).collect(),
    }
}

/// One overload of a node, with the inputs of all points.
pub(super) struct Trial {
    pub name: String,
    /// First word and width of each input.
    pub places: Vec<(usize, usize)>,
    pub points: Vec<Vec<u32>>,
}

impl Trial {
    pub fn new(definition: &Definition, overload: &Overload, anywhere: bool) -> Self {
        let signature = &definition.signature;
        let mut random = Random::new(signature.name.len() as u64);
        let mut at = 0;
        let places = (signature.inputs.iter())
            .map(|input| {
                let width = settled(input.value_type, overload).width();
                at += width;
                (at - width, width)
            })
            .collect();
        let points = (0..POINTS)
            .map(|_| {
                (signature.inputs.iter())
                    .flat_map(|input| {
                        let value_type = settled(input.value_type, overload);
                        words(&mut random, value_type, &input.range, anywhere && !input.fixed)
                    })
                    .collect()
            })
            .collect();
        let name = format!("{} over {:?}", signature.name, overload.generic);
        Self { name, places, points }
    }

    /// The outputs of every point by the scalar form, after the other forms agreed.
    pub fn run(&self, code: &BodyForms) -> Vec<Vec<u32>> {
        let scalar = self.points_by(|point, outputs| code.scalar(point, outputs), code.outputs);
        let portable =
            self.points_by(|point, outputs| code.scalar_portable(point, outputs), code.outputs);
        let wide = self.blocks_by(|lanes, placement| code.wide(lanes, placement), code.outputs);
        let wide_portable =
            self.blocks_by(|lanes, placement| code.wide_portable(lanes, placement), code.outputs);
        let recorded = self.recorded(code);
        for (at, expected) in scalar.iter().enumerate() {
            for (form, outputs) in [
                ("scalar_portable", &portable),
                ("wide", &wide),
                ("wide_portable", &wide_portable),
                ("record", &recorded),
            ] {
                assert_eq!(
                    canonical_words(&outputs[at]),
                    canonical_words(expected),
                    "{}: {form} differs from scalar at {:x?}",
                    self.name,
                    self.points[at]
                );
            }
        }
        scalar
    }

    pub fn points_by(&self, form: impl Fn(&[u32], &mut [u32]), outputs: usize) -> Vec<Vec<u32>> {
        let mut all = vec![vec![0; outputs]; POINTS];
        for (point, outputs) in self.points.iter().zip(&mut all) {
            form(point, outputs);
        }
        all
    }

    fn blocks_by(
        &self,
        form: impl Fn(&mut [Lanes], &Placement<'_>),
        outputs: usize,
    ) -> Vec<Vec<u32>> {
        let inputs = self.points[0].len();
        let slots = inputs + outputs;
        let blocks = POINTS / LANES;
        let mut file = vec![Lanes::default(); blocks * slots];
        for (at, point) in self.points.iter().enumerate() {
            for (slot, &word) in point.iter().enumerate() {
                file[at / LANES * slots + slot].0[at % LANES] = word;
            }
        }
        let sources: Vec<Source> = (0..inputs as u32).map(Source::Slot).collect();
        let output = inputs as u32;
        form(
            &mut file,
            &Placement {
                shape: FileShape { uniforms: 0, slots },
                first: 0,
                blocks,
                sources: &sources,
                output,
            },
        );
        let word = |at: usize, k: usize| file[at / LANES * slots + inputs + k].0[at % LANES];
        (0..POINTS).map(|at| (0..outputs).map(|k| word(at, k)).collect()).collect()
    }

    fn recorded(&self, code: &BodyForms) -> Vec<Vec<u32>> {
        let tape = Tape::new();
        let loads: Vec<_> =
            (0..self.points[0].len() as u32).map(|n| tape.push(Op::Load(n))).collect();
        let mut results = vec![0; code.outputs];
        code.record(&tape, &loads, &mut results, &mut Vec::new());
        let ops = tape.into_ops();
        (self.points.iter())
            .map(|point| {
                let mut values: Vec<u32> = Vec::with_capacity(ops.len());
                for &op in &ops {
                    let word =
                        interpret::evaluate(op, |n| point[n as usize], |id| values[id as usize]);
                    values.push(word);
                }
                results.iter().map(|&id| values[id as usize]).collect()
            })
            .collect()
    }
}

/// NaN as one class: its payload differs even between two builds of one source.
pub(super) fn canonical_words(words: &[u32]) -> Vec<u32> {
    let quiet = |word: u32| if f32::from_bits(word).is_nan() { f32::NAN.to_bits() } else { word };
    // All bits set, as truth is stored, is a NaN too: it stays apart.
    words.iter().map(|&word| if word == u32::MAX { word } else { quiet(word) }).collect()
}
