//! Scenes with their materials compiled: what `render` renders.

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::diagnostics::Place;
use phenomenon_compiler::document::{Document, listed, nearest, read, read_file};
use phenomenon_compiler::engine::{Options, Shade, Shader};
use phenomenon_compiler::graph::{Binding, Graph, RootKind};
use phenomenon_compiler::nodes::{Literal, NodeLibrary};
use phenomenon_runtime::monoliths;
use phenomenon_runtime::render::CALLED_ROOTS;
use phenomenon_runtime::scene::{
    BuildError, EnvironmentDescription, MaterialRef, MaterialSource, Scene, SceneDescription,
    SceneFile, SceneOptions, default_scene, embedded_file, is_scene, read_scene,
};

use crate::arguments::{Assignment, EngineChoice, NodePath};
use crate::failure::Failure;
use crate::graphs::{self, EngineArguments};
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
    let document = read_file(path).map_err(|finding| {
        report::tell(&[*finding], 0);
        graphs::unusable(path)
    })?;
    let (scene, subject) = if is_scene(&document) {
        if !change.set.is_empty() || change.node.is_some() {
            return Err(Failure::new(
                "--set and --node are for graphs, and this is a scene",
                "in the scene, write `set` beside the file of the material",
            ));
        }
        let folder = path.parent().unwrap_or(Path::new(""));
        let text = document.file.text.as_bytes();
        (described(path, read_scene(&document.file.name, text, folder))?, None)
    } else {
        let subject = subject(path, &document, library, engine, change)?;
        let mut scene = described(Path::new("the default scene"), default_scene())?;
        show(&mut scene, &subject.graph);
        (scene, Some(subject))
    };
    let mut materials = Materials {
        library,
        engine,
        subject,
        lights: scene.lights.iter().map(|light| light.name.clone()).collect(),
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
    values: Vec<(String, Literal)>,
}

fn subject(
    path: &Path,
    document: &Document,
    library: &NodeLibrary,
    engine: &EngineArguments,
    change: &Change<'_>,
) -> Result<Subject, Failure> {
    let graph = graphs::checked(path, check_graph(document, library))?;
    let values = graphs::bind(&graph, change.set)?;
    let Some(node) = change.node else { return Ok(Subject { graph, values }) };
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
    Ok(Subject { graph, values })
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

fn described(path: &Path, file: SceneFile) -> Result<SceneDescription, Failure> {
    report::tell(&file.findings, 0);
    file.scene.ok_or_else(|| graphs::unusable(path))
}

/// Makes shaders of the materials of a scene.
struct Materials<'a> {
    /// Names of the scene's lights.
    lights: Vec<String>,
    library: &'a Arc<NodeLibrary>,
    engine: &'a EngineArguments,
    subject: Option<Subject>,
    graphs: HashMap<PathBuf, Graph>,
    /// Names of graphs of which was told what is not done.
    told: HashSet<String>,
    shaders: Vec<Arc<Shader>>,
    /// Time spent compiling.
    milliseconds: f64,
}

impl Materials<'_> {
    /// Refuses names of lights that the scene does not have: they would light nothing, unsaid.
    fn know_lights(
        &self,
        graph: &Graph,
        values: &[(String, Literal)],
        material: &MaterialRef,
    ) -> Result<(), Failure> {
        let inputs = graph.nodes.iter().flat_map(|node| &node.inputs);
        let literals = inputs.filter_map(|binding| match binding {
            Binding::Literal(literal) => Some(literal),
            _ => None,
        });
        let parameters = graph.parameters.iter().map(|parameter| {
            let given = values.iter().find(|(name, _)| *name == parameter.name);
            given.map_or(&parameter.default, |(_, literal)| literal)
        });
        for literal in literals.chain(parameters) {
            let Literal::Lights(names) = literal else { continue };
            let Some(unknown) = names.iter().find(|name| !self.lights.contains(name)) else {
                continue;
            };
            let known = || self.lights.iter().map(String::as_str);
            let help = match nearest(unknown, known()) {
                Some(near) => near.help(),
                None => format!("its lights are {}", known().collect::<Vec<_>>().join(", ")),
            };
            let place = shown(&material.place);
            let message = format!(
                "{place}: `{}` asks for the light `{unknown}`, which the scene does not have",
                graph.name
            );
            return Err(Failure::new(message, help));
        }
        Ok(())
    }

    fn shader(&mut self, material: &MaterialRef) -> Result<Arc<dyn Shade>, Failure> {
        let (graph, mut values) = match &material.source {
            MaterialSource::Subject => match &self.subject {
                Some(subject) => (subject.graph.clone(), subject.values.clone()),
                None => {
                    return Err(Failure::new(
                        format!("{}: no graph is looked at", shown(&material.place)),
                        "name the file of a graph instead of `subject`",
                    ));
                }
            },
            MaterialSource::File(path) => (self.graph(path)?, Vec::new()),
        };
        for set in &material.set {
            let literal = graph
                .bind(&set.name, &set.text)
                .map_err(|error| Failure::new(format!("{}: {error}", shown(&set.place)), ""))?;
            // The command line has the last word.
            if values.iter().all(|(name, _)| *name != set.name) {
                values.push((set.name.clone(), literal));
            }
        }
        self.know_lights(&graph, &values, material)?;
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

    fn graph(&mut self, path: &Path) -> Result<Graph, Failure> {
        if let Some(graph) = self.graphs.get(path) {
            return Ok(graph.clone());
        }
        let graph = match embedded_file(path).filter(|_| self.subject.is_some()) {
            Some(text) => {
                let document = read(&path.display().to_string(), text.as_bytes());
                let document = document.map_err(|finding| {
                    report::tell(&[*finding], 0);
                    graphs::unusable(path)
                })?;
                graphs::checked(path, check_graph(&document, self.library))?
            }
            None => graphs::read(path, self.library)?,
        };
        self.graphs.insert(path.to_owned(), graph.clone());
        Ok(graph)
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
