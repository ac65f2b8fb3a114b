//! Scenes with their materials compiled: what `render` renders.

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::diagnostics::Place;
use phenomenon_compiler::document::{Document, listed, read, read_file};
use phenomenon_compiler::engine::{Options, Shade, Shader};
use phenomenon_compiler::graph::{Graph, RootKind};
use phenomenon_compiler::nodes::{Literal, NodeLibrary};
use phenomenon_runtime::monoliths;
use phenomenon_runtime::render::CALLED_ROOTS;
use phenomenon_runtime::scene::{
    BuildError, EnvironmentDescription, LightNames, MaterialRef, MaterialSource, Scene,
    SceneDescription, SceneFile, SceneOptions, check_scene, default_scene, embedded_file, is_scene,
    settings, unknown_lights,
};

use crate::arguments::{Assignment, EngineChoice, NodePath};
use crate::failure::Failure;
use crate::graphs::{self, EngineArguments};
use crate::inputs;
use crate::report;
use crate::terminal;

/// What the command line changes about the graph that is looked at.
#[derive(Debug)]
pub struct Change<'a> {
    /// `--set`.
    pub set: &'a [Assignment],
    /// `--node`.
    pub node: Option<&'a NodePath>,
}

/// A scene ready to be rendered.
pub struct Picture {
    /// The scene.
    pub scene: Scene,
    /// How it is rendered unless flags say otherwise.
    pub options: SceneOptions,
    /// Time spent reading and checking, in milliseconds.
    pub check_milliseconds: f64,
    shaders: Vec<Arc<Shader>>,
}

impl Picture {
    /// Time spent compiling, in milliseconds.
    pub fn compile_milliseconds(&self) -> f64 {
        self.shaders.iter().map(|shader| shader.compile_milliseconds()).sum()
    }

    /// Points shaded by each engine; `all` is their number, which a monolith does not count itself.
    pub fn points(&self, engine: EngineChoice, all: u64) -> Vec<(&'static str, u64)> {
        if engine == EngineChoice::Monolith {
            return vec![("monolith", all)];
        }
        let mut points: Vec<(&'static str, u64)> = Vec::new();
        for (engine, count) in self.shaders.iter().flat_map(|shader| shader.points()) {
            match points.iter_mut().find(|(known, _)| *known == engine) {
                Some((_, sum)) => *sum += count,
                None => points.push((engine, count)),
            }
        }
        points
    }
}

/// Reads a scene, or a graph and the default scene round it, and compiles what it needs. What is
/// found on the way goes to standard error.
///
/// # Errors
/// A file that cannot be used, or a value that does not suit its name.
pub fn load(
    path: &Path,
    library: &Arc<NodeLibrary>,
    engine: &EngineArguments,
    change: &Change<'_>,
) -> Result<Picture, Failure> {
    let start = Instant::now();
    let document = inputs::read(path).map_err(|finding| {
        report::tell(&[*finding], 0);
        graphs::unusable(path)
    })?;
    let (scene, lights, subject) = if is_scene(&document) {
        if !change.set.is_empty() || change.node.is_some() {
            return Err(Failure::new(
                "--set and --node are for graphs, and this is a scene",
                "in the scene, write `set` beside the file of the material",
            ));
        }
        let folder = inputs::folder(path);
        let (scene, lights) = described(path, check_scene(&document, folder))?;
        (scene, lights, None)
    } else {
        let subject = subject(path, document, library, engine, change)?;
        let (mut scene, lights) = described(Path::new("the default scene"), default_scene())?;
        show(&mut scene, &subject.graph);
        (scene, lights, Some(subject))
    };
    let mut materials = Materials {
        library,
        engine,
        subject,
        lights,
        graphs: HashMap::new(),
        told: HashSet::new(),
        shaders: Vec::new(),
        milliseconds: 0.0,
    };
    let built =
        scene.build(|material| materials.shader(material)).map_err(|error| match error {
            BuildError::Material(failure) => failure,
            other => Failure::new(format!("{}: {other}", path.display()), "change the object"),
        })?;
    let whole = start.elapsed().as_secs_f64() * 1e3;
    Ok(Picture {
        scene: built,
        options: scene.options,
        check_milliseconds: whole - materials.milliseconds,
        shaders: materials.shaders,
    })
}

/// The graph that is looked at, with the values it is given.
struct Subject {
    graph: Graph,
    document: Arc<Document>,
    values: Vec<(String, Literal)>,
}

fn subject(
    path: &Path,
    document: Document,
    library: &NodeLibrary,
    engine: &EngineArguments,
    change: &Change<'_>,
) -> Result<Subject, Failure> {
    let graph = graphs::checked(path, check_graph(&document, library))?;
    let document = Arc::new(document);
    let values = graphs::bind(&graph, change.set)?;
    let Some(node) = change.node else { return Ok(Subject { graph, document, values }) };
    if engine.engine == EngineChoice::Monolith {
        return Err(Failure::new(
            "--engine monolith: a monolith has no nodes to show",
            "choose walk, batch or jit",
        ));
    }
    let (node, output) = node.find(&graph, library)?;
    let graph = graph
        .with_root(library, node, output.unwrap_or(0))
        .map_err(|error| Failure::new(format!("--node: {error}"), ""))?;
    Ok(Subject { graph, document, values })
}

/// A graph with an environment root becomes the environment; one without a material leaves the
/// place of its object empty.
fn show(scene: &mut SceneDescription, graph: &Graph) {
    let is_subject = |material: &MaterialRef| material.source == MaterialSource::Subject;
    let subject = scene.materials().find(|material| is_subject(material)).cloned();
    if let Some(subject) = subject
        && graph.root(RootKind::Environment).is_some()
    {
        scene.environment = Some(EnvironmentDescription::Shader(subject));
    }
    if graph.root(RootKind::Material).is_none() {
        scene.objects.retain(|object| !is_subject(&object.material));
    }
}

fn described(path: &Path, file: SceneFile) -> Result<(SceneDescription, LightNames), Failure> {
    report::tell(&file.findings, 0);
    match (file.scene, file.lights) {
        (Some(scene), Some(lights)) => Ok((scene, lights)),
        _ => Err(graphs::unusable(path)),
    }
}

/// Makes shaders of the materials of a scene.
struct Materials<'a> {
    lights: LightNames,
    library: &'a Arc<NodeLibrary>,
    engine: &'a EngineArguments,
    subject: Option<Subject>,
    graphs: HashMap<PathBuf, (Graph, Arc<Document>)>,
    /// Names of graphs of which was told what is not done.
    told: HashSet<String>,
    shaders: Vec<Arc<Shader>>,
    /// Time spent compiling.
    milliseconds: f64,
}

impl Materials<'_> {
    fn shader(&mut self, material: &MaterialRef) -> Result<Arc<dyn Shade>, Failure> {
        let (graph, document, mut values) = match &material.source {
            MaterialSource::Subject => match &self.subject {
                Some(it) => (it.graph.clone(), it.document.clone(), it.values.clone()),
                None => {
                    return Err(Failure::new(
                        format!("{}: no graph is looked at", shown(&material.place)),
                        "name the file of a graph instead of `subject`",
                    ));
                }
            },
            MaterialSource::File(path) => {
                let (graph, document) = self.graph(path)?;
                (graph, document, Vec::new())
            }
        };
        let (set, mut findings) = settings(material, &graph);
        for (name, literal) in set {
            // The command line has the last word.
            if values.iter().all(|(known, _)| *known != name) {
                values.push((name, literal));
            }
        }
        findings.extend(unknown_lights(&self.lights, material, &graph, &values, Some(&document)));
        if !findings.is_empty() {
            report::tell(&findings, 0);
            return Err(graphs::unusable(Path::new(&material.place.file.name)));
        }
        if self.told.insert(graph.name.clone()) {
            tell_idle_roots(&graph);
            tell_requirements(&graph);
        }
        match self.engine.engine.compiled() {
            Some(engine) => {
                let start = Instant::now();
                let options = Options { roots: CALLED_ROOTS, ..self.engine.options(engine) };
                let shader = Arc::new(graphs::compile(graph, self.library, &values, options)?);
                self.milliseconds += start.elapsed().as_secs_f64() * 1e3;
                self.shaders.push(Arc::clone(&shader));
                Ok(shader)
            }
            None => monolith(&graph.name, &values),
        }
    }

    fn graph(&mut self, path: &Path) -> Result<(Graph, Arc<Document>), Failure> {
        if let Some(known) = self.graphs.get(path) {
            return Ok(known.clone());
        }
        let document = match embedded_file(path).filter(|_| self.subject.is_some()) {
            Some(text) => read(&path.display().to_string(), text.as_bytes()),
            None => read_file(path),
        };
        let document = document.map_err(|finding| {
            report::tell(&[*finding], 0);
            graphs::unusable(path)
        })?;
        let graph = graphs::checked(path, check_graph(&document, self.library))?;
        let known = (graph, Arc::new(document));
        self.graphs.insert(path.to_owned(), known.clone());
        Ok(known)
    }
}

/// Says which roots of a graph no picture depends on.
fn tell_idle_roots(graph: &Graph) {
    let kinds = graph.roots.iter().map(|root| root.kind);
    let idle: Vec<&str> =
        kinds.filter(|kind| !CALLED_ROOTS.contains(kind)).map(RootKind::name).collect();
    if !idle.is_empty() {
        terminal::tell(&format!(
            "note: `{}` is checked whole, but this renderer does not call shaders of type {}; it calls {}",
            graph.name,
            listed(idle),
            listed(CALLED_ROOTS.iter().map(|kind| kind.name())),
        ));
    }
}

/// Says which requirements of a graph this renderer does not meet.
fn tell_requirements(graph: &Graph) {
    let requirements = &graph.requirements;
    let choices = requirements.choices.iter().filter(|choice| !MET.contains(choice));
    let mut unmet: Vec<String> =
        choices.map(|(key, value)| format!("`{key}` to be `{value}`")).collect();
    if requirements.texture > 1 {
        unmet.push(format!("{} texture spaces", requirements.texture));
    }
    if requirements.bump > 0 {
        unmet.push(format!("{} bump bases", requirements.bump));
    }
    if !requirements.derivative.is_empty() {
        unmet.push("surface derivatives".into());
    }
    if requirements.volume_level > 0 {
        unmet.push("volumes in order".into());
    }
    if !unmet.is_empty() {
        let (name, unmet) = (&graph.name, unmet.join(", "));
        terminal::tell(&format!(
            "note: `{name}` requires {unmet}, which this renderer does not do"
        ));
    }
}

/// What this renderer does anyway: it traces all rays, casts shadows and hits both faces.
const MET: [(&&str, &&str); 4] =
    [(&"face", &"both"), (&"scanline", &"off"), (&"shadow", &"on"), (&"trace", &"on")];

fn monolith(name: &str, values: &[(String, Literal)]) -> Result<Arc<dyn Shade>, Failure> {
    match monoliths::find(name, values) {
        Some(Ok(shader)) => Ok(Arc::from(shader)),
        Some(Err(error)) => Err(Failure::new(error, "leave it out, or choose another engine")),
        None => Err(Failure::new(
            format!("--engine monolith: `{name}` is not written by hand"),
            format!("these are: {}", monoliths::NAMES.join(", ")),
        )),
    }
}

fn shown(place: &Place) -> String {
    let (line, column) = place.line_column();
    format!("{}:{line}:{column}", place.file.name)
}
