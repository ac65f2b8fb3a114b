//! Checking a scene with every graph it uses.

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use phenomenon_compiler::check::{Checked, Files, check_graph_with};
use phenomenon_compiler::diagnostics::{Code, Finding, Severity, TellOnce};
use phenomenon_compiler::document::{Document, all_mistakes};
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::nodes::NodeLibrary;

use super::texture_sum::TextureSum;
use super::uncompilable::uncompilable;
use crate::scene_file::{
    Assets, MaterialRef, MaterialSource, SceneFile, check_scene_with, is_scene, missing_root,
    settings, unknown_lights,
};

/// Everything wrong in a scene, in its graphs, and in how the two fit. The scene's own findings come
/// first, in file order. What it uses is checked even where the scene itself has errors. The files it
/// names are looked for in `folder`; graphs come from `files`, pictures and meshes from `assets`.
pub fn check_with_graphs(
    document: &Document,
    folder: &Path,
    library: &NodeLibrary,
    files: &dyn Files,
    assets: &Assets,
) -> Checked {
    let scene = check_scene_with(document, folder, assets);
    let mut graphs = Graphs {
        library,
        files,
        known: HashMap::new(),
        compiled: HashSet::new(),
        textures: TextureSum::new(assets),
        omitted: 0,
    };
    let mut findings = scene.findings.clone();
    findings.extend(graphs.check(&scene));
    let is_own = |finding: &Finding| finding.place.file.name == document.file.name;
    let (mut own, others): (Vec<Finding>, Vec<Finding>) = findings.into_iter().partition(is_own);
    own.sort_by_key(|finding| finding.place.start);
    own.extend(others);
    // Two objects of one graph find the same in it.
    let mut once = TellOnce::default();
    own.retain(|finding| once.is_new(finding));
    Checked { graph: None, findings: own, omitted: scene.omitted + graphs.omitted }
}

/// The graphs of a scene, each read and checked once.
struct Graphs<'a> {
    library: &'a NodeLibrary,
    files: &'a dyn Files,
    /// By the one path of the file; none where it cannot be used.
    known: HashMap<PathBuf, Option<(Arc<Graph>, Document)>>,
    /// Graphs with the values they were tried with.
    compiled: HashSet<(PathBuf, String)>,
    textures: TextureSum<'a>,
    omitted: usize,
}

impl Graphs<'_> {
    fn check(&mut self, scene: &SceneFile) -> Vec<Finding> {
        let mut findings = Vec::new();
        for used in &scene.uses {
            let MaterialSource::File(path) = &used.material.source else { continue };
            let identity = self.files.identity(path);
            if !self.known.contains_key(&identity) {
                let graph = self.read(path, &used.material, &mut findings);
                self.known.insert(identity.clone(), graph);
            }
            let Some((graph, document)) = self.known.get(&identity).and_then(Option::as_ref) else {
                continue;
            };
            let (values, misfits) = settings(&used.material, graph, self.files);
            let fits = misfits.is_empty();
            findings.extend(misfits);
            findings.extend(missing_root(used, graph));
            if let Some(lights) = &scene.lights {
                let document = Some(document);
                findings.extend(unknown_lights(lights, &used.material, graph, &values, document));
            }
            // Many objects use a graph with the same values.
            if fits && self.compiled.insert((identity, format!("{values:?}"))) {
                let found = uncompilable(graph, &values, document);
                findings.extend(found.into_iter().map(|it| used_here(it, &used.material)));
                findings.extend(self.textures.add(graph, &values, &used.material));
            }
        }
        findings
    }

    fn read(
        &mut self,
        path: &Path,
        material: &MaterialRef,
        findings: &mut Vec<Finding>,
    ) -> Option<(Arc<Graph>, Document)> {
        let document = match self.files.read(path) {
            Ok(document) if is_scene(&document) => {
                let message = format!("`{}` is a scene, not a graph", path.display());
                let help = "name a graph, such as one of the materials of that scene";
                let place = material.place.clone();
                findings.push(Finding::new(Code::NOT_A_GRAPH, place, message, help));
                return None;
            }
            Ok(document) => document,
            Err(finding) if finding.code == Code::UNREADABLE_FILE => {
                // Told where the file is named: there is nothing else to look at.
                let message = format!("this graph cannot be used: {}", finding.message);
                let help = "its path starts at the folder of the scene";
                let place = material.place.clone();
                findings.push(Finding::new(finding.code, place, message, help));
                return None;
            }
            Err(finding) => {
                let mistakes = all_mistakes(*finding).into_iter();
                findings.extend(mistakes.map(|finding| used_here(finding, material)));
                return None;
            }
        };
        let checked = check_graph_with(&document, self.library, self.files);
        self.omitted += checked.omitted;
        findings.extend(checked.findings.into_iter().map(|finding| used_here(finding, material)));
        checked.graph.map(|graph| (Arc::new(graph), document))
    }
}

/// An error of a graph makes the scene unusable: it shows where the scene uses it.
fn used_here(finding: Finding, material: &MaterialRef) -> Finding {
    match finding.severity {
        Severity::Error => finding.with_related(material.place.clone(), "the scene uses it here"),
        Severity::Warning | Severity::Note => finding,
    }
}
