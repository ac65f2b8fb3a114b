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

use super::by_hand::ByHand;
use super::changes::{Change, Changes};
use super::error::{LinkError, ShowNodeError};
use super::notes::Note;
use super::shown::shown_node;
use super::uncompilable::uncompilable;
use super::values::bind_texts;
use crate::monoliths::{self, NoMonolith};
use crate::render::CALLED_ROOTS;
use crate::scene_file::{
    LightNames, MaterialRef, MaterialSource, SceneDescription, embedded_file, settings,
    unknown_lights,
};
use crate::texture::DecodedPictures;

/// What runs graphs.
#[derive(Clone, Copy, Debug)]
pub enum Shading {
    /// The engine of these options; which roots it compiles is up to the linker.
    Compiled(Options),
    /// The monoliths that compute the same. In a scene in which some object's material is written by hand,
    /// what is not, but for the graph that is looked at, is run by the engine of these options.
    ByHand(Options),
}

/// The graph that is looked at, with the values it is given.
#[derive(Clone)]
pub struct Subject {
    /// The graph.
    pub graph: Graph,
    /// Its file.
    pub document: Arc<Document>,
    /// Values for its parameters.
    pub values: Vec<(String, Literal)>,
}

/// What is said while a scene is linked.
#[derive(Clone, Debug)]
pub enum Remark<'t> {
    /// What was found in a file; if there are errors, they keep the scene from being linked.
    Findings {
        /// The findings.
        findings: &'t [Finding],
        /// How many more there are.
        omitted: usize,
    },
    /// Something that keeps nothing from being rendered.
    Note(Note),
}

/// A use of a graph in a scene.
#[derive(Clone)]
pub struct ShaderUse {
    /// The file of the graph.
    pub document: Arc<Document>,
    /// The root that is called where rays end: that of a material, or of the environment.
    pub root: RootKind,
}

/// Makes shaders of the materials of a scene.
pub(super) struct Materials<'a> {
    pub(super) library: &'a NodeLibrary,
    pub(super) shading: Shading,
    pub(super) subject: Option<&'a Subject>,
    pub(super) changes: &'a Changes,
    pub(super) lights: &'a LightNames,
    /// Whether the scene is the one built into the program, and so are the files it names.
    pub(super) built_in: bool,
    /// Where the scene names the graph of its environment.
    pub(super) environment: Option<Place>,
    pub(super) graphs: HashMap<PathBuf, (Graph, Arc<Document>)>,
    /// Graphs of which was told what is not done.
    pub(super) idle_told: HashSet<MaterialSource>,
    pub(super) by_hand: ByHand,
    pub(super) shaders: Vec<Arc<Shader>>,
    pub(super) uses: Vec<ShaderUse>,
    /// Time spent compiling.
    pub(super) milliseconds: f64,
    pub(super) tell: &'a mut dyn FnMut(Remark<'_>),
}

impl Materials<'_> {
    /// The shader for a use of a graph.
    pub(super) fn shader(&mut self, material: &MaterialRef) -> Result<Arc<dyn Shade>, LinkError> {
        let changed = self.changes.marked(material).cloned();
        let root = match &self.environment {
            Some(place) if *place == material.place => RootKind::Environment,
            _ => RootKind::Material,
        };
        let (mut graph, document, mut values) = match (&material.source, self.subject) {
            (MaterialSource::Subject, Some(it)) => {
                (it.graph.clone(), it.document.clone(), it.values.clone())
            }
            (MaterialSource::Subject, None) => {
                return Err(LinkError::NoSubject { place: material.place.clone() });
            }
            (MaterialSource::File(path), _) => {
                let (graph, document) = self.graph(path)?;
                (graph, document, Vec::new())
            }
        };
        if let Some(Change { object, preset, set, .. }) = &changed {
            values = bind_texts(&graph, set)
                .map_err(|error| LinkError::Value { object: object.clone(), error })?;
            if let Some(preset) = preset {
                let no_preset = |error| LinkError::Preset { object: object.clone(), error };
                values = graph.preset(preset).map_err(no_preset)?.with(values);
            }
        }
        self.set(material, &graph, &document, &mut values)?;
        if self.idle_told.insert(material.source.clone()) {
            Note::idle(&graph).into_iter().for_each(|note| self.note(note));
        }
        if let Some(node) = changed.and_then(|changed| changed.node) {
            if matches!(self.shading, Shading::ByHand(_)) {
                return Err(ShowNodeError::ByHand.into());
            }
            graph = shown_node(&graph, &node, root)?;
        }
        if material.source != MaterialSource::Subject && graph.root(root).is_none() {
            let place = material.place.clone();
            self.note(Note::Black { graph: graph.name.clone(), root, place });
        }
        let used = ShaderUse { document, root };
        match self.shading {
            Shading::Compiled(options) => self.compiled(material, used, graph, &values, options),
            Shading::ByHand(options) => match monoliths::of_graph(&graph, values.clone()) {
                Ok(monolith) => {
                    self.by_hand.found |= root == RootKind::Material;
                    Ok(Arc::from(monolith))
                }
                Err(NoMonolith::NotWritten(why)) if material.source != MaterialSource::Subject => {
                    self.by_hand.missing(why);
                    self.compiled(material, used, graph, &values, options)
                }
                Err(error) => Err(error.into()),
            },
        }
    }

    /// Adds the values that the scene sets to those that whoever looks at it gives: they have the last word.
    fn set(
        &mut self,
        material: &MaterialRef,
        graph: &Graph,
        document: &Document,
        values: &mut Vec<(String, Literal)>,
    ) -> Result<(), LinkError> {
        let (set, mut findings) = settings(material, graph, &OnDisk);
        let given: HashSet<String> = values.iter().map(|(name, _)| name.clone()).collect();
        values.extend(set.into_iter().filter(|(name, _)| !given.contains(name)));
        findings.extend(unknown_lights(self.lights, material, graph, values, Some(document)));
        if findings.is_empty() {
            return Ok(());
        }
        self.findings(&findings, 0);
        Err(LinkError::Unusable { file: PathBuf::from(&material.place.file.name) })
    }

    fn compiled(
        &mut self,
        material: &MaterialRef,
        used: ShaderUse,
        graph: Graph,
        values: &[(String, Literal)],
        options: Options,
    ) -> Result<Arc<dyn Shade>, LinkError> {
        let start = Instant::now();
        let options = Options { roots: CALLED_ROOTS, called_rays_only: true, ..options };
        let name = graph.name.clone();
        let shader = Shader::new(Arc::new(graph), values, options);
        let shader = shader.map_err(|error| {
            let error = LinkError::Compile { graph: name, error };
            self.uncompilable(material, values, error)
        })?;
        let shader = Arc::new(shader);
        self.milliseconds += start.elapsed().as_secs_f64() * 1e3;
        self.shaders.push(Arc::clone(&shader));
        self.uses.push(used);
        Ok(shader)
    }

    /// Says where in a graph is what keeps it from being compiled.
    fn uncompilable(
        &mut self,
        material: &MaterialRef,
        values: &[(String, Literal)],
        error: LinkError,
    ) -> LinkError {
        let known = match &material.source {
            MaterialSource::Subject => self.subject.map(|it| (&it.graph, &it.document)),
            MaterialSource::File(path) => self.graphs.get(path).map(|it| (&it.0, &it.1)),
        };
        let Some((graph, document)) = known else { return error };
        let findings = uncompilable(&Arc::new(graph.clone()), values, document);
        if findings.is_empty() {
            return error;
        }
        let file = PathBuf::from(&document.file.name);
        self.findings(&findings, 0);
        LinkError::Unusable { file }
    }

    /// Says where pictures are named that cannot be used; whether there are any.
    pub(super) fn tell_pictures(&mut self, scene: &SceneDescription) -> bool {
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
        self.findings(&findings, 0);
        !findings.is_empty()
    }

    fn graph(&mut self, path: &Path) -> Result<(Graph, Arc<Document>), LinkError> {
        if let Some(known) = self.graphs.get(path) {
            return Ok(known.clone());
        }
        let unusable = || LinkError::Unusable { file: path.to_owned() };
        let document = match embedded_file(path).filter(|_| self.built_in) {
            Some(text) => read(&path.display().to_string(), text.as_bytes()),
            None => read_file(path),
        };
        let document = document.map_err(|finding| {
            self.findings(&all_mistakes(*finding), 0);
            unusable()
        })?;
        let checked = check_graph(&document, self.library);
        self.findings(&checked.findings, checked.omitted);
        let known = (checked.graph.ok_or_else(unusable)?, Arc::new(document));
        self.graphs.insert(path.to_owned(), known.clone());
        Ok(known)
    }

    fn findings(&mut self, findings: &[Finding], omitted: usize) {
        (self.tell)(Remark::Findings { findings, omitted });
    }

    fn note(&mut self, note: Note) {
        (self.tell)(Remark::Note(note));
    }
}
