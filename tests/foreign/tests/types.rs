//! Scopes over values of every type, and nodes that take some types only.

use phenomenon_compiler::check::{Checked, check_graph};
use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::document;
use phenomenon_compiler::graph::Binding;
use phenomenon_compiler::nodes::reference::reference;
use phenomenon_compiler::state::State;
use phenomenon_compiler::testing::build::{Build, Built};
use phenomenon_compiler::testing::mock::MockRenderer;
use phenomenon_compiler::values::{Literal, Type};
use phenomenon_foreign_nodes::library;

#[test]
fn numbers_vectors_and_colours_are_evaluated_in_a_scope() {
    for (generic, field) in
        [(Type::Scalar, "time"), (Type::Vector, "direction"), (Type::Color, "incoming")]
    {
        let mut build = Build::with(library());
        let state = build.node("state", &[]);
        let turned = build.node_of("turn", generic, &[("input", state.output(field))]);
        let shown = match generic {
            Type::Vector => {
                let split = build.node("split_vector", &[("vector", turned.first())]);
                let parts = ["x", "y", "z"].map(|part| split.output(part));
                let [r, g, b] = parts;
                build.node("combine_color", &[("r", r), ("g", g), ("b", b)]).first()
            }
            _ => turned.first(),
        };
        let built = build.material(shown);
        assert_eq!(built.graph.output_type(1, 0), generic);
        built.agree(19);
    }
}

#[test]
fn truth_is_evaluated_in_a_scope() {
    let mut build = Build::with(library());
    let state = build.node("state", &[]);
    let inside = Binding::Literal(Literal::Boolean(true));
    let inputs = [("inside", inside), ("input", state.output("inv_normal"))];
    let flipped = build.node("flip", &inputs);
    let chosen = build.node("select", &[("condition", flipped.first())]);
    let built = build.material(chosen.first());
    // From inside it is outside, whatever the point says.
    let inside = [State { inv_normal: true, ..State::default() }; 3];
    built.in_every_engine(&[], &inside, &MockRenderer::default(), |engine, _, results| {
        assert!(results.iter().all(|it| it.color[0] == 0.0), "{engine}");
    });
    built.agree(23);
}

fn checked(inputs: &str) -> Checked {
    let text = format!(
        r#"{{ "phenomenon": "chosen", "version": 1,
             "nodes": {{
                 "state": {{ "type": "state" }},
                 "chosen": {{ "type": "either", "inputs": {{ {inputs} }} }}
             }},
             "roots": {{ "material": {{ "node": "chosen" }} }} }}"#
    );
    let document = document::read("chosen.json", text.as_bytes()).expect("it is JSON");
    check_graph(&document, &library())
}

#[test]
fn a_number_becomes_the_first_type_that_takes_it() {
    let found = checked(r#""a": { "node": "state", "output": "u" }, "b": 0.5"#);
    assert!(found.findings.is_empty(), "{:#?}", found.findings);
    let graph = found.graph.expect("a graph");
    let chosen = graph.nodes.iter().position(|node| node.name == "chosen").expect("it is there");
    assert_eq!(graph.output_type(chosen, 0), Type::Color);
    Built { graph: graph.into() }.agree(29);
}

#[test]
fn what_no_form_takes_is_told() {
    let truth = checked(r#""a": { "node": "state", "output": "inv_normal" }"#);
    assert!(truth.graph.is_none());
    let codes: Vec<Code> = truth.findings.iter().map(|it| it.code).collect();
    assert!(codes.contains(&Code::TYPE_MISMATCH), "{codes:?}");
}

#[test]
fn the_reference_names_the_types_of_a_node_that_takes_some_only() {
    let page = reference(&library());
    let (_, either) = page.split_once("\n### either\n").expect("it is there");
    let (either, _) = either.split_once("\n### ").unwrap_or((either, ""));
    assert!(either.contains("Its values are of the types vector and color only."), "{either}");
    assert_eq!(either.matches("Its values are of the types").count(), 1);
    assert!(page.contains("\n## foreign\n\nNodes of another crate.\n"));
}
