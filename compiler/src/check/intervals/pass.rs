//! The pass through the nodes, sources first.

use std::collections::HashMap;

use crate::check::draft::Draft;
use crate::emit::interval::Word;
use crate::graph::{Binding, Node};
use crate::nodes::{Default, Definition, FINITE, Kind, NodeType, Overload, Type};

use super::arriving::{Arriving, Fit, of_overload, settled};
use super::given::{self, is_alpha, word_type};
use super::value::{ANY_SOURCE, Value, name_of};
use super::{demands, trials};

/// What is known of every value of a graph.
pub struct Intervals {
    /// The output words of all nodes.
    values: Vec<Value>,
    /// First of them for each node of the draft; none where its type is unknown, or it is on a cycle.
    first: Vec<Option<usize>>,
    parameters: Vec<Vec<Value>>,
    /// The nodes as they are bound; none of unknown type.
    bound: Vec<Option<usize>>,
    guards: Guards,
    conditions: Vec<u64>,
}

/// What is known of guards.
#[derive(Default)]
pub struct Guards {
    /// The sources that decide whether an input is demanded, by node and input.
    open: HashMap<(usize, usize), u64>,
    /// The inputs that never are, by node and input.
    closed: Vec<(usize, usize)>,
}

impl Guards {
    /// The sources that decide whether an input of a node that is evaluated is demanded.
    pub fn condition(&self, node: usize, input: usize) -> u64 {
        match self.closed.binary_search(&(node, input)) {
            Ok(_) => ANY_SOURCE,
            Err(_) => self.open.get(&(node, input)).copied().unwrap_or(0),
        }
    }
}

impl Intervals {
    /// Goes through the nodes in `order`. `nodes` are those of the draft whose type is known, in the same
    /// order, as they are bound.
    pub fn of(draft: &Draft<'_>, nodes: &[Node], order: &[usize]) -> Self {
        let mut known = 0..;
        let bound = draft.nodes.iter().map(|node| node.node_type.and_then(|_| known.next()));
        let mut sources = 0;
        let parameters = draft.parameters.iter().enumerate().map(|(at, drafted)| {
            let words = drafted.parameter.as_ref().map(|it| given::parameter(it, at, sources));
            let words = words.unwrap_or_default();
            sources += words.len();
            words
        });
        let mut intervals = Self {
            values: Vec::new(),
            first: vec![None; draft.nodes.len()],
            parameters: parameters.collect(),
            bound: bound.collect(),
            guards: Guards::default(),
            conditions: Vec::new(),
        };
        let mut pass = Pass { draft, nodes, sources, implied: HashMap::new() };
        for &node in order {
            if let Some(bound) = intervals.bound[node] {
                let words = pass.node(&mut intervals, node, &nodes[bound]);
                intervals.first[node] = Some(intervals.values.len());
                intervals.values.extend(words);
            }
        }
        intervals.guards.closed.sort_unstable();
        intervals.conditions = demands::conditions(draft, order, &intervals.guards);
        intervals
    }

    /// The inputs that are never demanded, by node and input, in order.
    pub fn never_demanded(&self) -> &[(usize, usize)] {
        &self.guards.closed
    }

    /// The words that arrive at an input; none for a node of unknown type.
    pub fn arriving(
        &self,
        draft: &Draft<'_>,
        nodes: &[Node],
        node: usize,
        input: usize,
    ) -> Vec<Value> {
        let mut words = Vec::new();
        if let Some(bound) = self.bound[node] {
            let definition = draft.library.definition(nodes[bound].node_type);
            let to = settled(definition, nodes[bound].overload, input);
            self.read(draft, nodes, node, &nodes[bound], input, to, &mut words);
        }
        words
    }

    /// Whether a complaint about values of these sources holds where an input of a node is evaluated.
    pub fn holds_at(&self, node: usize, input: usize, sources: u64) -> bool {
        (self.conditions[node] | self.guards.condition(node, input)) & sources == 0
    }

    /// Writes the words that an input takes; without an implied node, whose words are the caller's.
    #[expect(clippy::too_many_arguments, reason = "an input is known by all of these")]
    fn read(
        &self,
        draft: &Draft<'_>,
        nodes: &[Node],
        at: usize,
        node: &Node,
        input: usize,
        to: Type,
        into: &mut Vec<Value>,
    ) {
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
                let bound = self.bound.get(*source).copied().flatten();
                let (Some(bound), Some(first)) =
                    (bound, self.first.get(*source).copied().flatten())
                else {
                    return given::unknown(to, into);
                };
                let definition = draft.library.definition(nodes[bound].node_type);
                let overload = &definition.overloads[nodes[bound].overload];
                let outputs = &definition.signature.outputs;
                let width = |at: usize| of_overload(outputs[at].value_type, overload).width();
                let first = first + (0..*output).map(width).sum::<usize>();
                let words = &self.values[first..first + width(*output)];
                let from = of_overload(outputs[*output].value_type, overload);
                given::converted(words, from, to, into);
            }
            // Given, but not understood: that is no default.
            Binding::Default
                if draft.nodes[at].inputs.iter().any(|given| given.input == Some(input)) =>
            {
                given::unknown(to, into);
            }
            Binding::Default => {
                let definition = draft.library.definition(node.node_type);
                default(&definition.signature.inputs[input].default, to, into);
            }
        }
    }
}

/// What stands in for an input that is not given, an implied node aside.
fn default(default: &Default, to: Type, into: &mut Vec<Value>) {
    match default {
        Default::Literal(literal) => given::literal(literal, to, into),
        Default::State(field) => given::field(*field, into),
        Default::Required | Default::Node(_) => given::unknown(to, into),
    }
}

struct Pass<'p, 'd> {
    draft: &'p Draft<'d>,
    nodes: &'p [Node],
    /// Sources counted so far.
    sources: usize,
    /// What implied nodes yield.
    implied: HashMap<NodeType, Vec<Value>>,
}

impl Pass<'_, '_> {
    /// The words a node yields.
    fn node(&mut self, intervals: &mut Intervals, at: usize, node: &Node) -> Vec<Value> {
        let draft = self.draft;
        let definition = draft.library.definition(node.node_type);
        let mut arriving = Arriving::new(definition.signature.inputs.len());
        for input in 0..definition.signature.inputs.len() {
            let to = settled(definition, node.overload, input);
            let implied = match (&definition.signature.inputs[input].default, &node.inputs[input]) {
                (Default::Node(name), Binding::Default) => draft.library.find(name),
                _ => None,
            };
            match implied {
                Some(implied) => {
                    let words = self.implied(implied);
                    arriving.words.extend(words);
                }
                None => {
                    let nodes = self.nodes;
                    intervals.read(draft, nodes, at, node, input, to, &mut arriving.words);
                }
            }
            arriving.given[input] = node.inputs[input] != Binding::Default;
            arriving.first.push(arriving.words.len());
        }
        arriving.number();
        let overload = &definition.overloads[node.overload];
        for input in 0..overload.guards.len() {
            if let Some(guard) = &overload.guards[input] {
                let mut holds = [Word::UNKNOWN];
                let words: Vec<Word> = arriving.words.iter().map(|value| value.word).collect();
                (guard.intervals)(&words, &mut holds);
                match holds[0] {
                    Word::Truth(truth) if truth.decided() == Some(false) => {
                        arriving.never[input] = true;
                        intervals.guards.closed.push((at, input));
                    }
                    Word::Truth(truth) if truth.decided() == Some(true) => {}
                    other => {
                        let sources = arriving.sources(other.reads());
                        intervals.guards.open.insert((at, input), sources);
                    }
                }
            }
        }
        self.outputs(definition, overload, at, &arriving)
    }

    /// What an implied node yields first, with all its defaults.
    fn implied(&mut self, node_type: NodeType) -> Vec<Value> {
        if let Some(known) = self.implied.get(&node_type) {
            return known.clone();
        }
        let definition = self.draft.library.definition(node_type);
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
                let inputs: Vec<Word> = arriving.words.iter().map(|value| value.word).collect();
                let mut sets = vec![Word::UNKNOWN; code.outputs];
                (code.intervals)(&inputs, &mut sets);
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
            (Kind::Request(_) | Kind::LightLoop, _) => {
                self.declared(definition, overload, &mut words)
            }
            (Kind::Plain, None) => {
                for output in &signature.outputs {
                    given::unknown(of_overload(output.value_type, overload), &mut words);
                }
            }
        }
        for (word, value) in words.iter_mut().enumerate() {
            *value = value.named(name_of("output", at, word));
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
