//! One point at which a graph is evaluated.

use phenomenon_compiler::engine::{Options, Shade, Shaded};
use phenomenon_compiler::graph::{Binding, Graph, RootKind};
use phenomenon_compiler::state::Place;
use phenomenon_compiler::values::Literal;
use phenomenon_runtime::link::{NodePath, ShowNodeError};
use phenomenon_runtime::render::EmptyScene;

use super::values::Evaluation;
use crate::failure::Failure;
use crate::graphs;

/// What a graph is evaluated with.
pub struct Point<'a> {
    /// Values for its parameters.
    pub values: &'a [(String, Literal)],
    /// What runs it.
    pub options: Options,
    /// The point.
    pub place: Place,
}

impl Point<'_> {
    /// The value of a root.
    ///
    /// # Errors
    /// The graph has no such root, or cannot be run.
    pub fn root(&self, graph: &Graph, kind: RootKind) -> Result<Evaluation, Failure> {
        let Some(root) = graph.root(kind) else {
            let names: Vec<&str> = graph.roots.iter().map(|root| root.kind.name()).collect();
            let help = match names.as_slice() {
                [] => "it has outputs alone; `--node` evaluates one of them, or a node".into(),
                names => format!("its roots: {}; `--node` evaluates a node", names.join(", ")),
            };
            let message = format!("--root {}: `{}` has no such root", kind.name(), graph.name);
            return Err(Failure::new(message, help));
        };
        let name = match &root.color {
            Binding::Node { node, output } => self.name(graph, *node, *output),
            _ => format!("root.{}", kind.name()),
        };
        let mut alone = graph.clone();
        alone.roots.retain(|root| root.kind == kind);
        let shaded = self.shade(alone, kind)?;
        let mut evaluation = Evaluation::default();
        evaluation.add(name, kind.value_type(), shaded.color);
        evaluation.ok = Some(shaded.ok);
        Ok(evaluation)
    }

    /// The values of a node.
    ///
    /// # Errors
    /// The graph has no such node, it has no value, or it cannot be run.
    pub fn node(&self, graph: &Graph, path: &NodePath) -> Result<Evaluation, Failure> {
        if let Some(output) = path.find_output(graph) {
            return self.output(graph, output);
        }
        let (node, output) = path.find(graph).map_err(|error| {
            graphs::not_shown(&ShowNodeError::Missing { path: path.clone(), error })
        })?;
        let signature = graph.library.signature(graph.nodes[node].node_type);
        let outputs = match output {
            Some(output) => output..output + 1,
            None => 0..signature.outputs.len(),
        };
        let mut evaluation = Evaluation::default();
        for output in outputs {
            let mut alone =
                graph.with_root(node, output).map_err(|error| graphs::not_shown(&error.into()))?;
            alone.roots.retain(|root| root.kind == RootKind::Material);
            let shaded = self.shade(alone, RootKind::Material)?;
            let value_type = graph.output_type(node, output);
            evaluation.add(self.name(graph, node, output), value_type, shaded.color);
        }
        Ok(evaluation)
    }

    /// The value of an output of the phenomenon.
    fn output(&self, graph: &Graph, at: usize) -> Result<Evaluation, Failure> {
        let mut alone = graph.with_output(at).map_err(|error| graphs::not_shown(&error.into()))?;
        alone.roots.retain(|root| root.kind == RootKind::Material);
        let shaded = self.shade(alone, RootKind::Material)?;
        let mut evaluation = Evaluation::default();
        let output = &graph.outputs[at];
        evaluation.add(output.name.clone(), output.value_type, shaded.color);
        Ok(evaluation)
    }

    fn name(&self, graph: &Graph, node: usize, output: usize) -> String {
        let node = &graph.nodes[node];
        let outputs = &graph.library.signature(node.node_type).outputs;
        format!("{}.{}", node.name, outputs[output].name)
    }

    fn shade(&self, graph: Graph, kind: RootKind) -> Result<Shaded, Failure> {
        let shader = graphs::compile(graph, self.values, self.options)?;
        let mut results = [Shaded::default()];
        let mut scene = EmptyScene::new(&shader, self.place)
            .map_err(|error| Failure::new(error, "mend the file, or name another"))?;
        shader.shade(kind, &[self.place.state], &mut scene, &mut results);
        shader.jit_failure().map_or(Ok(results[0]), |error| Err(graphs::jit_failed(error)))
    }
}
