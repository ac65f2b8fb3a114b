//! What only shows when a graph is put to use: programs that grow too large.

use std::sync::Arc;

use phenomenon_compiler::diagnostics::{Code, Finding, Place};
use phenomenon_compiler::document::Document;
use phenomenon_compiler::engine::{Engine, Options, Shader, ShaderError};
use phenomenon_compiler::graph::{Graph, RootKind};
use phenomenon_compiler::specialise::SpecialiseError;
use phenomenon_compiler::values::Literal;

/// Why a graph cannot be compiled with these values, as findings in its file.
pub fn uncompilable(
    graph: &Arc<Graph>,
    values: &[(String, Literal)],
    document: &Document,
) -> Vec<Finding> {
    let compiled = |graph: Arc<Graph>| {
        // Every engine starts from what the walk runs.
        let kinds: &'static [RootKind] = &RootKind::ALL;
        let options = Options { engine: Engine::Walk, roots: kinds, ..Options::default() };
        Shader::new(graph, values, options)
    };
    if compiled(Arc::clone(graph)).is_ok() {
        return Vec::new();
    }
    let mut findings: Vec<Finding> = Vec::new();
    for root in &graph.roots {
        let mut alone = Graph::clone(graph);
        alone.roots.retain(|other| other.kind == root.kind);
        let Err(ShaderError::Specialise(error)) = compiled(Arc::new(alone)) else { continue };
        let finding = finding(&error, root.kind, document);
        // Two roots that share what grows too large have one mistake.
        if findings.iter().all(|known| known.place != finding.place) {
            findings.push(finding);
        }
    }
    findings
}

fn finding(error: &SpecialiseError, root: RootKind, document: &Document) -> Finding {
    let (SpecialiseError::TooManyInstances { node, .. }
    | SpecialiseError::TooManyLoops { node, .. }
    | SpecialiseError::Inconsistent { node, .. }) = error;
    let told = error.to_string();
    let (message, help) = told.rsplit_once("; ").unwrap_or((&told, ""));
    let roots = document.root.get("roots");
    let called = roots.and_then(|roots| roots.get(root.name())).map(|it| document.place(it));
    let place = place_of_node(document, node).or(called.clone());
    let place = place.unwrap_or_else(|| document.place(roots.unwrap_or(&document.root)));
    let finding = Finding::new(Code::TOO_MANY_EVALUATIONS, place, message, help);
    match called {
        Some(called) if called != finding.place => {
            finding.with_related(called, "evaluated for this root")
        }
        _ => finding,
    }
}

/// Where a node stands; one of a phenomenon in the graph stands where that is used, and what an expression of an input
/// became where the node of that input is.
pub(super) fn place_of_node(document: &Document, node: &str) -> Option<Place> {
    let name = node.split(['/', '@']).next()?;
    let nodes = document.root.get("nodes")?;
    let member = nodes.members().iter().find(|member| member.key == name)?;
    Some(document.place_of_key(member))
}
