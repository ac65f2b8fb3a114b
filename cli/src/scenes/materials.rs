//! Shaders for the graphs of a scene.

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use phenomenon_compiler::check::{OnDisk, check_graph, check_graph_with};
use phenomenon_compiler::diagnostics::{Finding, Place, Severity};
use phenomenon_compiler::document::{Document, all_mistakes, read, read_file};
use phenomenon_compiler::engine::{Options, Shade, Shader};
use phenomenon_compiler::graph::{Graph, RootKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::values::Literal;
use phenomenon_runtime::monoliths;
use phenomenon_runtime::render::CALLED_ROOTS;
use phenomenon_runtime::scene_file::{
    LightNames, MaterialRef, MaterialSource, SceneDescription, embedded_file, settings,
    unknown_lights,
};

use super::changes::Changed;
use super::notes;
use crate::arguments::{EngineChoice, NodePath};
use crate::failure::Failure;
use crate::graphs::{self, EngineArguments, Told};
use crate::usable::{self, DecodedPictures};

/// The graph that is looked at, with the values it is given.
pub struct Subject {
    pub graph: Graph,
    pub document: Arc<Document>,
    pub values: Vec<(String, Literal)>,
}

/// Makes shaders of the materials of a scene.
pub struct Materials<'a> {
    pub lights: LightNames,
    pub library: &'a Arc<NodeLibrary>,
    pub engine: &'a EngineArguments,
    pub told: Told<'a>,
    pub subject: Option<Subject>,
    /// What the command line changes about uses of graphs.
    pub changes: Vec<Changed>,
    /// Whether the scene is the one built into the program, and so are the files it names.
    pub built_in: bool,
    /// Where the scene names the graph of its environment.
    pub environment: Option<Place>,
    pub graphs: HashMap<PathBuf, (Graph, Arc<Document>)>,
    /// Graphs of which was told what is not done.
    pub idle_told: HashSet<MaterialSource>,
    pub shaders: Vec<Arc<Shader>>,
    /// Time spent compiling.
    pub milliseconds: f64,
}

impl Materials<'_> {
    /// The shader for a use of a graph.
    ///
    /// # Errors
    /// The graph cannot be used, or not in this way.
    pub fn shader(&mut self, material: &MaterialRef) -> Result<Arc<dyn Shade>, Failure> {
        let changed = material.change.and_then(|at| self.changes.get(at)).cloned();
        let root = match &self.environment {
            Some(place) if *place == material.place => RootKind::Environment,
            _ => RootKind::Material,
        };
        let (mut graph, document, mut values) = match &material.source {
            MaterialSource::Subject => match &self.subject {
                Some(it) => (it.graph.clone(), it.document.clone(), it.values.clone()),
                None => {
                    return Err(Failure::new(
                        format!("{}: no graph is looked at", notes::shown(&material.place)),
                        "render a graph, and give this file with --scene; \
                         or name the file of a graph instead of `subject`",
                    ));
                }
            },
            MaterialSource::File(path) => {
                let (graph, document) = self.graph(path)?;
                (graph, document, Vec::new())
            }
        };
        if let Some(Changed { object, set, .. }) = &changed {
            values = graphs::bind(&graph, &format!("{object}:"), set)?;
        }
        let (set, mut findings) = settings(material, &graph, &OnDisk);
        let given: HashSet<String> = values.iter().map(|(name, _)| name.clone()).collect();
        // The command line has the last word.
        values.extend(set.into_iter().filter(|(name, _)| !given.contains(name)));
        findings.extend(unknown_lights(&self.lights, material, &graph, &values, Some(&document)));
        if !findings.is_empty() {
            self.told.tell(&findings, 0);
            return Err(graphs::unusable(Path::new(&material.place.file.name)));
        }
        if self.idle_told.insert(material.source.clone()) {
            notes::tell_idle(&graph);
        }
        if let Some(node) = changed.and_then(|changed| changed.node) {
            graph = shown_node(graph, self.library, self.engine, &node, root)?;
        }
        if material.source != MaterialSource::Subject && graph.root(root).is_none() {
            notes::tell_black(&graph, root, &material.place);
        }
        match self.engine.engine.compiled() {
            Some(engine) => {
                let start = Instant::now();
                let options = Options { roots: CALLED_ROOTS, ..self.engine.options(engine) };
                let shader = graphs::compile(graph, self.library, &values, options)
                    .map_err(|failure| self.uncompilable(material, &values, failure))?;
                let shader = Arc::new(shader);
                self.milliseconds += start.elapsed().as_secs_f64() * 1e3;
                self.shaders.push(Arc::clone(&shader));
                Ok(shader)
            }
            None => monolith(&graph, self.library, values),
        }
    }

    /// Says where in a graph is what keeps it from being compiled.
    fn uncompilable(
        &self,
        material: &MaterialRef,
        values: &[(String, Literal)],
        failure: Failure,
    ) -> Failure {
        let known = match &material.source {
            MaterialSource::Subject => self.subject.as_ref().map(|it| (&it.graph, &it.document)),
            MaterialSource::File(path) => self.graphs.get(path).map(|it| (&it.0, &it.1)),
        };
        let Some((graph, document)) = known else { return failure };
        let findings = usable::uncompilable(graph, self.library, values, document);
        if findings.is_empty() {
            return failure;
        }
        self.told.tell(&findings, 0);
        graphs::unusable(Path::new(&document.file.name))
    }

    /// Says where pictures are named that cannot be used; whether there are any.
    pub fn tell_pictures(&self, scene: &SceneDescription) -> bool {
        let files = DecodedPictures::of(&OnDisk);
        let subject = self.subject.iter().map(|it| &it.document);
        let documents = subject.chain(self.graphs.values().map(|(_, document)| document));
        let mut findings: Vec<Finding> = documents
            .flat_map(|document| check_graph_with(document, self.library, &files).findings)
            .collect();
        for material in scene.materials() {
            if let MaterialSource::File(path) = &material.source
                && let Some((graph, _)) = self.graphs.get(path)
            {
                findings.extend(settings(material, graph, &files).1);
            }
        }
        findings.retain(|finding| finding.severity == Severity::Error);
        self.told.tell(&findings, 0);
        !findings.is_empty()
    }

    fn graph(&mut self, path: &Path) -> Result<(Graph, Arc<Document>), Failure> {
        if let Some(known) = self.graphs.get(path) {
            return Ok(known.clone());
        }
        let document = match embedded_file(path).filter(|_| self.built_in) {
            Some(text) => read(&path.display().to_string(), text.as_bytes()),
            None => read_file(path),
        };
        let document = document.map_err(|finding| {
            self.told.tell(&all_mistakes(*finding), 0);
            graphs::unusable(path)
        })?;
        let graph = self.told.checked(path, check_graph(&document, self.library))?;
        let known = (graph, Arc::new(document));
        self.graphs.insert(path.to_owned(), known.clone());
        Ok(known)
    }
}

/// The graph with one of its nodes for the root that is called.
///
/// # Errors
/// There is no such node, or it has no value to look at.
pub fn shown_node(
    graph: Graph,
    library: &NodeLibrary,
    engine: &EngineArguments,
    node: &NodePath,
    root: RootKind,
) -> Result<Graph, Failure> {
    if engine.engine == EngineChoice::Monolith {
        return Err(Failure::new(
            "--engine monolith: a monolith has no nodes to show",
            "choose walk, batch or jit",
        ));
    }
    let (node, output) = node.find(&graph, library)?;
    let mut shown = graph
        .with_root(library, node, output.unwrap_or(0))
        .map_err(|error| Failure::new(format!("--node: {error}"), ""))?;
    if root != RootKind::Material
        && let Some(mut looked_at) = shown.roots.pop()
    {
        looked_at.kind = root;
        shown.roots.retain(|other| other.kind != root);
        shown.roots.push(looked_at);
    }
    Ok(shown)
}

/// The monolith that computes what a graph does. It has defaults of its own, so it is given those of
/// the graph.
fn monolith(
    graph: &Graph,
    library: &NodeLibrary,
    mut values: Vec<(String, Literal)>,
) -> Result<Arc<dyn Shade>, Failure> {
    let name = monoliths::recognise(graph, library).map_err(|error| {
        let help = format!(
            "these are: {}; choose another engine for this graph",
            monoliths::NAMES.join(", ")
        );
        Failure::new(format!("--engine monolith: {error}"), help)
    })?;
    let given: HashSet<String> = values.iter().map(|(name, _)| name.clone()).collect();
    let defaults = graph.parameters.iter().filter(|of| !given.contains(&of.name));
    values.extend(defaults.map(|of| (of.name.clone(), of.default.clone())));
    match monoliths::find(name, &values) {
        Some(Ok(shader)) => Ok(Arc::from(shader)),
        Some(Err(error)) => Err(Failure::new(error, "leave it out, or choose another engine")),
        None => Err(Failure::new(
            format!("--engine monolith: `{name}` is not written by hand"),
            format!("these are: {}", monoliths::NAMES.join(", ")),
        )),
    }
}
