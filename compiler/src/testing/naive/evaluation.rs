//! Inputs are evaluated when demanded, each node at most once in each of its epochs.

use std::collections::HashMap;

use crate::effects::{Asked, Effect, LightList, Renderer};
use crate::graph::Binding;
use crate::kernels::BodyForms;
use crate::nodes::{DefaultValue, Kind, Output};
use crate::specialise::mix_key;
use crate::state::{Field, State};
use crate::values::Type;

use super::nodes::{Naive, TooLong};
use super::surroundings::{Inside, Surroundings, SurroundingsId};
use crate::testing::reads::{self, Fields};

/// One evaluation of a root.
pub(super) struct Evaluation<'a> {
    pub(super) naive: &'a Naive<'a>,
    pub(super) point: &'a State,
    pub(super) renderer: &'a mut dyn Renderer,
    pub(super) surroundings: Vec<Surroundings>,
    pub(super) kept: HashMap<(usize, SurroundingsId), Vec<u32>>,
    pub(super) light_colors: HashMap<(LightList, usize, SurroundingsId), [f32; 3]>,
    pub(super) steps: &'a mut usize,
}

/// Words of one type as those of another.
fn converted(words: Vec<u32>, from: Type, to: Type) -> Vec<u32> {
    let one = 1.0_f32.to_bits();
    match (from, to) {
        (Type::Integer, Type::Scalar) => vec![(words[0] as i32 as f32).to_bits()],
        (Type::Integer, Type::Color) => {
            converted(converted(words, from, Type::Scalar), Type::Scalar, to)
        }
        (Type::Scalar, Type::Color) => vec![words[0], words[0], words[0], one],
        // A shader is called where its words are read.
        (Type::Color, Type::Shader) => words,
        (Type::Integer | Type::Scalar, Type::Shader) => converted(words, from, Type::Color),
        _ => {
            assert_eq!(from, to);
            words
        }
    }
}

/// The outputs a node declares, one after another, from the whole answer.
fn declared(outputs: &[Output], effect: Effect, answer: &[u32]) -> Vec<u32> {
    let mut words = Vec::new();
    for output in outputs {
        let mut first = 0;
        for part in effect.answers().iter().take_while(|part| output.name != part.name) {
            first += part.value_type.width();
        }
        words.extend(&answer[first..first + output.value_type.width()]);
    }
    words
}

impl Evaluation<'_> {
    /// The value of a binding that is not a default.
    pub(super) fn given(
        &mut self,
        binding: &Binding,
        to: Type,
        at: SurroundingsId,
    ) -> Result<Vec<u32>, TooLong> {
        match binding {
            Binding::Literal(literal) => Ok(converted(literal.words(), literal.value_type(), to)),
            Binding::Parameter(parameter) => {
                let value = &self.naive.parameters[*parameter];
                Ok(converted(value.words(), value.value_type(), to))
            }
            Binding::Node { node, output } => self.output(*node, *output, to, at),
            Binding::Default => unreachable!("defaults are the caller's"),
        }
    }

    pub(super) fn input(
        &mut self,
        node: usize,
        input: usize,
        at: SurroundingsId,
    ) -> Result<Vec<u32>, TooLong> {
        let naive = self.naive;
        let of = &naive.nodes[node];
        let declared = &naive.library.signature(of.node_type).inputs[input];
        let to = naive.value_type(of, declared.value_type);
        if of.inputs[input] != Binding::Default {
            return self.given(&of.inputs[input], to, at);
        }
        match &declared.default {
            DefaultValue::Literal(literal) => {
                Ok(literal.as_default(to).expect("a default is of the input's type").words())
            }
            DefaultValue::State(field) => {
                Ok(converted(self.field(*field, at)?, field.value_type(), to))
            }
            DefaultValue::Node(name) => self.output(naive.implied[name], 0, to, at),
            DefaultValue::Required => panic!("random graphs bind required inputs"),
        }
    }

    pub(super) fn output(
        &mut self,
        node: usize,
        output: usize,
        to: Type,
        at: SurroundingsId,
    ) -> Result<Vec<u32>, TooLong> {
        let naive = self.naive;
        let of = &naive.nodes[node];
        let signature = naive.library.signature(of.node_type);
        let from = naive.value_type(of, signature.outputs[output].value_type);
        let words = if let Kind::Fields(fields) = &signature.kind {
            self.field(fields[output], at)?
        } else {
            let first: usize = signature.outputs[..output]
                .iter()
                .map(|before| naive.value_type(of, before.value_type).width())
                .sum();
            self.evaluated(node, at)?[first..first + from.width()].to_vec()
        };
        Ok(converted(words, from, to))
    }

    /// The outermost surroundings in which what reads `fields` has the value it has in `at`.
    pub(super) fn effective(&self, mut at: SurroundingsId, fields: &Fields) -> SurroundingsId {
        while at != 0 && self.surroundings[at].changes.is_disjoint(fields) {
            at = self.surroundings[at].outside;
        }
        at
    }

    /// A state field as seen in surroundings.
    fn field(&mut self, field: Field, at: SurroundingsId) -> Result<Vec<u32>, TooLong> {
        let at = self.effective(at, &[field].into());
        let width = field.value_type().width();
        match &self.surroundings[at].inside_of {
            Inside::Point => {
                let mut words = vec![0; width];
                self.renderer.objects().read(field, self.point, &mut words);
                Ok(words)
            }
            Inside::Turn { fields, .. } => {
                let provided = fields.iter().find(|(of, _)| *of == field);
                Ok(provided.expect("a turn provides what it changes").1.clone())
            }
            Inside::Scope { node, fields: None } => {
                let (node, outside) = (*node, self.surroundings[at].outside);
                let entered = self.enter(node, outside)?;
                self.surroundings[at].inside_of = Inside::Scope { node, fields: Some(entered) };
                self.field(field, at)
            }
            Inside::Scope { fields: Some(fields), .. } => {
                let changed = fields.iter().find(|(of, _)| *of == field);
                Ok(changed.expect("a scope sets what it changes").1.clone())
            }
        }
    }

    /// The fields a scope changes.
    fn enter(
        &mut self,
        node: usize,
        at: SurroundingsId,
    ) -> Result<Vec<(Field, Vec<u32>)>, TooLong> {
        let of = &self.naive.nodes[node];
        let Kind::Scope(fields) = &self.naive.library.signature(of.node_type).kind else {
            panic!("only scopes are entered");
        };
        let words = self.body(node, at)?;
        let mut rest = &words[..];
        Ok(fields
            .iter()
            .map(|&field| {
                let (words, after) = rest.split_at(field.value_type().width());
                rest = after;
                (field, words.to_vec())
            })
            .collect())
    }

    fn evaluated(&mut self, node: usize, at: SurroundingsId) -> Result<Vec<u32>, TooLong> {
        let naive = self.naive;
        let at = self.effective(at, naive.reads[node].as_ref().expect("settled"));
        if let Some(kept) = self.kept.get(&(node, at)) {
            return Ok(kept.clone());
        }
        *self.steps = self.steps.checked_sub(1).ok_or(TooLong)?;
        let signature = naive.library.signature(naive.nodes[node].node_type);
        let words = match &signature.kind {
            Kind::Plain => self.body(node, at)?,
            Kind::Request(effect) => {
                let answer = match effect.asked() {
                    Asked::LightColors => self.light_color(at)?,
                    Asked::LightDensity => self.light_density(node, at)?,
                    Asked::Texels => self.read_texture(node, at)?,
                    Asked::TextureSize => self.texture_size(node),
                    Asked::Rays(trace) => self.trace(node, trace, at)?,
                };
                declared(&signature.outputs, *effect, &answer)
            }
            Kind::Scope(_) => {
                let scope = Inside::Scope { node, fields: None };
                let inside = self.open(node, at, scope);
                let scoped = signature.inputs.iter().position(|input| input.scoped);
                self.input(node, scoped.expect("a scope has a scoped input"), inside)?
            }
            Kind::Loop(iterated, reduction) => self.turns(node, *iterated, *reduction, at)?,
            Kind::Fields(_) => unreachable!("fields are read, not evaluated"),
            Kind::List(_) => unreachable!("the checker makes other nodes of it"),
        };
        self.kept.insert((node, at), words.clone());
        Ok(words)
    }

    pub(super) fn open(
        &mut self,
        node: usize,
        outside: SurroundingsId,
        inside_of: Inside,
    ) -> SurroundingsId {
        let of = &self.naive.nodes[node];
        let changes = reads::changed(&self.naive.library.signature(of.node_type).kind);
        self.surroundings.push(Surroundings { outside, changes, name: of.name.clone(), inside_of });
        self.surroundings.len() - 1
    }

    /// Evaluates the inputs that the guards ask for, in order, then the body.
    fn body(&mut self, node: usize, at: SurroundingsId) -> Result<Vec<u32>, TooLong> {
        let naive = self.naive;
        let of = &naive.nodes[node];
        let definition = naive.library.definition(of.node_type);
        let overload = &definition.overloads[of.overload];
        let widths: Vec<usize> = definition
            .signature
            .inputs
            .iter()
            .map(|input| naive.value_type(of, input.value_type).width())
            .collect();
        let fixed: Vec<usize> = definition.fixed_words(overload).map(|(_, word)| word).collect();
        let settled = |code: BodyForms, words: &[u32]| {
            let known: Vec<_> = fixed.iter().map(|&word| (word, words[word] as i32)).collect();
            code.with_fixed(&known)
        };
        let mut words = vec![0; widths.iter().sum()];
        let mut first = 0;
        for (input, declared) in definition.signature.inputs.iter().enumerate() {
            let holds = overload.guards[input].is_none_or(|guard| {
                let mut outcome = [0];
                settled(guard, &words).scalar(&words, &mut outcome);
                outcome[0] != 0
            });
            if holds && !declared.scoped && !declared.value_type.is_in_code() {
                let value = self.input(node, input, at)?;
                words[first..first + widths[input]].copy_from_slice(&value);
            }
            first += widths[input];
        }
        let code = overload.code.expect("plain nodes and scopes have bodies");
        let code = settled(code, &words);
        let mut outputs = vec![0; code.outputs];
        code.scalar(&words, &mut outputs);
        Ok(outputs)
    }

    /// The state of the point with the given fields as they are in the surroundings.
    pub(super) fn state(&mut self, fields: &[Field], at: SurroundingsId) -> Result<State, TooLong> {
        let mut state = *self.point;
        for &field in fields {
            let words = self.field(field, at)?;
            field.write(&mut state, &words);
        }
        Ok(state)
    }

    /// Surroundings from the outermost to `at`.
    pub(super) fn way_to(&self, mut at: SurroundingsId) -> Vec<SurroundingsId> {
        let mut way = Vec::new();
        while at != 0 {
            way.push(at);
            at = self.surroundings[at].outside;
        }
        way.reverse();
        way
    }

    /// The key of a request or a loop: the hash of its path of names, with the iterations round it.
    pub(super) fn site(&self, name: &str, at: SurroundingsId) -> u64 {
        let way = self.way_to(at);
        let names = way.iter().map(|&of| self.surroundings[of].name.as_str());
        let path: Vec<&str> = names.chain([name]).collect();
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        for byte in path.join("/").bytes() {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
        let mut key = mix_key(hash);
        for of in way {
            if let Inside::Turn { number, .. } = self.surroundings[of].inside_of {
                key = mix_key(key ^ mix_key(number as u64 + 1));
            }
        }
        key
    }
}
