//! Why an input is never asked for, from what its guard looked at.

use rustc_hash::{FxHashMap, FxHashSet};

use crate::graph::{Graph, Parameter};
use crate::nodes::Kind;
use crate::specialise::decisions::Fold;
use crate::specialise::views::{Resolved, Views};
use crate::state::{Field, RayType};
use crate::values::{Literal, Type};

use super::part::{Cause, Named, Origin, Reason};

/// Most parameters that are told of where a node makes a value of many.
const TOLD_PARAMETERS: usize = 3;

/// Most nodes that are gone through for the parameters a value is made of.
const MOST_SOURCES: usize = 4096;

/// A graph with the values it is specialised to.
pub(super) struct Settled<'a> {
    pub graph: &'a Graph,
    pub views: &'a Views<'a>,
    pub ray_type: RayType,
    /// Of the parameters.
    pub values: &'a [Literal],
    /// The uniform words.
    pub words: &'a [u32],
    /// The inputs that are never asked for, by node and input.
    pub folds: FxHashMap<(usize, usize), &'a Fold>,
    /// The texts of expressions by their names.
    pub expressions: FxHashMap<&'a str, &'a str>,
}

impl Settled<'_> {
    /// A node by its name. What an expression became is named by it.
    pub fn named(&self, view: usize) -> Named {
        let name = self.views.name(view);
        let whole = name.split_once('#').map_or(name, |(expression, _)| expression);
        let node_type = self.views.signature(view).name.to_string();
        let expression = self.expressions.get(whole).map(|text| (*text).to_owned());
        Named { name: whole.to_owned(), implied: None, expression, node_type }
    }

    /// Why the input of a fold is never asked for.
    pub fn reason(&self, fold: &Fold) -> Reason {
        let inputs = &self.views.signature(fold.view).inputs;
        let mut causes = Vec::new();
        let mut first = 0;
        for (at, declared) in inputs.iter().enumerate().take(fold.input) {
            let to = self.views.input_type(fold.view, at);
            let words = first..first + to.width();
            first = words.end;
            // What is known before shading is in the guard's code: it looks at no word of it.
            let looks = declared.fixed || fold.looks[words.clone()].contains(&true);
            if !looks || words.is_empty() {
                continue;
            }
            let words: Vec<u32> =
                fold.words[words].iter().map(|word| self.words[*word as usize]).collect();
            causes.push(self.cause(fold.view, at, to, &words));
        }
        let input = inputs[fold.input].name.to_string();
        Reason { node: self.named(fold.view), input, causes }
    }

    fn cause(&self, view: usize, input: usize, to: Type, words: &[u32]) -> Cause {
        let declared = &self.views.signature(view).inputs[input];
        let chosen = |value: String| {
            let label = value.parse().ok().and_then(|at: usize| declared.choices.get(at));
            label.map_or(value, |label| format!("`{label}`"))
        };
        let by_words = || written(to, words).unwrap_or_else(|| "known".into());
        let (value, origin) = match self.views.resolve(view, input) {
            Resolved::Literal(literal) if self.views.is_default(view, input) => {
                (chosen(literal.to_string()), Origin::Default)
            }
            Resolved::Literal(literal) => (chosen(literal.to_string()), Origin::Given),
            Resolved::Parameter(at) => {
                let parameter = &self.graph.parameters[at];
                let value = chosen(self.value_of(at));
                (value, Origin::Parameter(parameter.name.clone()))
            }
            Resolved::State(Field::RayType) => self.ray_type(),
            Resolved::State(_) => (by_words(), Origin::Given),
            Resolved::Node { view: source, output } => match &self.views.signature(source).kind {
                Kind::Fields(fields) if fields[output] == Field::RayType => self.ray_type(),
                _ => (by_words(), self.computed(source)),
            },
        };
        Cause { input: declared.name.to_string(), value, origin }
    }

    fn is_folded(&self, view: usize, input: usize) -> bool {
        self.folds.contains_key(&(view, input))
    }

    fn ray_type(&self) -> (String, Origin) {
        (self.ray_type.name().to_owned(), Origin::RayType)
    }

    /// The value of a parameter, as it is written; of an enumeration its name.
    fn value_of(&self, parameter: usize) -> String {
        let Parameter { labels, .. } = &self.graph.parameters[parameter];
        let value = &self.values[parameter];
        match value {
            Literal::Integer(number) => {
                let label = usize::try_from(*number).ok().and_then(|at| labels.get(at));
                label.map_or_else(|| value.to_string(), |label| format!("`{label}`"))
            }
            _ => value.to_string(),
        }
    }

    /// What a node makes its value of: the parameters below it, and the ray type.
    fn computed(&self, view: usize) -> Origin {
        let mut seen = FxHashSet::default();
        let mut stack = vec![view];
        let (mut parameters, mut ray_type) = (Vec::new(), None);
        while let Some(view) = stack.pop() {
            if !seen.insert(view) {
                continue;
            }
            if seen.len() > MOST_SOURCES {
                break;
            }
            for input in 0..self.views.inputs(view) {
                if self.is_folded(view, input) {
                    continue;
                }
                match self.views.resolve(view, input) {
                    Resolved::Parameter(at) if !parameters.contains(&at) => parameters.push(at),
                    Resolved::State(Field::RayType) => ray_type = Some(self.ray_type),
                    Resolved::Node { view: source, output } => {
                        match &self.views.signature(source).kind {
                            Kind::Fields(fields) if fields[output] == Field::RayType => {
                                ray_type = Some(self.ray_type);
                            }
                            _ => stack.push(source),
                        }
                    }
                    _ => {}
                }
            }
        }
        parameters.sort_unstable();
        parameters.truncate(TOLD_PARAMETERS);
        let name = |at: usize| self.graph.parameters[at].name.clone();
        let from = parameters.into_iter().map(|at| (name(at), self.value_of(at))).collect();
        Origin::Computed { node: self.named(view), from, ray_type }
    }
}

/// The value of words, as it is written in a file; none of what has no words of its own.
fn written(value_type: Type, words: &[u32]) -> Option<String> {
    let numbers: Vec<f32> = words.iter().map(|word| f32::from_bits(*word)).collect();
    let literal = match value_type {
        Type::Boolean => Literal::Boolean(words[0] != 0),
        Type::Integer => Literal::Integer(words[0] as i32),
        Type::Scalar => Literal::Scalar(numbers[0]),
        Type::Vector => Literal::Vector(numbers.try_into().ok()?),
        Type::Color | Type::Shader => Literal::Color(numbers.try_into().ok()?),
        Type::Transform => Literal::Transform(numbers.try_into().ok()?),
        Type::String | Type::Texture | Type::Light | Type::Lights | Type::Generic => return None,
    };
    Some(literal.to_string())
}
