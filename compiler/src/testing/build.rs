//! Graphs written by hand, node by node.

use std::sync::Arc;

use crate::engine::jit::Generator;
use crate::engine::{Engine, Options, Shade, Shaded, Shader, Simd};
use crate::graph::{Binding, Graph, Node, Parameter, Root, RootKind};
use crate::nodes::NodeLibrary;
use crate::state::State;
use crate::values::{Literal, Name, Type};

use super::differential::{Agreement, Case};
use super::mock::MockRenderer;
use super::random::Random;

/// A graph in the making.
#[derive(Clone, Debug)]
pub struct Build {
    graph: Graph,
}

/// A number.
pub fn scalar(value: f32) -> Binding {
    Binding::Literal(Literal::Scalar(value))
}

/// A color.
pub fn color(value: [f32; 4]) -> Binding {
    Binding::Literal(Literal::Color(value))
}

/// A vector.
pub fn vector(value: [f32; 3]) -> Binding {
    Binding::Literal(Literal::Vector(value))
}

impl Build {
    /// Nothing yet, of the standard nodes.
    pub fn new() -> Self {
        Self::with(NodeLibrary::standard())
    }

    /// Nothing yet, of the nodes of a library.
    pub fn with(library: NodeLibrary) -> Self {
        let graph = Graph { library, name: "built".to_owned(), ..Graph::default() };
        Self { graph }
    }

    /// Adds a parameter of the interface.
    pub fn parameter(&mut self, name: &str, default: Literal) -> Binding {
        self.graph.parameters.push(Parameter::new(name, default));
        Binding::Parameter(self.graph.parameters.len() - 1)
    }

    /// Adds a node; inputs not given keep their defaults. A generic node takes colours.
    pub fn node(&mut self, node_type: &str, inputs: &[(&str, Binding)]) -> Made {
        self.node_of(node_type, Type::Color, inputs)
    }

    /// Adds a node, a generic one in the form for `generic`.
    ///
    /// # Panics
    /// If there is no such node type, input or form.
    pub fn node_of(&mut self, node_type: &str, generic: Type, inputs: &[(&str, Binding)]) -> Made {
        let found = self.graph.library.find(node_type).expect("a node type");
        let definition = self.graph.library.definition(found);
        let overload = definition
            .overloads
            .iter()
            .position(|overload| overload.generic.is_none_or(|of| of == generic))
            .expect("a form of the node");
        let mut bindings = vec![Binding::Default; definition.signature.inputs.len()];
        for (name, binding) in inputs {
            bindings[definition.signature.input(name).expect("an input")] = binding.clone();
        }
        let outputs =
            definition.signature.outputs.iter().map(|output| output.name.clone()).collect();
        let at = self.graph.nodes.len();
        let name = format!("{node_type}_{at}");
        self.graph.nodes.push(Node { name, node_type: found, overload, inputs: bindings });
        Made { at, outputs }
    }

    /// The graph with a material root.
    pub fn material(self, color: Binding) -> Built {
        self.material_where(color, Binding::Default)
    }

    /// The graph with a material root that may fail.
    pub fn material_where(mut self, color: Binding, ok: Binding) -> Built {
        self.graph.roots.push(Root { kind: RootKind::Material, color, ok });
        Built { graph: Arc::new(self.graph) }
    }
}

impl Default for Build {
    fn default() -> Self {
        Self::new()
    }
}

/// A node that was added.
#[derive(Clone, Debug)]
pub struct Made {
    at: usize,
    outputs: Vec<Name>,
}

impl Made {
    /// Its first output.
    pub fn first(&self) -> Binding {
        Binding::Node { node: self.at, output: 0 }
    }

    /// An output by name.
    ///
    /// # Panics
    /// If there is none.
    pub fn output(&self, name: &str) -> Binding {
        let output = self.outputs.iter().position(|output| **output == *name);
        Binding::Node { node: self.at, output: output.expect("an output") }
    }
}

/// A graph that was built.
#[derive(Clone, Debug)]
pub struct Built {
    /// The graph.
    pub graph: Arc<Graph>,
}

/// Every engine, with both forms of the bodies, both generators of machine code, and several batch sizes.
pub fn every_engine() -> Vec<Options> {
    let mut all = Vec::new();
    for simd in [Simd::Native, Simd::Portable] {
        all.push(Options { engine: Engine::Walk, simd, batch: 256, ..Options::default() });
        all.push(Options { engine: Engine::Auto, simd, batch: 256, ..Options::default() });
        for batch in [1, 7, 256] {
            all.push(Options { engine: Engine::Batch, simd, batch, ..Options::default() });
            for generator in Generator::ALL {
                let generator = Some(generator);
                all.push(Options {
                    engine: Engine::Jit,
                    simd,
                    generator,
                    batch,
                    ..Options::default()
                });
            }
        }
    }
    all
}

impl Built {
    /// Compiles it.
    ///
    /// # Panics
    /// If that fails.
    pub fn shader(&self, values: &[(String, Literal)], options: Options) -> Shader {
        Shader::new(Arc::clone(&self.graph), values, options).expect("the graph compiles")
    }

    /// What came of it at random points, in all engines and by the definition, which agree.
    ///
    /// # Panics
    /// If they do not, or if the graph was too large to be run.
    pub fn agree(&self, seed: u64) -> Agreement {
        self.agree_at(Random::new(seed).states(33))
    }

    /// The same at these points, which are of one ray type.
    ///
    /// # Panics
    /// As [`Self::agree`] does.
    pub fn agree_at(&self, points: Vec<State>) -> Agreement {
        let graph = Arc::clone(&self.graph);
        let options = every_engine();
        let case = Case { graph, values: Vec::new(), points, options, naive: true };
        let agreement = case.check().unwrap_or_else(|error| panic!("{error}"));
        assert!(agreement.ran && agreement.naive, "the graph is too large");
        agreement
    }

    /// Shades `points` in every engine with a clone of `renderer` and shows what came of it.
    pub fn in_every_engine(
        &self,
        values: &[(String, Literal)],
        points: &[State],
        renderer: &MockRenderer,
        mut look: impl FnMut(&str, &MockRenderer, &[Shaded]),
    ) {
        for options in every_engine() {
            let shader = self.shader(values, options);
            let mut renderer = renderer.clone();
            let mut results = vec![Shaded::default(); points.len()];
            shader.shade(RootKind::Material, points, &mut renderer, &mut results);
            look(&format!("{options:?}"), &renderer, &results);
        }
    }
}
