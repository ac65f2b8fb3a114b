//! Reading a scene, or a graph and the scene it is shown in.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document::{Document, all_mistakes};
use phenomenon_compiler::engine::{Engine, Evaluations, Options, Shader};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_runtime::link::{
    Changes, Ledger, Linker, Note, Remark, ShaderUse, Shading, ShowNodeError, Subject, shown_node,
};
use phenomenon_runtime::scene::Scene;
use phenomenon_runtime::scene_file::{
    LightNames, SceneDescription, SceneFile, SceneOptions, check_scene, default_scene, is_scene,
};

use super::changes;
use super::flags::Flags;
use super::refused::refused;
use crate::arguments::EngineChoice;
use crate::failure::Failure;
use crate::graphs::{self, EngineArguments, Told};
use crate::inputs;
use crate::terminal;

/// A scene ready to be rendered.
pub struct Picture {
    /// The scene.
    pub scene: Scene,
    /// How it is rendered unless flags say otherwise.
    pub options: SceneOptions,
    /// Time spent reading and checking, in milliseconds.
    pub check_milliseconds: f64,
    shaders: Vec<Arc<Shader>>,
    uses: Vec<ShaderUse>,
}

impl Picture {
    /// Whether any of its materials is compiled.
    pub fn compiles(&self) -> bool {
        !self.shaders.is_empty()
    }

    /// Time spent compiling, in milliseconds.
    pub fn compile_milliseconds(&self) -> f64 {
        self.shaders.iter().map(|shader| shader.compile_milliseconds()).sum()
    }

    /// What it calls for.
    ///
    /// # Errors
    /// None, for graphs that were compiled.
    pub fn ledger(&self) -> Result<Ledger, Failure> {
        Ledger::of(&self.scene, &self.shaders, &self.uses).map_err(|error| Failure::new(error, ""))
    }

    /// Evaluations of nodes by each engine, if they were counted; a monolith has no nodes.
    pub fn evaluations(&self) -> BTreeMap<&'static str, Evaluations> {
        let mut evaluations: BTreeMap<_, Evaluations> = BTreeMap::new();
        for (engine, count) in self.shaders.iter().flat_map(|shader| shader.evaluations()) {
            *evaluations.entry(engine).or_default() += count;
        }
        evaluations
    }

    /// Fails where the jit was asked for and could not make the code of some material.
    ///
    /// # Errors
    /// What it could not do.
    pub fn require_jit(&self) -> Result<(), Failure> {
        let mut failures = self.shaders.iter().filter_map(|shader| shader.jit_failure());
        failures.next().map_or(Ok(()), |error| Err(graphs::jit_failed(error)))
    }

    /// Points shaded by each engine; `all` is their number, for a monolith does not count its own: the rest is its.
    pub fn points(&self, engine: EngineChoice, all: u64) -> Vec<(&'static str, u64)> {
        let mut points: Vec<(&'static str, u64)> = Vec::new();
        for (engine, count) in self.shaders.iter().flat_map(|shader| shader.points()) {
            match points.iter_mut().find(|(known, _)| *known == engine) {
                Some((_, sum)) => *sum += count,
                None => points.push((engine, count)),
            }
        }
        if engine == EngineChoice::Monolith {
            let compiled: u64 = points.iter().map(|(_, count)| count).sum();
            points.insert(0, ("monolith", all.saturating_sub(compiled)));
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
    library: &NodeLibrary,
    engine: &EngineArguments,
    flags: &Flags<'_>,
) -> Result<Picture, Failure> {
    let start = Instant::now();
    let told = Told { allow: flags.allow, errors_only: flags.silent };
    let document = opened(path, told)?;
    let mut changes = Changes::default();
    let (mut scene, lights, subject) = if is_scene(&document) {
        if let Some(stage) = flags.stage {
            let message =
                format!("--scene {}: {} is a scene itself", stage.display(), path.display());
            return Err(Failure::new(message, "give a graph to show in it, or leave --scene out"));
        }
        let (mut scene, lights) = described(path, &document, told)?;
        changes = changes::mark(&mut scene, flags)?;
        (scene, lights, None)
    } else {
        let subject = subject(path, document, library, engine, flags)?;
        let (scene, lights) = match flags.stage {
            Some(stage) => self::stage(stage, path, told)?,
            None => usable(Path::new("the default scene"), default_scene(), told)?,
        };
        (scene, lights, Some(subject))
    };
    if let Some(subject) = &subject {
        scene.show(&subject.graph);
    }
    let linker = Linker {
        library,
        shading: match engine.engine.compiled() {
            Some(compiled) => {
                let Flags { count, asking, .. } = *flags;
                Shading::Compiled(Options { count, asking, ..engine.options(compiled) })
            }
            None => Shading::ByHand(engine.options(Engine::Auto)),
        },
        subject: subject.as_ref(),
        changes: &changes,
        built_in: subject.is_some() && flags.stage.is_none(),
    };
    let linked = linker.link(&scene, &lights, &mut |what| tell(told, &what));
    let linked = linked.map_err(|error| refused(path, error))?;
    let whole = start.elapsed().as_secs_f64() * 1e3;
    Ok(Picture {
        scene: linked.scene,
        options: scene.options,
        check_milliseconds: whole - linked.compile_milliseconds,
        shaders: linked.shaders,
        uses: linked.uses,
    })
}

fn tell(told: Told<'_>, what: &Remark<'_>) {
    match what {
        Remark::Findings { findings, omitted } => told.tell(findings, *omitted),
        Remark::Note(note) => tell_note(told, note),
    }
}

fn tell_note(told: Told<'_>, note: &Note) {
    if !told.errors_only {
        terminal::tell(&format!("note: {note}"));
    }
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
    flags: &Flags<'_>,
) -> Result<Subject, Failure> {
    let told = Told { allow: flags.allow, errors_only: flags.silent };
    let graph = told.checked(path, check_graph(&document, library))?;
    let document = Arc::new(document);
    let preset = match flags.preset {
        [] => None,
        [preset] => Some(preset.as_str()),
        [_, again, ..] => {
            let message = format!("--preset {again}: a graph has one preset at a time");
            return Err(Failure::new(message, "leave the others out; --set changes single values"));
        }
    };
    let values = graphs::bind(&graph, preset, flags.set)?;
    Note::idle(&graph).iter().for_each(|note| tell_note(told, note));
    let graph = match flags.node {
        Some(_) if engine.engine == EngineChoice::Monolith => {
            return Err(graphs::not_shown(&ShowNodeError::ByHand));
        }
        Some(node) => shown_node(&graph, node, RootKind::Material)
            .map_err(|error| graphs::not_shown(&error))?,
        None => graph,
    };
    Note::unseen(&graph).iter().for_each(|note| tell_note(told, note));
    Ok(Subject { graph, document, values })
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
