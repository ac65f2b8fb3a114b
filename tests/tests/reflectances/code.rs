//! A node's body by the names of its inputs, run many times.

use std::collections::HashMap;

use phenomenon_compiler::kernels::BodyForms;
use phenomenon_compiler::nodes::{DefaultValue, NodeLibrary};
use phenomenon_compiler::values::{Literal, Type};

/// What a setting gives.
#[derive(Clone, Copy, Debug)]
pub enum Given {
    /// A number.
    Number(f32),
    /// A grey.
    Grey(f32),
    /// One of the choices.
    Choice(i32),
}

/// Values of inputs.
pub type Settings<'a> = &'a [(&'a str, Given)];

/// A body with words for its inputs.
pub struct Code {
    forms: BodyForms,
    places: HashMap<String, usize>,
    results: HashMap<String, usize>,
    words: Vec<u32>,
    outputs: Vec<u32>,
}

impl Code {
    /// The node of this name, its inputs as set and by default.
    pub fn of(name: &str, settings: Settings<'_>) -> Self {
        let library = NodeLibrary::standard();
        let definition = library.definition(library.find(name).expect("a node")).clone();
        let forms = definition.overloads[0].code.expect("the node has a body");
        let (mut places, mut words) = (HashMap::new(), Vec::new());
        for input in &definition.signature.inputs {
            places.insert(input.name.to_string(), words.len());
            let width = input.value_type.width();
            match &input.default {
                DefaultValue::Literal(Literal::Scalar(value)) => {
                    words.extend(vec![value.to_bits(); width])
                }
                DefaultValue::Literal(literal) => words.extend(literal.words()),
                _ => words.extend(vec![0; width]),
            }
        }
        let (mut results, mut at) = (HashMap::new(), 0);
        for output in &definition.signature.outputs {
            results.insert(output.name.to_string(), at);
            at += output.value_type.width();
        }
        let outputs = vec![0; at];
        let mut code = Self { forms, places, results, words, outputs };
        for &(input, given) in settings {
            match given {
                Given::Number(value) => code.set(input, &[value]),
                Given::Grey(value) => code.set(input, &[value, value, value, 1.0]),
                Given::Choice(number) => {
                    let at = code.place(input);
                    code.words[at] = number as u32;
                }
            }
        }
        let fixed: Vec<_> = definition
            .fixed_words(&definition.overloads[0])
            .map(|(_, word)| (word, code.words[word] as i32))
            .collect();
        code.forms = code.forms.with_fixed(&fixed);
        assert!(definition.signature.inputs.iter().all(|input| input.value_type != Type::Generic));
        code
    }

    fn place(&self, input: &str) -> usize {
        *self.places.get(input).unwrap_or_else(|| panic!("no input `{input}`"))
    }

    /// Sets an input, if the node has it.
    pub fn set_if_there(&mut self, input: &str, value: &[f32]) {
        if self.places.contains_key(input) {
            self.set(input, value);
        }
    }

    /// Sets an input.
    pub fn set(&mut self, input: &str, value: &[f32]) {
        let at = self.place(input);
        for (word, value) in self.words[at..].iter_mut().zip(value) {
            *word = value.to_bits();
        }
    }

    /// Runs the body.
    pub fn run(&mut self) {
        self.forms.scalar(&self.words, &mut self.outputs);
    }

    /// A number of an output.
    pub fn number(&self, output: &str, component: usize) -> f64 {
        f64::from(f32::from_bits(self.outputs[self.results[output] + component]))
    }
}
