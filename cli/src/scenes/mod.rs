//! Scenes with their materials compiled: what `render` renders.

mod changes;
mod materials;
mod notes;

use std::collections::{HashMap, HashSet};
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::document::{Document, all_mistakes};
use phenomenon_compiler::engine::Shader;
use phenomenon_compiler::graph::{Graph, RootKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_runtime::scene::{Scene, SceneError};
use phenomenon_runtime::scene_file::{
    BuildError, EnvironmentDescription, LightNames, MaterialRef, MaterialSource, SceneDescription,
    SceneFile, SceneOptions, check_scene, default_scene, is_scene,
};

use self::materials::{Materials, Subject};
use crate::arguments::{Assignment, EngineChoice, NodePath};
use crate::failure::Failure;
use crate::graphs::{self, EngineArguments, Told};
use crate::inputs;

/// What the command line says about what is looked at.
#[derive(Clone, Debug, Default)]
pub struct Change<'a> {
    /// `--set`.
    pub set: &'a [Assignment],
    /// `--node`.
    pub node: Option<&'a NodePath>,
    /// `--scene`.
    pub stage: Option<&'a Path>,
    /// `--allow`.
    pub allow: &'a [Code],
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

/// Reads a scene, or a graph and the scene it is shown in, and compiles what it needs. What is found
/// on the way goes to standard error.
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
    let told = Told { allow: change.allow };
    let document = opened(path, told)?;
    let mut changes = Vec::new();
    let (mut scene, lights, subject) = if is_scene(&document) {
        if let Some(stage) = change.stage {
            let message =
                format!("--scene {}: {} is a scene itself", stage.display(), path.display());
            return Err(Failure::new(message, "give a graph to show in it, or leave --scene out"));
        }
        let (mut scene, lights) = described(path, &document, told)?;
        changes = changes::mark(&mut scene, change)?;
        (scene, lights, None)
    } else {
        let subject = subject(path, document, library, engine, change)?;
        let (scene, lights) = match change.stage {
            Some(stage) => self::stage(stage, path, told)?,
            None => usable(Path::new("the default scene"), default_scene(), told)?,
        };
        (scene, lights, Some(subject))
    };
    if let Some(subject) = &subject {
        show(&mut scene, &subject.graph);
    }
    let mut materials = Materials {
        library,
        engine,
        told,
        built_in: subject.is_some() && change.stage.is_none(),
        environment: scene.environment_material().map(|material| material.place.clone()),
        idle_told: subject.iter().map(|_| MaterialSource::Subject).collect::<HashSet<_>>(),
        subject,
        changes,
        lights,
        graphs: HashMap::new(),
        shaders: Vec::new(),
        milliseconds: 0.0,
    };
    let built =
        scene.build(|material| materials.shader(material)).map_err(|error| match error {
            BuildError::Material(failure) => failure,
            BuildError::Scene(SceneError::Texture(_)) if materials.tell_pictures(&scene) => {
                graphs::unusable(path)
            }
            other => {
                let help = match &other {
                    BuildError::Scene(SceneError::Texture(_)) => "use fewer or smaller pictures",
                    BuildError::Scene(_) => "leave some of its objects out",
                    _ => "change the object",
                };
                Failure::new(format!("{}: {other}", path.display()), help)
            }
        })?;
    let whole = start.elapsed().as_secs_f64() * 1e3;
    Ok(Picture {
        scene: built,
        options: scene.options,
        check_milliseconds: whole - materials.milliseconds,
        shaders: materials.shaders,
    })
}

fn opened(path: &Path, told: Told<'_>) -> Result<Document, Failure> {
    inputs::read(path).map_err(|finding| {
        told.tell(&all_mistakes(*finding), 0);
        graphs::unusable(path)
    })
}

/// The scene a graph is to be shown in.
fn stage(
    stage: &Path,
    graph: &Path,
    told: Told<'_>,
) -> Result<(SceneDescription, LightNames), Failure> {
    let document = opened(stage, told)?;
    let flag = format!("--scene {}", stage.display());
    if !is_scene(&document) {
        let help = format!("write `render {} --scene SCENE.json`", graph.display());
        return Err(Failure::new(format!("{flag}: this file is no scene"), help));
    }
    let (scene, lights) = described(stage, &document, told)?;
    if !scene.has_subject() {
        return Err(Failure::new(
            format!("{flag}: no object of this scene shows the graph"),
            "give one of its objects \"material\": { \"subject\": true }",
        ));
    }
    Ok((scene, lights))
}

fn subject(
    path: &Path,
    document: Document,
    library: &NodeLibrary,
    engine: &EngineArguments,
    change: &Change<'_>,
) -> Result<Subject, Failure> {
    let told = Told { allow: change.allow };
    let graph = told.checked(path, check_graph(&document, library))?;
    let document = Arc::new(document);
    let values = graphs::bind(&graph, "", change.set)?;
    notes::tell_idle(&graph);
    let graph = match change.node {
        Some(node) => materials::shown_node(graph, library, engine, node, RootKind::Material)?,
        None => graph,
    };
    notes::tell_unseen(&graph);
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

fn described(
    path: &Path,
    document: &Document,
    told: Told<'_>,
) -> Result<(SceneDescription, LightNames), Failure> {
    usable(path, check_scene(document, inputs::folder(path)), told)
}

fn usable(
    path: &Path,
    file: SceneFile,
    told: Told<'_>,
) -> Result<(SceneDescription, LightNames), Failure> {
    told.tell(&file.findings, 0);
    match (file.scene, file.lights) {
        (Some(scene), Some(lights)) => Ok((scene, lights)),
        _ => Err(graphs::unusable(path)),
    }
}
