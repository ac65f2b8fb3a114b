//! The pass through the nodes, sources first.

use std::collections::HashMap;

use crate::check::draft::Draft;
use crate::emit::interval::{Word, tag};
use crate::graph::{Binding, Node};
use crate::nodes::{DefaultValue, Definition, FINITE, Kind, NodeType, Overload};
use crate::values::Type;

use super::arriving::{Arriving, Fit, of_overload, settled};
use super::demands::{self, Guards};
use super::given::{self, is_alpha, word_type};
use super::slots::Slots;
use super::trials;
use super::value::{Value, name_of};

/// What is known of every value of a graph.
pub struct Intervals<'n> {
    slots: Slots<'n>,
    /// The output words of all nodes.
    values: Vec<Value>,
    /// First of them for each slot; none where nothing is known of it, as on a cycle.
    first: Vec<Option<usize>>,
    parameters: Vec<Vec<Value>>,
    guards: Guards,
    conditions: Vec<u64>,
}

impl<'n> Intervals<'n> {
    /// Goes through the nodes in `order`, which has sources first. `nodes` are those of the draft as
    /// they are bound.
    pub fn of(draft: &Draft<'_>, nodes: &'n [Node], order: &[usize]) -> Self {
        let mut sources = 0;
        let parameters = draft.parameters.iter().enumerate().map(|(at, drafted)| {
            let words = drafted.parameter.as_ref().map(|it| given::parameter(it, at, sources));
            let words = words.unwrap_or_default();
            sources += words.len();
            words
        });
        let parameters = parameters.collect();
        let slots = Slots::of(draft, nodes);
        let order = slots.ordered(order);
        let mut intervals = Self {
            values: Vec::new(),
            first: vec![None; slots.count()],
            slots,
            parameters,
            guards: Guards::default(),
            conditions: Vec::new(),
        };
        let mut pass = Pass { draft, sources, implied: HashMap::new() };
        for &slot in &order {
            if let Some(node) = intervals.slots.node(slot) {
                let words = pass.node(&mut intervals, slot, node);
                intervals.first[slot] = Some(intervals.values.len());
                intervals.values.extend(words);
            }
        }
        intervals.guards.sort();
        intervals.conditions =
            demands::conditions(draft, &intervals.slots, &order, &intervals.guards);
        intervals
    }

    /// The inputs of nodes of the draft that are never demanded, by node and input, in order.
    pub fn never_demanded(&self, draft: &Draft<'_>) -> impl Iterator<Item = (usize, usize)> {
        let closed = self.guards.closed.iter().copied();
        closed.filter(|&(node, _)| self.bound(draft, node).is_some())
    }

    /// The inputs of bound nodes that are never demanded, ascending.
    pub fn ruled_out(&self) -> Vec<(usize, usize)> {
        self.guards.closed.clone()
    }

    /// The words that arrive at an input of a node of the draft; none where the node is not bound as
    /// it is written.
    pub fn arriving(&self, draft: &Draft<'_>, node: usize, input: usize) -> Vec<Value> {
        let mut words = Vec::new();
        if let Some(bound) = self.bound(draft, node) {
            self.read(draft, node, bound, input, &mut words);
        }
        words
    }

    /// Whether a complaint about values of these sources holds where an input of a node is evaluated.
    pub fn holds_at(&self, node: usize, input: usize, sources: u64) -> bool {
        (self.conditions[node] | self.guards.condition(node, input)) & sources == 0
    }

    /// A node of the draft, if it is bound as it is written: one over a list is not.
    fn bound(&self, draft: &Draft<'_>, node: usize) -> Option<&'n Node> {
        let node_type = draft.nodes.get(node)?.node_type?;
        self.slots.node(node).filter(|bound| bound.node_type == node_type)
    }

    /// Writes the words that an input takes; of an implied node those of nothing known.
    fn read(
        &self,
        draft: &Draft<'_>,
        slot: usize,
        node: &Node,
        input: usize,
        into: &mut Vec<Value>,
    ) {
        let definition = draft.node_types.definition(node.node_type);
        let to = settled(definition, node.overload, input);
        match &node.inputs[input] {
            Binding::Literal(literal) => given::literal(literal, to, into),
            Binding::Parameter(parameter) => {
                let from = draft.parameters[*parameter].value_type.unwrap_or(to);
                match self.parameters[*parameter].as_slice() {
                    [] => given::unknown(to, into),
                    words => given::converted(words, from, to, into),
                }
            }
            Binding::Node { node: source, output } => {
                let first = self.first.get(*source).copied().flatten();
                let (Some(node), Some(first)) = (self.slots.node(*source), first) else {
                    return given::unknown(to, into);
                };
                let definition = draft.node_types.definition(node.node_type);
                let overload = &definition.overloads[node.overload];
                let outputs = &definition.signature.outputs;
                let width = |at: usize| of_overload(outputs[at].value_type, overload).width();
                let first = first + (0..*output).map(width).sum::<usize>();
                let words = &self.values[first..first + width(*output)];
                let from = of_overload(outputs[*output].value_type, overload);
                given::converted(words, from, to, into);
            }
            // Given, but not understood: that is no default.
            Binding::Default
                if draft.nodes.get(slot).is_some_and(|drafted| {
                    drafted.inputs.iter().any(|given| given.input == Some(input))
                }) && self.bound(draft, slot).is_some() =>
            {
                given::unknown(to, into);
            }
            // What the checker gives it is not known here.
            Binding::Default if definition.signature.inputs[input].implied.is_some() => {
                given::unknown(to, into);
            }
            Binding::Default => default(&definition.signature.inputs[input].default, to, into),
        }
    }
}

/// What stands in for an input that is not given, an implied node aside.
fn default(default: &DefaultValue, to: Type, into: &mut Vec<Value>) {
    match default {
        DefaultValue::Literal(literal) => given::literal(literal, to, into),
        DefaultValue::State(field) => given::field(*field, into),
        DefaultValue::Required | DefaultValue::Node(_) => given::unknown(to, into),
    }
}

struct Pass<'p, 'd> {
    draft: &'p Draft<'d>,
    /// Sources counted so far.
    sources: usize,
    /// What implied nodes yield.
    implied: HashMap<NodeType, Vec<Value>>,
}

impl Pass<'_, '_> {
    /// The words a node yields.
    fn node(&mut self, intervals: &mut Intervals<'_>, slot: usize, node: &Node) -> Vec<Value> {
        let draft = self.draft;
        let definition = draft.node_types.definition(node.node_type);
        let mut arriving = Arriving::new(definition.signature.inputs.len());
        for input in 0..definition.signature.inputs.len() {
            let implied = match (&definition.signature.inputs[input].default, &node.inputs[input]) {
                (DefaultValue::Node(name), Binding::Default) => draft.node_types.library.find(name),
                _ => None,
            };
            match implied {
                Some(implied) => arriving.words.extend(self.implied(implied)),
                None => intervals.read(draft, slot, node, input, &mut arriving.words),
            }
            arriving.given[input] = node.inputs[input] != Binding::Default;
            arriving.first.push(arriving.words.len());
        }
        arriving.number();
        let overload = &definition.overloads[node.overload];
        self.guards(definition, overload, slot, &mut arriving, &mut intervals.guards);
        self.outputs(definition, overload, slot, &arriving)
    }

    /// Decides the guards of a node's inputs, as far as that can be.
    fn guards(
        &self,
        definition: &Definition,
        overload: &Overload,
        slot: usize,
        arriving: &mut Arriving,
        guards: &mut Guards,
    ) {
        let fixed = arriving.fixed(definition);
        let guarded = overload.guards.iter().enumerate();
        for (input, guard) in guarded.filter_map(|(at, guard)| Some((at, guard.as_ref()?))) {
            let mut holds = [Word::UNKNOWN];
            let Some(fixed) = &fixed else {
                guards.open.push(((slot, input), arriving.sources(u64::MAX)));
                continue;
            };
            guard.with_fixed(fixed).intervals(&arriving.sets, &mut holds);
            match holds[0] {
                Word::Truth(truth) if truth.decided() == Some(false) => {
                    arriving.never[input] = true;
                    guards.closed.push((slot, input));
                }
                Word::Truth(truth) if truth.decided() == Some(true) => {}
                open => {
                    guards.open.push(((slot, input), arriving.sources(open.reads())));
                }
            }
        }
    }

    /// What an implied node yields first, with all its defaults.
    fn implied(&mut self, node_type: NodeType) -> Vec<Value> {
        if let Some(known) = self.implied.get(&node_type) {
            return known.clone();
        }
        let definition = self.draft.node_types.definition(node_type);
        let overload = &definition.overloads[0];
        let mut arriving = Arriving::new(definition.signature.inputs.len());
        for input in &definition.signature.inputs {
            // One that implies another in its turn is not followed.
            default(&input.default, of_overload(input.value_type, overload), &mut arriving.words);
            arriving.first.push(arriving.words.len());
        }
        arriving.number();
        let at = self.draft.nodes.len() + node_type.0;
        let mut words = self.outputs(definition, overload, at, &arriving);
        words.truncate(of_overload(definition.signature.outputs[0].value_type, overload).width());
        self.implied.insert(node_type, words.clone());
        words
    }

    fn outputs(
        &mut self,
        definition: &Definition,
        overload: &Overload,
        at: usize,
        arriving: &Arriving,
    ) -> Vec<Value> {
        let signature = &definition.signature;
        let mut words = Vec::new();
        match (&signature.kind, &overload.code) {
            (Kind::Plain, Some(code)) => {
                let Some(fixed) = arriving.fixed(definition) else {
                    self.declared(definition, overload, &mut words);
                    return words;
                };
                let code = &code.with_fixed(&fixed);
                let mut sets = vec![Word::UNKNOWN; code.outputs];
                code.intervals(&arriving.sets, &mut sets);
                let reached = trials::reached(code, &arriving.words, &sets);
                for (set, reached) in sets.into_iter().zip(reached) {
                    let sources = arriving.sources(set.reads());
                    words.push(Value { word: set.read_from(0), reached, sources });
                }
                self.declare(definition, overload, arriving, &mut words);
            }
            (Kind::Fields(fields), _) => {
                for &field in fields {
                    given::field(field, &mut words);
                }
            }
            (Kind::Scope(_), _) => {
                // The value of the scoped input, of another point.
                let scoped = signature.inputs.iter().position(|input| input.scoped);
                let inner = scoped.map_or(&[][..], |scoped| arriving.of(scoped));
                let outputs = &signature.outputs;
                let width: usize =
                    outputs.iter().map(|it| of_overload(it.value_type, overload).width()).sum();
                words.extend(
                    inner
                        .iter()
                        .take(width)
                        .map(|value| Value { word: value.word.read_from(0).known_as(0), ..*value }),
                );
                words.resize(width, Value::unknown(Type::Scalar));
            }
            (Kind::Request(_) | Kind::Loop(..), _) => {
                self.declared(definition, overload, &mut words)
            }
            (Kind::Plain, None) | (Kind::List(_), _) => {
                for output in &signature.outputs {
                    given::unknown(of_overload(output.value_type, overload), &mut words);
                }
            }
        }
        for (word, value) in words.iter_mut().enumerate() {
            *value = value.named(name_of(const { tag("output") }, at, word));
        }
        words
    }

    /// What the renderer answers, and a loop sums: what is declared.
    fn declared(&mut self, definition: &Definition, overload: &Overload, words: &mut Vec<Value>) {
        let own = given::source(self.sources);
        self.sources += 1;
        for output in &definition.signature.outputs {
            let value_type = of_overload(output.value_type, overload);
            for component in 0..value_type.width() {
                let known = match value_type {
                    Type::Boolean => given::free(),
                    _ if is_alpha(value_type, component) => Value::unknown(Type::Scalar),
                    _ if output.range == FINITE => Value::unknown(word_type(value_type)),
                    _ => given::within(value_type, &output.range),
                };
                words.push(Value { sources: own, ..known });
            }
        }
    }

    /// Narrows what a body yields to what its outputs are declared to be, and takes that for reached
    /// where nothing narrower than declared was given to the node.
    fn declare(
        &mut self,
        definition: &Definition,
        overload: &Overload,
        arriving: &Arriving,
        words: &mut [Value],
    ) {
        let in_range = arriving.fits(definition, overload, Fit::Within);
        let mut unrestricted = None;
        let mut own = None;
        let mut at = 0;
        for output in &definition.signature.outputs {
            let value_type = of_overload(output.value_type, overload);
            let range = (*output.range.start() as f32, *output.range.end() as f32);
            for component in 0..value_type.width() {
                let value = &mut words[at];
                at += 1;
                let Word::Number(number) = value.word else { continue };
                if is_alpha(value_type, component) {
                    continue;
                }
                if in_range {
                    value.word = Word::Number(number.narrowed(range.0, range.1));
                }
                if value.reached.is_some() || output.range == FINITE {
                    continue;
                }
                let wide = *unrestricted
                    .get_or_insert_with(|| arriving.fits(definition, overload, Fit::AsWide));
                if wide {
                    let own = *own.get_or_insert_with(|| {
                        self.sources += 1;
                        given::source(self.sources - 1)
                    });
                    // The words of one node vary together.
                    value.reached = given::within(value_type, &output.range).reached;
                    value.sources = own | arriving.sources(u64::MAX);
                }
            }
        }
    }
}
