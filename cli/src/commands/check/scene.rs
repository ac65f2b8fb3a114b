//! Checking a scene with every graph it uses.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use phenomenon_compiler::check::{Checked, read_graph_file};
use phenomenon_compiler::diagnostics::{Code, Finding};
use phenomenon_compiler::document::Document;
use phenomenon_compiler::graph::{BindError, Graph, RootKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_runtime::scene::{MaterialRef, MaterialSource, SceneDescription, read_scene};

/// Everything wrong in a scene, in its graphs, and in how the two fit.
pub fn check(document: &Document, folder: &Path, library: &NodeLibrary) -> Vec<Finding> {
    let file = &document.file;
    let read = read_scene(&file.name, file.text.as_bytes(), folder);
    let mut findings = read.findings;
    if let Some(scene) = read.scene {
        graphs(&scene, library, &mut findings);
    }
    findings
}

fn graphs(scene: &SceneDescription, library: &NodeLibrary, findings: &mut Vec<Finding>) {
    let mut known: HashMap<&PathBuf, Option<Graph>> = HashMap::new();
    let of_objects = scene.objects.len();
    for (at, material) in scene.materials().enumerate() {
        let MaterialSource::File(path) = &material.source else { continue };
        let graph = known.entry(path).or_insert_with(|| {
            let Checked { graph, findings: own, .. } = read_graph_file(path, library);
            findings.extend(own);
            graph
        });
        let root = if at < of_objects { RootKind::Material } else { RootKind::Environment };
        if let Some(graph) = graph {
            fits(material, graph, root, findings);
        }
    }
}

/// Whether a graph has the root that is called, and its parameters the values they are given.
fn fits(material: &MaterialRef, graph: &Graph, root: RootKind, findings: &mut Vec<Finding>) {
    if graph.root(root).is_none() {
        let message = format!("`{}` has no `{}` root", graph.name, root.name());
        let help = format!("give it one, or use a graph that has a `{}` root here", root.name());
        findings.push(Finding::new(Code::MISSING_ROOT, material.place.clone(), message, help));
    }
    for setting in &material.set {
        if let Err(error) = graph.bind(&setting.name, &setting.text) {
            let code = match error {
                BindError::Unknown { .. } => Code::UNKNOWN_PARAMETER,
                BindError::Type { .. } => Code::TYPE_MISMATCH,
                BindError::NotFinite { .. } => Code::NOT_FINITE,
                BindError::Range { .. } => Code::NUMBER_OUT_OF_RANGE,
            };
            let help =
                "`set` gives parameters of the graph values of their type, within their range";
            let place = setting.place.clone();
            findings.push(Finding::new(code, place, error.to_string(), help));
        }
    }
}
