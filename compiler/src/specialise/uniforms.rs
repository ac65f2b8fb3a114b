//! Words that are the same for every point: literals, parameters, and what is computed from them
//! alone. Computed when parameters are bound, not when points are shaded.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use crate::kernels::BodyForms;
use crate::storage::Source;
use crate::values::Literal;

/// The uniform words of a specialised graph and how to compute them.
#[derive(Clone, Debug, Default)]
pub struct Uniforms {
    values: Vec<u32>,
    /// Where the word with these bits stands.
    constants: FxHashMap<u32, u32>,
    /// Where the first word of a parameter stands.
    parameters: BTreeMap<usize, u32>,
    computed: Vec<Computed>,
    decisions: Vec<Decision>,
    /// Parameters whose value shaped the code, with that value.
    fixed: BTreeMap<usize, Literal>,
}

/// A node over uniform words alone.
#[derive(Clone, Debug)]
struct Computed {
    code: BodyForms,
    inputs: Vec<u32>,
    output: u32,
}

/// A guard over uniform words alone, whose outcome shaped the code.
#[derive(Clone, Debug)]
struct Decision {
    code: BodyForms,
    inputs: Vec<u32>,
    outcome: bool,
}

impl Uniforms {
    /// The words, in order of position.
    pub fn values(&self) -> &[u32] {
        &self.values
    }

    /// The word with these bits.
    pub fn constant(&mut self, bits: u32) -> Source {
        let values = &mut self.values;
        let at = *self.constants.entry(bits).or_insert_with(|| {
            values.push(bits);
            values.len() as u32 - 1
        });
        Source::Constant { at, bits }
    }

    /// Whether the word at this position is a constant.
    fn is_constant(&self, at: u32) -> bool {
        self.constants.get(&self.values[at as usize]) == Some(&at)
    }

    /// The words of an interface parameter, whose value they take anew at each binding.
    pub fn parameter(&mut self, parameter: usize, value: &Literal) -> Vec<Source> {
        let words = value.words();
        let values = &mut self.values;
        let first = *self.parameters.entry(parameter).or_insert_with(|| {
            let first = values.len() as u32;
            values.extend(&words);
            first
        });
        (0..words.len() as u32).map(|word| Source::Uniform(first + word)).collect()
    }

    /// Remembers that the value of a parameter shaped the code.
    pub fn fix(&mut self, parameter: usize, value: &Literal) {
        self.fixed.insert(parameter, value.clone());
    }

    /// The positions of `sources`, if all are uniform.
    pub fn positions(sources: &[Source]) -> Option<Vec<u32>> {
        sources
            .iter()
            .map(|source| match source {
                Source::Uniform(at) | Source::Constant { at, .. } => Some(*at),
                Source::Slot(_) => None,
            })
            .collect()
    }

    /// The outputs of `code` over uniform words; constants where all of these are.
    pub fn compute(&mut self, code: BodyForms, inputs: Vec<u32>) -> Vec<Source> {
        if inputs.iter().all(|&at| self.is_constant(at)) {
            let mut outputs = vec![0; code.outputs];
            code.scalar(&gather(&self.values, &inputs), &mut outputs);
            return outputs.into_iter().map(|bits| self.constant(bits)).collect();
        }
        let output = self.values.len() as u32;
        self.values.resize(self.values.len() + code.outputs, 0);
        let computed = Computed { code, inputs, output };
        computed.run(&mut self.values);
        self.computed.push(computed);
        (0..code.outputs as u32).map(|word| Source::Uniform(output + word)).collect()
    }

    /// The outcome of a guard over uniform words; remembered as one that shaped the code.
    pub fn decide(&mut self, code: BodyForms, inputs: Vec<u32>) -> bool {
        let mut decision = Decision { code, inputs, outcome: false };
        decision.outcome = decision.run(&self.values);
        let outcome = decision.outcome;
        if !decision.inputs.iter().all(|&at| self.is_constant(at)) {
            self.decisions.push(decision);
        }
        outcome
    }

    /// Takes new values of the interface parameters. False, with nothing changed, if a guard would
    /// now be decided otherwise, or a value that shaped the code is another: then the graph must be
    /// specialised anew.
    #[must_use]
    pub fn rebind(&mut self, parameters: &[Literal]) -> bool {
        if self.fixed.iter().any(|(&parameter, value)| parameters[parameter] != *value) {
            return false;
        }
        let mut values = self.values.clone();
        for (&parameter, &first) in &self.parameters {
            let words = parameters[parameter].words();
            values[first as usize..first as usize + words.len()].copy_from_slice(&words);
        }
        for computed in &self.computed {
            computed.run(&mut values);
        }
        let same = self.decisions.iter().all(|decision| decision.run(&values) == decision.outcome);
        if same {
            self.values = values;
        }
        same
    }
}

fn gather(values: &[u32], positions: &[u32]) -> Vec<u32> {
    positions.iter().map(|&at| values[at as usize]).collect()
}

impl Computed {
    fn run(&self, values: &mut [u32]) {
        let inputs = gather(values, &self.inputs);
        let output = self.output as usize;
        self.code.scalar(&inputs, &mut values[output..output + self.code.outputs]);
    }
}

impl Decision {
    fn run(&self, values: &[u32]) -> bool {
        let mut outcome = [0];
        self.code.scalar(&gather(values, &self.inputs), &mut outcome);
        outcome[0] != 0
    }
}
