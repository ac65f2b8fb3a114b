//! Looking at one node: its output as the material of the graph.

use std::collections::HashSet;

use thiserror::Error;

use super::{Binding, Graph, Node, Root, RootKind};
use crate::nodes::{Kind, is_of_turn, reads_turn};
use crate::state::Iterated;
use crate::values::Type;

/// Why an output cannot be a root.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum WithRootError {
    /// The output depends on the light sample, which exists in the body of a loop only.
    #[error(
        "`{node}` reads the light sample and has a value inside a light loop only; \
         choose the loop, or a node outside it"
    )]
    InsideLightLoop {
        /// The node.
        node: String,
    },
    /// The output is uniform: no value at points.
    #[error("output `{output}` of `{node}` is {type_name}, which is no value to look at")]
    NotAValue {
        /// The node.
        node: String,
        /// The output.
        output: String,
        /// Its type.
        type_name: &'static str,
    },
    /// The library lacks a node that makes colours of such values.
    #[error("the node library has no `{name}`, which looking at a {type_name} takes")]
    NoConversion {
        /// The node it takes.
        name: &'static str,
        /// The type of the output.
        type_name: &'static str,
    },
}

impl Graph {
    /// The type of an output of a node, by positions.
    pub fn output_type(&self, node: usize, output: usize) -> Type {
        let Node { node_type, overload, .. } = &self.nodes[node];
        let definition = self.library.definition(*node_type);
        match definition.signature.outputs[output].value_type {
            Type::Generic => definition.overloads[*overload].generic.unwrap_or(Type::Generic),
            other => other,
        }
    }

    /// This graph with an output of a node, by positions, for its material, to look at the node
    /// alone. A number is shown as grey, a vector by its components as red, green and blue, a
    /// truth value as black or white. Other roots stay.
    ///
    /// # Errors
    /// The output has no value outside a light loop, or is no value at all.
    pub fn with_root(&self, node: usize, output: usize) -> Result<Graph, WithRootError> {
        let signature = self.library.signature(self.nodes[node].node_type);
        let names = (&*self.nodes[node].name, &*signature.outputs[output].name);
        self.looked_at(Binding::Node { node, output }, self.output_type(node, output), names)
    }

    /// The same of a value the phenomenon offers, by its position in [`Graph::outputs`].
    ///
    /// # Errors
    /// As for [`Graph::with_root`].
    pub fn with_output(&self, at: usize) -> Result<Graph, WithRootError> {
        let output = &self.outputs[at];
        let value = match &output.value {
            Binding::Literal(literal) if literal.value_type().converts_to(Type::Color) => {
                Binding::Literal(literal.converted_to(Type::Color).unwrap_or(literal.clone()))
            }
            other => other.clone(),
        };
        self.looked_at(value, output.value_type, (&self.name, &output.name))
    }

    fn looked_at(
        &self,
        value: Binding,
        value_type: Type,
        (of, name): (&str, &str),
    ) -> Result<Graph, WithRootError> {
        if let Binding::Node { node, output } = value
            && self.reads_light_sample(node, output)
        {
            return Err(WithRootError::InsideLightLoop { node: self.nodes[node].name.clone() });
        }
        let mut graph = self.clone();
        let color = match value_type {
            Type::Color | Type::Scalar | Type::Integer => value,
            Type::Vector => {
                let split = graph.append("split_vector", None, vec![value])?;
                let component = |output| Binding::Node { node: split, output };
                let inputs = vec![component(0), component(1), component(2), Binding::Default];
                let combined = graph.append("combine_color", None, inputs)?;
                Binding::Node { node: combined, output: 0 }
            }
            Type::Boolean => {
                let inputs = vec![value, Binding::Default, Binding::Default];
                let chosen = graph.append("select", Some(Type::Scalar), inputs)?;
                Binding::Node { node: chosen, output: 0 }
            }
            Type::Shader
            | Type::Transform
            | Type::String
            | Type::Texture
            | Type::Light
            | Type::Lights
            | Type::Generic => {
                return Err(WithRootError::NotAValue {
                    node: of.to_owned(),
                    output: name.to_owned(),
                    type_name: value_type.name(),
                });
            }
        };
        graph.roots.retain(|root| root.kind != RootKind::Material);
        graph.roots.push(Root { kind: RootKind::Material, color, ok: Binding::Default });
        Ok(graph)
    }

    /// Adds a node of the type called `name`, under a name no file can give one.
    fn append(
        &mut self,
        name: &'static str,
        generic: Option<Type>,
        inputs: Vec<Binding>,
    ) -> Result<usize, WithRootError> {
        let type_name = generic.unwrap_or(Type::Vector).name();
        let missing = WithRootError::NoConversion { name, type_name };
        let node_type = self.library.find(name).ok_or_else(|| missing.clone())?;
        let definition = self.library.definition(node_type);
        let overload = definition.overloads.iter().position(|form| form.generic == generic);
        let fits = definition.signature.inputs.len() == inputs.len();
        let overload = overload.filter(|_| fits).ok_or(missing)?;
        self.nodes.push(Node { name: format!("({name})"), node_type, overload, inputs });
        Ok(self.nodes.len() - 1)
    }

    /// Whether an output depends on the light sample otherwise than through the body of a loop.
    fn reads_light_sample(&self, node: usize, output: usize) -> bool {
        let mut seen = HashSet::from([(node, output)]);
        let mut waiting = vec![(node, output)];
        while let Some((node, output)) = waiting.pop() {
            let Node { node_type, inputs, .. } = &self.nodes[node];
            if is_of_turn(&self.library, *node_type, Some(output), Iterated::Lights) {
                return true;
            }
            let signature = self.library.signature(*node_type);
            for (at, (input, binding)) in signature.inputs.iter().zip(inputs).enumerate() {
                if input.scoped && matches!(signature.kind, Kind::Loop(Iterated::Lights, _)) {
                    continue;
                }
                match binding {
                    Binding::Node { node, output } if seen.insert((*node, *output)) => {
                        waiting.push((*node, *output));
                    }
                    Binding::Default
                        if reads_turn(&self.library, *node_type, at, Iterated::Lights) =>
                    {
                        return true;
                    }
                    _ => {}
                }
            }
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::check::check_graph;
    use crate::document;
    use crate::effects::NoScene;
    use crate::engine::{Engine, Options, Shade, Shaded, Shader};
    use crate::nodes::NodeLibrary;
    use crate::state::{Field, State};

    const GRAPH: &str = r#"{
        "phenomenon": "looked_at", "version": 1,
        "nodes": {
            "state": { "type": "state" },
            "sum": { "type": "add", "inputs": { "a": { "node": "state", "output": "normal" },
                                                "b": [0.5, -0.0, 1e-40] } },
            "inside": { "type": "lambert" },
            "lit": { "type": "light_loop", "inputs": { "body": { "node": "inside" } } }
        },
        "roots": { "material": { "node": "lit" } }
    }"#;

    fn graph() -> Graph {
        let document = document::read("looked_at.json", GRAPH.as_bytes()).unwrap();
        let checked = check_graph(&document, &NodeLibrary::standard());
        checked.graph.unwrap_or_else(|| panic!("{:?}", checked.findings))
    }

    fn shaded(graph: Graph, engine: Engine) -> [u32; 4] {
        let options = Options { engine, ..Options::default() };
        let shader = Shader::new(Arc::new(graph), &[], options).unwrap();
        let mut results = [Shaded::default()];
        shader.shade(RootKind::Material, &[State::default()], &mut NoScene, &mut results);
        results[0].color.map(f32::to_bits)
    }

    #[test]
    fn every_type_is_looked_at_to_the_bit() {
        let graph = graph();
        let field = |name: &str| {
            let position = Field::ALL.iter().position(|field| field.name() == name).unwrap();
            graph.with_root(0, position).unwrap()
        };
        for engine in [Engine::Walk, Engine::Batch] {
            let vector = shaded(graph.with_root(1, 0).unwrap(), engine);
            assert_eq!(vector, [0.5, 0.0, 1.0 + 1e-40, 1.0].map(f32::to_bits));
            assert_eq!(shaded(field("dot_nd"), engine)[0], (-1.0_f32).to_bits());
            assert_eq!(shaded(field("inv_normal"), engine)[0], 0);
            assert_eq!(shaded(field("ray_type"), engine)[0], 0);
        }
    }

    #[test]
    fn what_reads_the_light_sample_has_no_value_outside_its_loop() {
        let graph = graph();
        let error = graph.with_root(2, 0).unwrap_err();
        assert_eq!(error, WithRootError::InsideLightLoop { node: "inside".into() });
        assert!(graph.with_root(3, 0).is_ok());
    }
}
