//! The definition of shading, followed word for word and slowly: inputs are evaluated when demanded,
//! each node at most once in each of its epochs. Written from the graph alone, it shares node bodies
//! with the engines and nothing else.

use std::collections::HashMap;

use phenomenon_compiler::effects::{
    Answer, Asked, Effect, LightList, LightSample, Ray, Renderer, Trace,
};
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::graph::{Binding, Graph, Node, Root};
use phenomenon_compiler::nodes::{DefaultValue, Kind, NodeLibrary, Output};
use phenomenon_compiler::specialise::mix_key;
use phenomenon_compiler::state::{Field, State};
use phenomenon_compiler::values::{Literal, Type};

use crate::reads::{self, Fields};

/// Position in the tree of surroundings; 0 is the point itself.
type SurroundingsId = usize;

/// What a scope or an iteration of a loop puts round its inside.
struct Surroundings {
    outside: SurroundingsId,
    changes: Fields,
    /// Name of the scope or loop.
    name: String,
    inside_of: Inside,
}

enum Inside {
    Point,
    /// The scope's node; its changed fields are computed when first read.
    Scope {
        node: usize,
        fields: Option<Vec<(Field, Vec<u32>)>>,
    },
    Iteration {
        list: LightList,
        number: usize,
        sample: LightSample,
    },
}

/// Evaluates roots of a graph.
pub struct Naive<'a> {
    library: &'a NodeLibrary,
    /// The nodes of the graph, then those that inputs imply.
    nodes: Vec<Node>,
    implied: HashMap<&'static str, usize>,
    reads: Vec<Option<Fields>>,
    parameters: Vec<Literal>,
}

/// Evaluation took more steps than allowed.
#[derive(Debug, PartialEq, Eq)]
pub struct TooLong;

impl<'a> Naive<'a> {
    /// With values for parameters, of their types.
    pub fn new(graph: &'a Graph, library: &'a NodeLibrary, values: &[(String, Literal)]) -> Self {
        let mut parameters: Vec<Literal> =
            graph.parameters.iter().map(|parameter| parameter.default.clone()).collect();
        for (name, value) in values {
            let at = graph.parameter(name).expect("values are of parameters of the graph");
            parameters[at] = value.clone();
        }
        let mut nodes = graph.nodes.clone();
        let mut implied = HashMap::new();
        let mut at = 0;
        while at < nodes.len() {
            let node = nodes[at].clone();
            let inputs = &library.signature(node.node_type).inputs;
            for (input, binding) in inputs.iter().zip(&node.inputs) {
                if let (DefaultValue::Node(name), Binding::Default) = (&input.default, binding) {
                    implied.entry(*name).or_insert_with(|| {
                        nodes.push(reads::implied(library, name));
                        nodes.len() - 1
                    });
                }
            }
            at += 1;
        }
        let mut naive =
            Self { library, reads: vec![None; nodes.len()], nodes, implied, parameters };
        for node in 0..naive.nodes.len() {
            naive.settle_reads(node);
        }
        naive
    }

    fn settle_reads(&mut self, node: usize) {
        if self.reads[node].is_some() {
            return;
        }
        for binding in self.nodes[node].inputs.clone() {
            if let Binding::Node { node, .. } = binding {
                self.settle_reads(node);
            }
        }
        let of_output = |source: usize, output: usize| {
            let whole = self.reads[source].clone().unwrap_or_default();
            reads::of_output(self.library, &self.nodes[source], output, &whole)
        };
        self.reads[node] = Some(reads::of_node(self.library, &self.nodes[node], &of_output));
    }

    /// Shades one point, in at most so many evaluations.
    pub fn shade(
        &self,
        root: &Root,
        point: &State,
        renderer: &mut dyn Renderer,
        steps: &mut usize,
    ) -> Result<Shaded, TooLong> {
        let point_itself = Surroundings {
            outside: 0,
            changes: Fields::new(),
            name: String::new(),
            inside_of: Inside::Point,
        };
        let mut evaluation = Evaluation {
            naive: self,
            point,
            renderer,
            surroundings: vec![point_itself],
            kept: HashMap::new(),
            light_colors: HashMap::new(),
            steps,
        };
        let ok = match &root.ok {
            Binding::Default => vec![u32::MAX],
            given => evaluation.given(given, Type::Boolean, 0)?,
        };
        if ok[0] == 0 {
            return Ok(Shaded { color: [0.0; 4], ok: false });
        }
        let color = match &root.color {
            Binding::Default => Literal::Color([0.0, 0.0, 0.0, 1.0]).words(),
            given => evaluation.given(given, Type::Color, 0)?,
        };
        Ok(Shaded { color: std::array::from_fn(|at| f32::from_bits(color[at])), ok: true })
    }

    fn value_type(&self, node: &Node, of: Type) -> Type {
        let generic = self.library.definition(node.node_type).overloads[node.overload].generic;
        if of == Type::Generic { generic.unwrap_or(of) } else { of }
    }
}

struct Evaluation<'a> {
    naive: &'a Naive<'a>,
    point: &'a State,
    renderer: &'a mut dyn Renderer,
    surroundings: Vec<Surroundings>,
    kept: HashMap<(usize, SurroundingsId), Vec<u32>>,
    light_colors: HashMap<(LightList, usize, SurroundingsId), [f32; 3]>,
    steps: &'a mut usize,
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
        for part in effect.answers().iter().take_while(|part| part.name != output.name) {
            first += part.value_type.width();
        }
        words.extend(&answer[first..first + output.value_type.width()]);
    }
    words
}

impl Evaluation<'_> {
    /// The value of a binding that is not a default.
    fn given(
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

    fn input(
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
            DefaultValue::Literal(Literal::Scalar(x)) if to == Type::Vector => {
                Ok(vec![x.to_bits(); 3])
            }
            DefaultValue::Literal(literal) => {
                Ok(converted(literal.words(), literal.value_type(), to))
            }
            DefaultValue::State(field) => {
                Ok(converted(self.field(*field, at)?, field.value_type(), to))
            }
            DefaultValue::Node(name) => self.output(naive.implied[name], 0, to, at),
            DefaultValue::Required => panic!("random graphs bind required inputs"),
        }
    }

    fn output(
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
    fn effective(&self, mut at: SurroundingsId, fields: &Fields) -> SurroundingsId {
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
            Inside::Point => Ok(field.read(self.point)[..width].to_vec()),
            Inside::Iteration { sample, .. } if field == Field::LightDistance => {
                Ok(vec![sample.distance.to_bits()])
            }
            Inside::Iteration { sample, .. } => Ok(sample.direction.map(f32::to_bits).to_vec()),
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
                    Asked::Texels => self.read_texture(node, at)?,
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
            Kind::LightLoop => self.light_loop(node, at)?,
            Kind::Fields(_) => unreachable!("fields are read, not evaluated"),
            Kind::List(_) => unreachable!("the checker makes other nodes of it"),
        };
        self.kept.insert((node, at), words.clone());
        Ok(words)
    }

    fn open(&mut self, node: usize, outside: SurroundingsId, inside_of: Inside) -> SurroundingsId {
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
        let mut words = vec![0; widths.iter().sum()];
        let mut first = 0;
        for (input, declared) in definition.signature.inputs.iter().enumerate() {
            let holds = overload.guards[input].is_none_or(|guard| {
                let mut outcome = [0];
                (guard.scalar)(&words, &mut outcome);
                outcome[0] != 0
            });
            if holds && !declared.scoped && !declared.value_type.is_in_code() {
                let value = self.input(node, input, at)?;
                words[first..first + widths[input]].copy_from_slice(&value);
            }
            first += widths[input];
        }
        let code = overload.code.expect("plain nodes and scopes have bodies");
        let mut outputs = vec![0; code.outputs];
        (code.scalar)(&words, &mut outputs);
        Ok(outputs)
    }

    /// The state of the point with the given fields as they are in the surroundings.
    fn state(&mut self, fields: &[Field], at: SurroundingsId) -> Result<State, TooLong> {
        let mut state = *self.point;
        for &field in fields {
            let mut words = self.field(field, at)?;
            words.resize(4, 0);
            field.write(&mut state, [words[0], words[1], words[2], words[3]]);
        }
        Ok(state)
    }

    fn trace(
        &mut self,
        node: usize,
        trace: Trace,
        at: SurroundingsId,
    ) -> Result<Vec<u32>, TooLong> {
        let mut words = Vec::new();
        for input in 0..self.naive.nodes[node].inputs.len() {
            words.extend(self.input(node, input, at)?);
        }
        let state = self.state(Effect::from(trace).reads(), at)?;
        let vector = |from: usize| std::array::from_fn(|k| f32::from_bits(words[from + k]));
        let (origin, direction) = match trace {
            Trace::Transparent => (state.point, state.direction),
            Trace::Probe => (vector(3), vector(0)),
            _ => (state.point, vector(0)),
        };
        let site = self.site(&self.naive.nodes[node].name, at);
        let mut answers = [Answer::default()];
        self.renderer.trace(trace, &[Ray { state, origin, direction, site }], &mut answers);
        let [Answer { color, ok, hit, distance }] = answers;
        let truth = |value: bool| if value { u32::MAX } else { 0 };
        let [r, g, b, a] = color.map(f32::to_bits);
        Ok(vec![r, g, b, a, truth(ok), truth(hit), distance.to_bits()])
    }

    fn read_texture(&mut self, node: usize, at: SurroundingsId) -> Result<Vec<u32>, TooLong> {
        let naive = self.naive;
        let of = &naive.nodes[node];
        let given = of.inputs.iter().find_map(|binding| match binding {
            Binding::Literal(Literal::Texture(texture)) => Some(texture),
            Binding::Parameter(parameter) => match &naive.parameters[*parameter] {
                Literal::Texture(texture) => Some(texture),
                _ => None,
            },
            _ => None,
        });
        let Some(Some(texture)) = given else { return Ok(vec![0; 5]) };
        let texture = self.renderer.texture(texture);
        let mut coordinates = [0.0; 2];
        for (k, coordinate) in coordinates.iter_mut().enumerate() {
            *coordinate = f32::from_bits(self.input(node, k + 1, at)?[0]);
        }
        let mut colors = [None];
        self.renderer.read_texture(texture, &[coordinates], &mut colors);
        let [r, g, b, a] = colors[0].unwrap_or_default().map(f32::to_bits);
        Ok(vec![r, g, b, a, if colors[0].is_some() { u32::MAX } else { 0 }])
    }

    /// Surroundings from the outermost to `at`.
    fn way_to(&self, mut at: SurroundingsId) -> Vec<SurroundingsId> {
        let mut way = Vec::new();
        while at != 0 {
            way.push(at);
            at = self.surroundings[at].outside;
        }
        way.reverse();
        way
    }

    /// The key of a request: the hash of its path of names, with the iterations round it.
    fn site(&self, name: &str, at: SurroundingsId) -> u64 {
        let way = self.way_to(at);
        let names = way.iter().map(|&of| self.surroundings[of].name.as_str());
        let path: Vec<&str> = names.chain([name]).collect();
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        for byte in path.join("/").bytes() {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
        let mut key = mix_key(hash);
        for of in way {
            if let Inside::Iteration { number, .. } = self.surroundings[of].inside_of {
                key = mix_key(key ^ mix_key(number as u64 + 1));
            }
        }
        key
    }

    fn light_color(&mut self, at: SurroundingsId) -> Result<Vec<u32>, TooLong> {
        let innermost = self.way_to(at).into_iter().rev().find_map(|of| {
            match self.surroundings[of].inside_of {
                Inside::Iteration { list, number, sample } => {
                    Some((of, list, number, sample.token))
                }
                Inside::Point | Inside::Scope { .. } => None,
            }
        });
        let (iteration, list, number, token) =
            innermost.expect("random graphs ask inside loops only");
        let outside = self.surroundings[iteration].outside;
        let shared = self.effective(outside, &[Field::Point, Field::NormalGeom].into());
        let color = match self.light_colors.get(&(list, number, shared)) {
            Some(color) => *color,
            None => {
                let state = self.state(&[Field::Point, Field::NormalGeom], at)?;
                let mut colors = [[0.0; 3]];
                self.renderer.light_colors(&[state], &[token], &mut colors);
                self.light_colors.insert((list, number, shared), colors[0]);
                colors[0]
            }
        };
        let [r, g, b] = color.map(f32::to_bits);
        Ok(vec![r, g, b, 1.0_f32.to_bits()])
    }

    fn light_loop(&mut self, node: usize, at: SurroundingsId) -> Result<Vec<u32>, TooLong> {
        let naive = self.naive;
        let of = &naive.nodes[node];
        let inputs = &naive.library.signature(of.node_type).inputs;
        let lights = inputs.iter().position(|input| input.value_type == Type::Lights);
        let names = match lights.map(|input| &of.inputs[input]) {
            Some(Binding::Literal(Literal::Lights(names))) => names.clone(),
            Some(Binding::Parameter(parameter)) => match &naive.parameters[*parameter] {
                Literal::Lights(names) => names.clone(),
                Literal::Light(name) => vec![name.clone()],
                other => panic!("{other:?} for lights"),
            },
            _ => Vec::new(),
        };
        let body = inputs.iter().position(|input| input.scoped).expect("a loop has a body");
        let list = self.renderer.light_list(&names);
        let state = self.state(&[Field::Point, Field::NormalGeom], at)?;
        let mut sum = [0.0_f32; 3];
        for number in 0..self.renderer.light_count(list) {
            let mut samples = [LightSample::default()];
            self.renderer.light_samples(list, number, &[state], &mut samples);
            let [sample] = samples;
            if sample.reachable {
                let inside = self.open(node, at, Inside::Iteration { list, number, sample });
                let color = self.input(node, body, inside)?;
                for (sum, word) in sum.iter_mut().zip(color) {
                    *sum += f32::from_bits(word);
                }
            }
        }
        let [r, g, b] = sum.map(f32::to_bits);
        Ok(vec![r, g, b, 1.0_f32.to_bits()])
    }
}
