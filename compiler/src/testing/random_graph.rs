//! Random graphs that the checker would accept, drawn from whatever the library holds.
//!
//! Nodes are made sources first and shuffled at the end. Sharing is heavy, guards hang on traces, and
//! what reads a turn of a loop is demanded below such loops only.

use crate::graph::{Binding, Graph, Node, Parameter, Root, RootKind};
use crate::nodes::{
    DefaultValue, Definition, FINITE, Input, Kind, NodeLibrary, NodeType, Signature,
};
use crate::state::Iterated;
use crate::values::{Literal, Type};

use super::random::Random;
use super::reads::{self, Fields};

/// Most loops inside loops: each multiplies the work.
const MOST_NESTED_LOOPS: usize = 3;

/// A random graph of about `size` nodes, and values for some of its parameters.
pub fn random_graph(
    random: &mut Random,
    library: &NodeLibrary,
    size: usize,
) -> (Graph, Vec<(String, Literal)>) {
    Growing::new(random, library).grown(size, None)
}

/// The same with a node type that every fourth node is of, or so.
pub fn random_graph_of(
    random: &mut Random,
    library: &NodeLibrary,
    size: usize,
    node_type: NodeType,
) -> (Graph, Vec<(String, Literal)>) {
    Growing::new(random, library).grown(size, Some(node_type))
}

/// A value of some parameter or other: of the right type and within its range, else as hard as literals
/// are. None where none was found soon.
pub fn random_value(random: &mut Random, graph: &Graph) -> Option<(String, Literal)> {
    if graph.parameters.is_empty() {
        return None;
    }
    let parameter = &graph.parameters[random.below(graph.parameters.len())];
    let mut tries = (0..50).map(|_| random.literal(parameter.value_type));
    let value = tries.find(|value| graph.bind_literal(&parameter.name, value).is_ok())?;
    Some((parameter.name.clone(), value))
}

struct Growing<'a> {
    random: &'a mut Random,
    library: &'a NodeLibrary,
    /// Node types in classes that are drawn equally often.
    classes: Vec<Vec<NodeType>>,
    parameters: Vec<Parameter>,
    nodes: Vec<Node>,
    facts: Vec<Facts>,
}

/// What is known of a node.
struct Facts {
    outputs: Vec<Type>,
    reads: Fields,
    /// Nodes at and below it, as if nothing were shared.
    below: u64,
    nested_loops: usize,
    /// Whether it or something below asks the renderer.
    asks: bool,
    used: bool,
}

/// Classes of node types; each type may be in several.
fn classes(library: &NodeLibrary) -> Vec<Vec<NodeType>> {
    let of = |wanted: &dyn Fn(&Signature) -> bool| -> Vec<NodeType> {
        // The checker makes other nodes of those over lists.
        let is_list = |signature: &Signature| matches!(signature.kind, Kind::List(_));
        let types = library.iter().filter(|(_, definition)| {
            !is_list(&definition.signature) && wanted(&definition.signature)
        });
        types.map(|(node_type, _)| node_type).collect()
    };
    let guarded = of(&|signature| signature.inputs.iter().any(|input| input.guarded));
    let mut classes = vec![
        of(&|signature| matches!(signature.kind, Kind::Request(_))),
        guarded.clone(),
        guarded,
        of(&|signature| matches!(signature.kind, Kind::Scope(_))),
        of(&|signature| over(signature).is_some()),
        of(&|signature| matches!(signature.kind, Kind::Fields(_))),
        of(&|signature| reads_turn(library, signature)),
        of(&|signature| signature.outputs[0].value_type == Type::Boolean),
        of(&|signature| signature.kind == Kind::Plain),
        of(&|signature| signature.kind == Kind::Plain),
    ];
    classes.retain(|class| !class.is_empty());
    classes
}

/// What a loop runs over.
fn over(signature: &Signature) -> Option<Iterated> {
    match signature.kind {
        Kind::Loop(iterated, _) => Some(iterated),
        _ => None,
    }
}

fn reads_turn(library: &NodeLibrary, signature: &Signature) -> bool {
    let node = reads::implied(library, &signature.name);
    match &signature.kind {
        Kind::Fields(fields) => fields.iter().any(|field| field.of_loop().is_some()),
        _ => is_of_turn(&reads::of_node(library, &node, &|_, _| Fields::new())),
    }
}

/// Whether something that reads these fields belongs below a loop.
pub fn is_of_turn(fields: &Fields) -> bool {
    fields.iter().any(|field| field.of_loop().is_some())
}

/// Whether it belongs below one over these.
fn is_of(iterated: Iterated, fields: &Fields) -> bool {
    fields.iter().any(|field| field.of_loop() == Some(iterated))
}

impl<'a> Growing<'a> {
    fn new(random: &'a mut Random, library: &'a NodeLibrary) -> Self {
        let parameters = (0..random.below(6))
            .map(|at| {
                let value_type = random.pick(&Type::ALL);
                Parameter {
                    name: format!("p{at}"),
                    doc: String::new(),
                    value_type,
                    default: random.literal(value_type),
                    range: FINITE,
                    soft_range: FINITE,
                    unit: String::new(),
                    labels: Vec::new(),
                }
            })
            .collect();
        let classes = classes(library);
        Self { random, library, classes, parameters, nodes: Vec::new(), facts: Vec::new() }
    }

    fn grown(mut self, size: usize, often: Option<NodeType>) -> (Graph, Vec<(String, Literal)>) {
        let takers = often.map_or(Vec::new(), |often| self.takers(often));
        for _ in 0..size {
            let node_type = match often {
                Some(often) if self.random.chance(25) => often,
                _ if !takers.is_empty() && self.random.chance(40) => self.random.pick(&takers),
                _ => {
                    let class = self.random.below(self.classes.len());
                    self.random.pick(&self.classes[class])
                }
            };
            self.add(node_type);
        }
        self.finish()
    }

    /// Nodes that make something else of a transform, for a type that yields nothing else: few take one, and
    /// without them it would seldom reach a root.
    fn takers(&self, node_type: NodeType) -> Vec<NodeType> {
        let is_transform = |value_type: Type| value_type == Type::Transform;
        let outputs = &self.library.signature(node_type).outputs;
        if !outputs.iter().all(|output| is_transform(output.value_type)) {
            return Vec::new();
        }
        let takes = |signature: &Signature| {
            signature.kind == Kind::Plain
                && signature.inputs.iter().any(|input| is_transform(input.value_type))
                && !is_transform(signature.outputs[0].value_type)
        };
        let types = self.library.iter().filter(|(_, definition)| takes(&definition.signature));
        types.map(|(node_type, _)| node_type).collect()
    }

    fn add(&mut self, node_type: NodeType) {
        let definition = self.library.definition(node_type);
        let overload = self.random.below(definition.overloads.len());
        let generic = definition.overloads[overload].generic;
        let settled = |of: Type| if of == Type::Generic { generic.unwrap_or(of) } else { of };
        let signature = &definition.signature;
        let over = over(signature);
        let inputs: Vec<Binding> = signature
            .inputs
            .iter()
            .map(|input| {
                if input.fixed {
                    return self.fixed(input);
                }
                let required = matches!(input.default, DefaultValue::Required);
                let to = settled(input.value_type);
                match over {
                    // Each turn costs.
                    Some(Iterated::Samples) if !input.scoped => {
                        Binding::Literal(Literal::Integer(self.random.below(5) as i32 - 1))
                    }
                    _ => self.binding(to, required, input.scoped, over.filter(|_| input.scoped)),
                }
            })
            .collect();
        let outputs = signature.outputs.iter().map(|output| settled(output.value_type)).collect();
        let node = Node { name: format!("n{}", self.nodes.len()), node_type, overload, inputs };
        let facts = self.facts(&node, outputs, over.is_some());
        self.nodes.push(node);
        self.facts.push(facts);
    }

    fn facts(&mut self, node: &Node, outputs: Vec<Type>, is_loop: bool) -> Facts {
        let mut below = 1_u64;
        let mut nested_loops = 0;
        let kind = &self.library.signature(node.node_type).kind;
        let mut asks = matches!(kind, Kind::Request(_));
        for binding in &node.inputs {
            if let Binding::Node { node, .. } = binding {
                self.facts[*node].used = true;
                below = below.saturating_add(self.facts[*node].below);
                asks |= self.facts[*node].asks;
                nested_loops = nested_loops.max(self.facts[*node].nested_loops);
            }
        }
        let of_output = |source: usize, output: usize| {
            let (node, facts) = (&self.nodes[source], &self.facts[source]);
            reads::of_output(self.library, node, output, &facts.reads)
        };
        let reads = reads::of_node(self.library, node, &of_output);
        nested_loops += usize::from(is_loop);
        Facts { outputs, reads, below, nested_loops, asks, used: false }
    }

    /// What an input known before shading is given: a number in its range.
    fn fixed(&mut self, input: &Input) -> Binding {
        let (least, most) = (*input.range.start() as i32, *input.range.end() as i32);
        match self.random.below(3) {
            0 => Binding::Default,
            _ => {
                let number = least + self.random.below((most - least + 1) as usize) as i32;
                Binding::Literal(Literal::Integer(number))
            }
        }
    }

    fn binding(
        &mut self,
        to: Type,
        required: bool,
        scoped: bool,
        over: Option<Iterated>,
    ) -> Binding {
        if !to.is_uniform() && (scoped || self.random.chance(75)) {
            let mut sources = self.sources(to);
            if let Some(over) = over {
                sources.retain(|(node, _)| self.facts[*node].nested_loops < MOST_NESTED_LOOPS);
                let of_turn = |&(node, _): &(usize, usize)| is_of(over, &self.facts[node].reads);
                let of_turn: Vec<_> = sources.iter().copied().filter(of_turn).collect();
                if !of_turn.is_empty() && self.random.chance(80) {
                    sources = of_turn;
                }
            }
            if let Some((node, output)) = self.preferred(&sources) {
                return Binding::Node { node, output };
            }
        }
        let parameters: Vec<usize> = (0..self.parameters.len())
            .filter(|&at| self.parameters[at].value_type.converts_to(to))
            // Only a node, or another parameter of that type, is a shader.
            .filter(|&at| to != Type::Shader || self.parameters[at].value_type == to)
            .collect();
        match self.random.below(3) {
            0 if !parameters.is_empty() => Binding::Parameter(self.random.pick(&parameters)),
            1 if !required => Binding::Default,
            _ => Binding::Literal(self.random.literal(to)),
        }
    }

    /// Outputs that fit, with the nodes they are of.
    fn sources(&self, to: Type) -> Vec<(usize, usize)> {
        let all = self.facts.iter().enumerate().flat_map(|(node, facts)| {
            let outputs = facts.outputs.iter().enumerate();
            outputs.map(move |(output, from)| (node, output, *from))
        });
        all.filter(|(_, _, from)| from.converts_to(to)).map(|(n, output, _)| (n, output)).collect()
    }

    /// One of `sources`: one that asks the renderer, one nobody uses yet, one of the last, or any.
    fn preferred(&mut self, sources: &[(usize, usize)]) -> Option<(usize, usize)> {
        if sources.is_empty() {
            return None;
        }
        let asking: Vec<_> =
            sources.iter().copied().filter(|(node, _)| self.facts[*node].asks).collect();
        let all = sources;
        let sources = if !asking.is_empty() && self.random.chance(60) { &asking } else { all };
        let unused: Vec<_> =
            sources.iter().copied().filter(|(node, _)| !self.facts[*node].used).collect();
        Some(match self.random.below(10) {
            0..=3 if !unused.is_empty() => self.random.pick(&unused),
            4..=6 => self.random.pick(&sources[sources.len().saturating_sub(6)..]),
            _ => self.random.pick(sources),
        })
    }

    /// What an output reads.
    fn reads(&self, node: usize, output: usize) -> Fields {
        reads::of_output(self.library, &self.nodes[node], output, &self.facts[node].reads)
    }

    /// What a root may take, large trees preferred; a colour that belongs below a loop gets one.
    fn root_source(&mut self, to: Type) -> Option<Binding> {
        let mut sources = self.sources(to);
        if to != Type::Color {
            sources.retain(|&(node, output)| !is_of_turn(&self.reads(node, output)));
        }
        let tries: Vec<_> = (0..6).filter_map(|_| self.preferred(&sources)).collect();
        let best = tries
            .into_iter()
            .max_by_key(|(node, _)| (self.facts[*node].asks, self.facts[*node].below));
        let (mut node, mut output) = best?;
        for iterated in Iterated::ALL {
            if is_of(iterated, &self.reads(node, output)) {
                (node, output) = (self.looped(iterated, Binding::Node { node, output }), 0);
            }
        }
        Some(Binding::Node { node, output })
    }

    /// A loop round a colour.
    fn looped(&mut self, iterated: Iterated, body: Binding) -> usize {
        let mut types = self.library.iter();
        let of_colors = |definition: &Definition| match definition.signature.outputs[0].value_type {
            Type::Color => Some(0),
            Type::Generic => {
                definition.overloads.iter().position(|form| form.generic == Some(Type::Color))
            }
            _ => None,
        };
        let found = types.find_map(|(node_type, definition)| {
            let overload = of_colors(definition)?;
            let fits = over(&definition.signature) == Some(iterated);
            fits.then_some((node_type, definition, overload))
        });
        let (node_type, definition, overload) =
            found.expect("what reads a turn comes with a loop of colours");
        let inputs = definition.signature.inputs.iter();
        let inputs = inputs.map(|input| if input.scoped { body.clone() } else { Binding::Default });
        let inputs = inputs.collect();
        let name = format!("n{}", self.nodes.len());
        let node = Node { name, node_type, overload, inputs };
        let facts = self.facts(&node, vec![Type::Color], true);
        self.nodes.push(node);
        self.facts.push(facts);
        self.nodes.len() - 1
    }

    fn root(&mut self, kind: RootKind) -> Root {
        let color = self
            .root_source(Type::Color)
            .unwrap_or_else(|| Binding::Literal(self.random.literal(Type::Color)));
        let ok = match self.random.below(10) {
            0 => Binding::Literal(Literal::Boolean(self.random.chance(50))),
            1..=4 => self.root_source(Type::Boolean).unwrap_or(Binding::Default),
            _ => Binding::Default,
        };
        Root { kind, color, ok }
    }

    fn finish(mut self) -> (Graph, Vec<(String, Literal)>) {
        let mut roots = vec![self.root(RootKind::Material)];
        if self.random.chance(20) {
            roots.push(self.root(RootKind::Shadow));
        }
        // Position in the file says nothing about who feeds whom.
        let mut place: Vec<usize> = (0..self.nodes.len()).collect();
        for at in (1..place.len()).rev() {
            place.swap(at, self.random.below(at + 1));
        }
        let moved = |binding: &mut Binding| {
            if let Binding::Node { node, .. } = binding {
                *node = place[*node];
            }
        };
        let mut nodes: Vec<Option<Node>> = vec![None; place.len()];
        for (from, mut node) in self.nodes.into_iter().enumerate() {
            node.inputs.iter_mut().for_each(moved);
            nodes[place[from]] = Some(node);
        }
        for root in &mut roots {
            moved(&mut root.color);
            moved(&mut root.ok);
        }
        let nodes = nodes.into_iter().flatten().collect();
        let graph = Graph {
            library: self.library.clone(),
            name: "random".to_owned(),
            parameters: self.parameters,
            nodes,
            roots,
            ..Graph::default()
        };
        let values = (0..3).filter_map(|_| random_value(self.random, &graph)).collect();
        (graph, values)
    }
}
