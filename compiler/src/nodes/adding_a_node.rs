//! Follows `docs/adding-a-node.md`: its example is a node of the library, and is used in a graph.

use std::sync::Arc;

use super::NodeLibrary;
use crate::check::check_graph;
use crate::document;
use crate::effects::NoScene;
use crate::engine::{Engine, Options, Shade, Shaded, Shader};
use crate::graph::RootKind;
use crate::state::State;
use crate::values::Literal;

const PAGE: &str = include_str!("../../../docs/adding-a-node.md");
const SOURCE: &str = include_str!("color/contrast.rs");

/// The graph of the page's last step.
fn graph_of_the_page() -> &'static str {
    let start = PAGE.find("```json\n").expect("the page shows a graph") + "```json\n".len();
    let length = PAGE[start..].find("```").expect("the graph ends");
    &PAGE[start..start + length]
}

#[test]
fn the_page_shows_the_source_that_is_compiled() {
    let (code, tests) = SOURCE.split_once("#[cfg(test)]").expect("the example has tests");
    assert!(PAGE.contains(&format!("```rust\n{}\n```", code.trim_end())), "signature and body");
    let tests = format!("```rust\n#[cfg(test)]{}\n```", tests.trim_end());
    assert!(PAGE.contains(&tests), "tests");
    let steps = (1..=5).map(|step| format!("\n## {step}. "));
    assert!(steps.into_iter().all(|step| PAGE.contains(&step)));
    assert!(!PAGE.contains("\n## 6. "));
}

#[test]
fn the_new_node_runs_in_every_engine() {
    let library = NodeLibrary::standard();
    let document = document::read("page.json", graph_of_the_page().as_bytes()).expect("JSON");
    let checked = check_graph(&document, &library);
    assert!(checked.findings.is_empty(), "{:#?}", checked.findings);
    let graph = Arc::new(checked.graph.expect("a graph"));
    for engine in [Engine::Walk, Engine::Batch, Engine::Jit] {
        let options = Options { engine, ..Options::default() };
        let values = [("amount".to_string(), Literal::Scalar(3.0))];
        let shader = Shader::new(graph.clone(), &values, options).expect("the graph compiles");
        let mut results = [Shaded::default(); 9];
        shader.shade(RootKind::Material, &[State::default(); 9], &mut NoScene, &mut results);
        let expected = Shaded { color: [-0.5, 0.25, 2.5, 1.0], ok: true };
        assert_eq!(results, [expected; 9], "{engine:?}");
    }
}
