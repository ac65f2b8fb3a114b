//! A graph with foreign nodes, from its file to every engine: whatever is done with it, nobody hands the
//! library over again.

use std::sync::Arc;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::document;
use phenomenon_compiler::effects::{Answer, Ray, Renderer, Trace};
use phenomenon_compiler::engine::{Engine, Options, Shade, Shaded, Shader};
use phenomenon_compiler::graph::{Graph, RootKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::show::{draw_dot, draw_svg};
use phenomenon_compiler::state::State;
use phenomenon_compiler::testing::build::Built;
use phenomenon_compiler::values::{Literal, Type};
use phenomenon_foreign_nodes::library;

const POSTER: &str = include_str!("../poster.json");

/// The graph; the library is gone when it is used.
fn poster() -> Graph {
    let document = document::read("poster.json", POSTER.as_bytes()).expect("it is JSON");
    let checked = check_graph(&document, &library());
    assert!(checked.findings.is_empty(), "{:#?}", checked.findings);
    checked.graph.expect("a graph")
}

/// All that is seen is half as bright.
struct Half;

impl Renderer for Half {
    fn trace(&mut self, _: Trace, _: &[State], rays: &[Ray], answers: &mut [Answer]) {
        assert_eq!(rays.len(), answers.len());
        answers.fill(Answer { color: [0.5, 0.5, 0.5, 1.0], ok: true, ..Answer::default() });
    }
}

fn shaded(shader: &Shader) -> [Shaded; 9] {
    let state = |at: usize| State { uv: [at as f32 / 8.0, 0.0], ..State::default() };
    let mut results = [Shaded::default(); 9];
    shader.shade(
        RootKind::Material,
        &std::array::from_fn::<_, 9, _>(state),
        &mut Half,
        &mut results,
    );
    results
}

#[test]
fn it_is_shaded_in_every_engine() {
    let graph = Arc::new(poster());
    for engine in [Engine::Walk, Engine::Batch, Engine::Jit] {
        let options = Options { engine, ..Options::default() };
        let mut shader = Shader::new(Arc::clone(&graph), &[], options).expect("it compiles");
        // The mean of 0, 1, 2 and 3 is 1.5, and the mirror shows half of it.
        let color = |red: f32| Shaded { color: [red * 0.5, 0.75, 0.0, 1.0], ok: true };
        let found = shaded(&shader);
        assert_eq!([found[0], found[8]], [0.0, 1.0].map(color), "{engine:?}");
        let third = 1.0 / 3.0;
        assert!(found[3..6].iter().all(|it| *it == color(third)), "{engine:?}: {found:?}");
        // Another number of steps is other code.
        shader.set("levels", &Literal::Integer(2)).expect("it takes 2");
        let found = shaded(&shader);
        assert_eq!([found[3], found[4]], [0.0, 0.5].map(color), "{engine:?}");
    }
}

#[test]
fn engines_and_the_definition_agree_on_it() {
    assert!(Built { graph: Arc::new(poster()) }.agree(3).requests > 0);
}

#[test]
fn it_is_drawn_bound_and_looked_at() {
    let graph = poster();
    assert!(draw_svg(&graph).expect("it is drawn").contains("posterize"));
    assert!(draw_dot(&graph).expect("it is drawn").contains("colour_of_mirror"));
    assert!(graph.bind_literal("levels", &Literal::Integer(17)).is_err());
    let at = |name: &str| graph.nodes.iter().position(|node| node.name == name).expect("a node");
    assert_eq!(graph.output_type(at("stepped"), 0), Type::Color);
    let alone = graph.with_root(at("stepped"), 0).expect("it has a value");
    let shader = Shader::new(Arc::new(alone), &[], Options::default()).expect("it compiles");
    assert_eq!(shaded(&shader)[8].color, [1.0, 0.0, 0.0, 1.0]);
}

#[test]
fn the_standard_library_does_not_know_the_nodes() {
    let document = document::read("poster.json", POSTER.as_bytes()).expect("it is JSON");
    let checked = check_graph(&document, &NodeLibrary::standard());
    let unknown = checked.findings.iter().filter(|it| it.code == Code::UNKNOWN_NODE_TYPE);
    assert_eq!(unknown.count(), 3, "{:#?}", checked.findings);
    assert!(checked.graph.is_none());
}

#[test]
fn two_libraries_live_side_by_side() {
    // The same nodes at other positions: each graph finds its own.
    let mut other = NodeLibrary::default();
    for group in library().groups() {
        other.add_group(group.clone());
    }
    let all: Vec<_> = library().iter().map(|(_, definition)| definition.clone()).collect();
    all.into_iter().rev().for_each(|definition| other.add(definition));
    let document = document::read("poster.json", POSTER.as_bytes()).expect("it is JSON");
    let turned = check_graph(&document, &other).graph.expect("a graph");
    let graph = poster();
    assert_ne!(turned.nodes[0].node_type, graph.nodes[0].node_type);
    let of = |graph: Graph| {
        shaded(&Shader::new(Arc::new(graph), &[], Options::default()).expect("it compiles"))
    };
    assert_eq!(of(turned), of(graph));
}
