//! Graphs in a few lines, for failure messages.

use std::fmt::Write;

use crate::graph::{Binding, Graph};

/// The graph, a line for each node; inputs left at their defaults are left out.
pub fn graph_text(graph: &Graph) -> String {
    let mut text = String::new();
    for parameter in &graph.parameters {
        let _ = writeln!(text, "  parameter {} = {}", parameter.name, parameter.default);
    }
    for node in &graph.nodes {
        let definition = graph.library.definition(node.node_type);
        let generic = definition.overloads[node.overload].generic;
        let suffix = generic.map_or(String::new(), |of| format!("<{}>", of.name()));
        let inputs: Vec<String> = definition
            .signature
            .inputs
            .iter()
            .zip(&node.inputs)
            .filter(|(_, binding)| **binding != Binding::Default)
            .map(|(input, given)| format!("{}: {}", input.name, binding(graph, given)))
            .collect();
        let name = &definition.signature.name;
        let _ = writeln!(text, "  {} = {name}{suffix} {{ {} }}", node.name, inputs.join(", "));
    }
    for root in &graph.roots {
        let color = binding(graph, &root.color);
        let ok = binding(graph, &root.ok);
        let _ = writeln!(text, "  root {} = {color}, ok {ok}", root.kind.name());
    }
    text
}

fn binding(graph: &Graph, binding: &Binding) -> String {
    match binding {
        Binding::Default => "default".to_owned(),
        Binding::Literal(value) => value.to_string(),
        Binding::Parameter(at) => graph.parameters[*at].name.clone(),
        Binding::Node { node, output } => {
            let node = &graph.nodes[*node];
            let outputs = &graph.library.signature(node.node_type).outputs;
            format!("{}.{}", node.name, outputs[*output].name)
        }
    }
}
