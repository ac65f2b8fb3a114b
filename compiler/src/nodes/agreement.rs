//! Tests over the whole list of nodes: ranges hold, forms agree, undemanded inputs stay hidden.

use std::ops::RangeInclusive;

use super::harness::settled;
use super::{Definition, NodeLibrary, Overload};
use crate::kernels::BodyForms;
use crate::ops::{Op, Tape, interpret};
use crate::storage::{FileShape, LANES, Lanes, Placement, Source};
use crate::values::Type;

/// Points tried per overload; a multiple of the lanes of a block.
const POINTS: usize = 4096;

/// A generator of numbers, the same in every run (Marsaglia's xorshift).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }

    /// From 0 to below 1.
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn number(&mut self, range: &RangeInclusive<f64>, anywhere: bool) -> f32 {
        if anywhere && self.below(2) == 0 {
            return f32::from_bits(self.next() as u32);
        }
        let (low, high) = (*range.start(), *range.end());
        let value = match self.below(4) {
            0 => low + (high - low).min(f64::MAX) * self.unit(),
            1 => [low, high, 0.0, -0.0, 1.0, -1.0, 0.5, 2.0][self.below(8)],
            2 => f64::from([1e-45, -1e-45, f32::MIN_POSITIVE, 0.9999999, 1.0000001][self.below(5)]),
            // Any magnitude.
            _ => (self.unit() - 0.5).signum() * 10_f64.powf(self.unit() * 84.0 - 45.0),
        };
        value.clamp(low, high) as f32
    }

    /// The words of an input value, in its range unless `anywhere`.
    fn words(&mut self, value_type: Type, range: &RangeInclusive<f64>, anywhere: bool) -> Vec<u32> {
        match value_type {
            Type::Boolean => vec![if self.below(2) == 0 { 0 } else { u32::MAX }],
            Type::Integer if anywhere => vec![self.next() as u32],
            Type::Integer => {
                let (low, high) = (range.start().max(-2e9), range.end().min(2e9));
                vec![(low + (high - low) * self.unit()).round() as i32 as u32]
            }
            Type::Color => {
                let mut words: Vec<u32> =
                    (0..3).map(|_| self.number(range, anywhere).to_bits()).collect();
                words.push(self.number(&super::finite::UNIT, anywhere).to_bits());
                words
            }
            _ => (0..value_type.width()).map(|_| self.number(range, anywhere).to_bits()).collect(),
        }
    }
}

/// One overload of a node, with the inputs of all points.
struct Trial {
    name: String,
    /// First word and width of each input.
    places: Vec<(usize, usize)>,
    points: Vec<Vec<u32>>,
}

impl Trial {
    fn new(definition: &Definition, overload: &Overload, anywhere: bool) -> Self {
        let signature = &definition.signature;
        let mut random = Random(0x9e37_79b9_7f4a_7c15 ^ signature.name.len() as u64);
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
                        random.words(value_type, &input.range, anywhere && !input.fixed)
                    })
                    .collect()
            })
            .collect();
        let name = format!("{} over {:?}", signature.name, overload.generic);
        Self { name, places, points }
    }

    /// The outputs of every point by the scalar form, after the other forms agreed.
    fn run(&self, code: &BodyForms) -> Vec<Vec<u32>> {
        let scalar = self.points_by(code.scalar, code.outputs);
        let portable =
            self.points_by(|point, outputs| code.scalar_portable(point, outputs), code.outputs);
        let wide = self.blocks_by(code.wide, code.outputs);
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
                    canonical(&outputs[at]),
                    canonical(expected),
                    "{}: {form} differs from scalar at {:x?}",
                    self.name,
                    self.points[at]
                );
            }
        }
        scalar
    }

    fn points_by(&self, form: impl Fn(&[u32], &mut [u32]), outputs: usize) -> Vec<Vec<u32>> {
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
        code.record(&tape, &loads, &mut results);
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
fn canonical(words: &[u32]) -> Vec<u32> {
    let quiet = |word: u32| if f32::from_bits(word).is_nan() { f32::NAN.to_bits() } else { word };
    // All bits set, as truth is stored, is a NaN too: it stays apart.
    words.iter().map(|&word| if word == u32::MAX { word } else { quiet(word) }).collect()
}

fn every_overload(mut visit: impl FnMut(&Definition, &Overload, &BodyForms)) {
    let mut library = NodeLibrary::standard();
    library.add(super::adding_a_node::contrast::definition());
    library.add(super::fixed_inputs::powers::definition());
    for definition in library.iter().flat_map(|(_, definition)| definition.settled()) {
        for overload in &definition.overloads {
            if let Some(code) = &overload.code {
                visit(&definition, overload, code);
            }
        }
    }
}

#[test]
fn in_range_inputs_give_outputs_in_range_and_all_forms_agree() {
    every_overload(|definition, overload, code| {
        let trial = Trial::new(definition, overload, false);
        let outputs = trial.run(code);
        if matches!(definition.signature.kind, super::Kind::Scope(_)) {
            return;
        }
        for (point, words) in trial.points.iter().zip(&outputs) {
            let mut at = 0;
            for output in &definition.signature.outputs {
                let value_type = settled(output.value_type, overload);
                let values = &words[at..at + value_type.width()];
                at += value_type.width();
                if matches!(value_type, Type::Boolean | Type::Integer) {
                    continue;
                }
                for (component, &word) in values.iter().enumerate() {
                    let value = f64::from(f32::from_bits(word));
                    let alpha = value_type == Type::Color && component == 3;
                    assert!(
                        if alpha { value.is_finite() } else { output.range.contains(&value) },
                        "{}: output `{}` is {value:e}, outside {:?}, for {:?}",
                        trial.name,
                        output.name,
                        output.range,
                        point.iter().map(|&word| f32::from_bits(word)).collect::<Vec<_>>()
                    );
                }
            }
        }
    });
}

#[test]
fn out_of_range_inputs_do_not_trap_and_all_forms_agree() {
    every_overload(|definition, overload, code| {
        Trial::new(definition, overload, true).run(code);
    });
}

#[test]
fn guards_agree_in_all_forms_and_look_at_earlier_inputs_only() {
    every_overload(|definition, overload, _| {
        for anywhere in [false, true] {
            let mut trial = Trial::new(definition, overload, anywhere);
            let guards = overload.guards.clone();
            for (at, guard) in guards.iter().enumerate() {
                let Some(guard) = guard else { continue };
                let before = trial.run(guard);
                let kept = std::mem::take(&mut trial.points);
                trial.points = kept.clone();
                for point in &mut trial.points {
                    point[trial.places[at].0..].fill(f32::NAN.to_bits());
                }
                assert_eq!(trial.run(guard), before, "{} input {at}", trial.name);
                trial.points = kept;
            }
        }
    });
}

#[test]
fn undemanded_inputs_do_not_show() {
    every_overload(|definition, overload, code| {
        for anywhere in [false, true] {
            let mut trial = Trial::new(definition, overload, anywhere);
            let before = trial.points_by(code.scalar, code.outputs);
            let mut hidden = 0;
            for (at, guard) in overload.guards.iter().enumerate() {
                let Some(guard) = guard else { continue };
                let demanded = trial.points_by(guard.scalar, 1);
                let (first, width) = trial.places[at];
                for (point, demanded) in trial.points.iter_mut().zip(&demanded) {
                    if demanded[0] == 0 {
                        point[first..first + width].fill(0x7fc0_1234);
                        hidden += 1;
                    }
                }
            }
            let after = trial.points_by(code.scalar, code.outputs);
            for (at, (before, after)) in before.iter().zip(&after).enumerate() {
                assert_eq!(before, after, "{} at {:x?}", trial.name, trial.points[at]);
            }
            let guarded = overload.guards.iter().any(Option::is_some);
            assert_eq!(guarded, hidden > 0, "{}: its guards never close", trial.name);
        }
    });
}

/// The inputs of one component: of generic ones that word, of others all.
fn alone(definition: &Definition, trial: &Trial, point: &[u32], component: usize) -> Vec<u32> {
    let inputs = definition.signature.inputs.iter().zip(&trial.places);
    inputs
        .flat_map(|(input, &(first, width))| match input.value_type {
            Type::Generic => &point[first + component..][..1],
            _ => &point[first..][..width],
        })
        .copied()
        .collect()
}

#[test]
fn nodes_per_component_take_each_alone_and_keep_the_alpha_of_the_first() {
    let mut tried = 0;
    every_overload(|definition, overload, code| {
        if !definition.per_component {
            return;
        }
        tried += 1;
        let name = &definition.signature.name;
        let generic = |input: &super::Input| input.value_type == Type::Generic;
        assert!(generic(&definition.signature.inputs[0]), "{name}: alpha comes from there");
        let of_one = (definition.overloads.iter())
            .find(|form| form.generic == Some(Type::Scalar))
            .and_then(|form| form.code)
            .expect("numbers have a form");
        for anywhere in [false, true] {
            let trial = Trial::new(definition, overload, anywhere);
            let outputs = trial.points_by(code.scalar, code.outputs);
            for (point, words) in trial.points.iter().zip(&outputs) {
                for component in 0..words.len().min(3) {
                    let mut result = [0];
                    (of_one.scalar)(&alone(definition, &trial, point, component), &mut result);
                    let word = &words[component..][..1];
                    assert_eq!(canonical(word), canonical(&result), "{name} at {point:x?}");
                }
                assert_eq!(words.get(3), (words.len() == 4).then(|| &point[3]), "{name}: alpha");
            }
        }
    });
    assert!(tried >= 3 * 20, "{tried} forms are per component");
}

#[test]
fn signatures_are_sound() {
    let library = NodeLibrary::standard();
    for (node_type, definition) in library.iter() {
        let signature = &definition.signature;
        let name = &*signature.name;
        assert_eq!(library.find(name), Some(node_type), "{name} is listed twice");
        assert!(!signature.doc.is_empty() && !signature.outputs.is_empty(), "{name}");
        assert!(library.groups().iter().any(|group| group.name == signature.group), "{name}");
        for overload in &definition.overloads {
            assert_eq!(overload.guards.len(), signature.inputs.len(), "{name}");
        }
        for (at, input) in signature.inputs.iter().enumerate() {
            assert!(input.doc.ends_with('.'), "{name}.{}", input.name);
            assert_eq!(signature.input(&input.name), Some(at), "{name}.{} twice", input.name);
            let guards = definition.overloads.iter().map(|overload| &overload.guards[at]);
            assert!(guards.map(Option::is_some).all(|guard| guard == input.guarded));
            let named = input.choices.is_empty() || input.fixed;
            assert!(named && (!input.fixed || input.value_type == Type::Integer), "{name}");
            check_default(&library, name, input);
        }
        for (at, output) in signature.outputs.iter().enumerate() {
            assert!(output.doc.ends_with('.'), "{name}.{}", output.name);
            assert_eq!(signature.output(&output.name), Some(at), "{name}.{} twice", output.name);
        }
    }
}

fn check_default(library: &NodeLibrary, name: &str, input: &super::Input) {
    let generic = input.value_type == Type::Generic;
    match &input.default {
        super::DefaultValue::Required => {}
        super::DefaultValue::Literal(literal) => {
            assert!(generic || literal.value_type() == input.value_type, "{name}.{}", input.name);
            if let crate::values::Literal::Scalar(value) = literal {
                assert!(input.range.contains(&f64::from(*value)), "{name}.{}", input.name);
            }
        }
        super::DefaultValue::State(field) => assert_eq!(field.value_type(), input.value_type),
        super::DefaultValue::Node(implied) => {
            let implied = library.find(implied).expect("the implied node exists");
            let implied = library.signature(implied);
            assert_eq!(implied.outputs[0].value_type, input.value_type, "{name}.{}", input.name);
            let given =
                |input: &super::Input| !matches!(input.default, super::DefaultValue::Required);
            assert!(implied.inputs.iter().all(given), "{name}.{}", input.name);
        }
    }
}
