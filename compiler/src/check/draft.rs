//! A graph as far as its names are resolved: what the passes of the checker work on.

use std::cell::{Cell, RefCell};
use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use crate::diagnostics::shortened;
use crate::document::{Member, Value};
use crate::graph::{Parameter, RootKind};
use crate::nodes::{NodeLibrary, NodeType};
use crate::values::Type;

use super::expressions::Rewritten;
use super::limits::MAX_NODES;
use super::nested::Nested;
use super::node_types::NodeTypes;
use super::shape::{Shape, element_name};
use super::splits::Splits;
use super::turns::written_name;

/// The names of a graph, and their types as far as they are known.
pub(super) struct Draft<'d> {
    /// The types its nodes may have.
    pub node_types: NodeTypes<'d>,
    /// The phenomena used, by file as written; none where a file cannot be used.
    pub phenomena: HashMap<&'d str, Option<NodeType>>,
    /// The same of the file itself, by name; those alone that are used.
    pub inner: HashMap<&'d str, Option<NodeType>>,
    /// What they are, by node type.
    pub nested: HashMap<NodeType, Rc<Nested>>,
    /// How many phenomena are within one another here, itself included.
    pub depth: usize,
    pub parameters: Vec<DraftParameter<'d>>,
    pub nodes: Vec<DraftNode<'d>>,
    pub roots: Vec<DraftRoot<'d>>,
    pub outputs: Vec<DraftOutput<'d>>,
    /// Parts of the interface by name: `tint`, `layers[2].tint`.
    pub parameter_names: HashMap<String, usize>,
    /// How many more values lists and arrays may give to nodes.
    pub values_left: Cell<usize>,
    /// What takes values apart of which a component is connected, once inputs are bound.
    pub splits: RefCell<Splits>,
    /// Bytes of the texts all of them keep: elements of an array have each their own.
    pub part_bytes: usize,
    /// Arrays and structs of the interface, and those within them.
    pub compounds: Vec<(String, Shape)>,
    pub compound_names: HashMap<String, usize>,
    pub node_names: HashMap<&'d str, usize>,
    /// Whether something was left out that may have held connections: a second `nodes`, a root of
    /// unknown type.
    pub unresolved: Cell<bool>,
    /// What became of the file's expressions, where it has some.
    pub written: Option<&'d Rewritten>,
}

/// An interface parameter, or a part of one.
pub(super) struct DraftParameter<'d> {
    /// Where it is declared; elements of an array share that.
    pub member: &'d Member,
    pub name: String,
    /// None where the file does not say it understandably.
    pub value_type: Option<Type>,
    /// None where something of it is wrong.
    pub parameter: Option<Parameter>,
}

/// A node.
pub(super) struct DraftNode<'d> {
    pub member: &'d Member,
    /// None where there is no such type.
    pub node_type: Option<NodeType>,
    pub inputs: Vec<DraftInput<'d>>,
}

/// An input that is given.
pub(super) struct DraftInput<'d> {
    pub member: &'d Member,
    /// Position in the signature; none where it has no such input. Several have the same where it
    /// takes a list.
    pub input: Option<usize>,
    pub source: Source<'d>,
}

/// A root.
pub(super) struct DraftRoot<'d> {
    pub kind: RootKind,
    pub member: &'d Member,
    /// The shaders of its list, one where there is no list; none where it is not understood.
    pub colors: Vec<Source<'d>>,
    pub ok: Option<Source<'d>>,
}

impl<'d> DraftRoot<'d> {
    /// All it reads.
    pub fn sources(&self) -> impl Iterator<Item = &Source<'d>> {
        self.colors.iter().chain(&self.ok)
    }
}

/// An output.
pub(super) struct DraftOutput<'d> {
    pub member: &'d Member,
    /// None where the file does not say it understandably.
    pub value_type: Option<Type>,
    pub doc: String,
    pub source: Source<'d>,
}

/// Where a value comes from.
#[derive(Clone, Copy)]
pub(super) struct Source<'d> {
    pub value: &'d Value,
    pub kind: SourceKind,
    /// The component alone that is taken of it: `y` of a vector, `r` of a color.
    pub component: Option<char>,
}

impl<'d> Source<'d> {
    /// A source as a whole.
    pub fn new(value: &'d Value, kind: SourceKind) -> Self {
        Self { value, kind, component: None }
    }
}

/// What kind of source it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum SourceKind {
    /// Something already reported: nothing more is said of it.
    Broken,
    /// A literal; whether it suits is seen when the type is known.
    Literal,
    /// An interface parameter, or a part of one.
    Parameter(usize),
    /// An array or a struct of the interface.
    Compound(usize),
    /// An output of a node; none where it is not known which.
    Node(usize, Option<usize>),
}

impl<'d> Draft<'d> {
    /// A graph of which nothing is known yet.
    pub fn new(library: &'d NodeLibrary, unresolved: bool) -> Self {
        Self {
            node_types: NodeTypes::of(library),
            phenomena: HashMap::new(),
            inner: HashMap::new(),
            nested: HashMap::new(),
            depth: 1,
            parameters: Vec::new(),
            nodes: Vec::new(),
            roots: Vec::new(),
            outputs: Vec::new(),
            parameter_names: HashMap::new(),
            values_left: Cell::new(MAX_NODES),
            splits: RefCell::default(),
            part_bytes: 0,
            compounds: Vec::new(),
            compound_names: HashMap::new(),
            node_names: HashMap::new(),
            unresolved: Cell::new(unresolved),
            written: None,
        }
    }

    /// The name of a node.
    pub fn name(&self, node: usize) -> &'d str {
        &self.nodes[node].member.key
    }

    /// All that the phenomenon is called for: what its roots and outputs read.
    pub fn called(&self) -> impl Iterator<Item = &Source<'d>> {
        let outputs = self.outputs.iter().map(|output| &output.source);
        self.roots.iter().flat_map(DraftRoot::sources).chain(outputs)
    }

    /// The nodes, with their outputs, that an output of a node may read. Of a phenomenon these are
    /// given to parameters on which the output depends; none of them is left out where it is not
    /// known which output is meant.
    pub fn reads_for(
        &self,
        node: usize,
        output: Option<usize>,
    ) -> impl Iterator<Item = (usize, Option<usize>)> {
        let nested = self.nodes[node].node_type.and_then(|it| self.nested.get(&it));
        let is_read = move |input: &DraftInput<'_>| match (nested, output, input.input) {
            (Some(nested), Some(output), Some(input)) => nested.reads(output, input),
            _ => true,
        };
        let inputs = self.nodes[node].inputs.iter();
        inputs.filter(move |input| is_read(input)).filter_map(|input| match input.source.kind {
            SourceKind::Node(source, output) => Some((source, output)),
            _ => None,
        })
    }

    /// The nodes that are evaluated for sources, each once, but phenomena once for each of their outputs
    /// that is read.
    pub fn evaluated<'s>(
        &self,
        sources: impl Iterator<Item = &'s Source<'d>>,
    ) -> Vec<(usize, Option<usize>)>
    where
        'd: 's,
    {
        let mut pending: Vec<(usize, Option<usize>)> = sources
            .filter_map(|source| match source.kind {
                SourceKind::Node(node, output) => Some((node, output)),
                _ => None,
            })
            .collect();
        let mut plain = vec![false; self.nodes.len()];
        let mut outputs = HashSet::new();
        let mut found = Vec::new();
        while let Some((node, output)) = pending.pop() {
            let node_type = self.nodes[node].node_type;
            let is_new = match node_type.is_some_and(|it| self.nested.contains_key(&it)) {
                true => outputs.insert((node, output)),
                false => !std::mem::replace(&mut plain[node], true),
            };
            if is_new {
                found.push((node, output));
                pending.extend(self.reads_for(node, output));
            }
        }
        found
    }

    /// What findings call a node: "node `shade` (mix)", or the operator it was written for.
    pub fn described(&self, node: usize) -> String {
        let node_type = self.nodes[node].node_type;
        let kind = node_type.map_or("", |it| &*self.node_types.signature(it).name);
        let name = self.name(node);
        match self.written.and_then(|written| written.texts.get(name)) {
            Some(text) if text.mark == kind => format!("`{kind}`"),
            Some(text) => format!("`{}` ({kind})", shortened(&text.mark)),
            None => format!("node `{}` ({kind})", self.told_name(node)),
        }
    }

    /// What findings call an output of a node, or the part of an expression that it is.
    pub fn described_output(&self, node: usize, output: usize) -> String {
        let name = self.name(node);
        if let Some(text) = self.written.and_then(|written| written.texts.get(name)) {
            return format!("`{}`", shortened(&text.whole));
        }
        let node_type = self.nodes[node].node_type;
        let output =
            node_type.map_or("", |it| &*self.node_types.signature(it).outputs[output].name);
        format!("output `{output}` of node `{}`", self.told_name(node))
    }

    /// What a node is called in the file, for messages: a turn as its map or fold is.
    pub fn told_name(&self, node: usize) -> String {
        shortened(written_name(self.name(node)))
    }

    /// The nodes a name stands for: one, or the turns of a map.
    pub fn nodes_named(&self, name: &str) -> impl Iterator<Item = usize> {
        let one = self.node_names.get(name).copied();
        let turn = move |at| self.node_names.get(element_name(name, at).as_str()).copied();
        let first = if one.is_some() { one } else { turn(0) };
        first.into_iter().chain((1..).map_while(move |at| turn(at).filter(|_| one.is_none())))
    }

    /// Whether a node was written out of an expression.
    pub fn is_written(&self, name: &str) -> bool {
        self.written.is_some_and(|written| written.texts.contains_key(name))
    }

    /// The nodes a node reads, known and unknown inputs alike.
    pub fn reads(&self, node: usize) -> impl Iterator<Item = (usize, &DraftInput<'d>)> {
        self.nodes[node].inputs.iter().filter_map(|input| match input.source.kind {
            SourceKind::Node(source, _) => Some((source, input)),
            _ => None,
        })
    }
}
