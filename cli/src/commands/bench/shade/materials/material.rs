//! The materials of the thesis by name, and where each is shaded.

use std::convert::Infallible;
use std::sync::Arc;

use clap::ValueEnum;
use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document::read;
use phenomenon_compiler::effects::Renderer;
use phenomenon_compiler::engine::{Engine, Options, Shade, Shaded, Shader};
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::state::{Camera, Object, Objects, State, Surface};
use phenomenon_runtime::monoliths;
use phenomenon_runtime::render::{CALLED_ROOTS, Context, Settings, render};
use phenomenon_runtime::scene::Scene;
use phenomenon_runtime::scene_file::{MaterialSource, default_scene, embedded_file};

use super::listening::Listening;
use super::recorded::Recorded;
use super::recording::{Asked, Recording};
use super::table::Table;
use crate::commands::bench::shade::points::{calls, pass};
use crate::commands::bench::workloads::STATES;
use crate::failure::Failure;

/// A material of the thesis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
#[value(rename_all = "snake_case")]
pub enum Material {
    /// One colour
    ConstantSimple,
    /// Green glass
    AdvancedGlass,
    /// Brushed metal
    AnisoBrdf,
    /// Tinted glass under a rainbow
    Sunglasses,
    /// Thickness as brightness
    Xray,
    /// Shot silk
    Silk,
    /// A compact disc
    Cd,
    /// Snow with glitter
    Snow,
}

/// Points of one call while answers are recorded.
const BATCH: usize = 256;

/// Width and height of the picture whose points are shaded, in pixels.
const SIDE: u32 = 96;

impl Material {
    /// All of them, in the order of the thesis.
    pub const ALL: [Self; 8] = [
        Self::ConstantSimple,
        Self::AdvancedGlass,
        Self::AnisoBrdf,
        Self::Sunglasses,
        Self::Xray,
        Self::Silk,
        Self::Cd,
        Self::Snow,
    ];

    /// Name of its graph.
    pub fn name(self) -> &'static str {
        match self {
            Self::ConstantSimple => "constant_simple",
            Self::AdvancedGlass => "advanced_glass",
            Self::AnisoBrdf => "aniso_brdf",
            Self::Sunglasses => "sunglasses",
            Self::Xray => "xray",
            Self::Silk => "silk",
            Self::Cd => "cd",
            Self::Snow => "snow",
        }
    }
}

/// A material in the default scene, with the points of it that are shaded and what is known there.
pub struct Stage {
    /// Its graph.
    pub graph: Arc<Graph>,
    scene: Scene,
    states: Vec<State>,
    objects: Arc<[Object]>,
    camera: Camera,
    table: Table,
}

impl Stage {
    /// Sets a material up.
    ///
    /// # Errors
    /// It cannot be compiled or rendered: a mistake of ours.
    pub fn new(material: Material, library: &NodeLibrary) -> Result<Self, Failure> {
        let broken = |what: &dyn std::fmt::Display| {
            Failure::new(format!("the material {} cannot be used: {what}", material.name()), "")
        };
        let graph = monoliths::graph_by_hand(material.name(), library);
        let graph = Arc::new(graph.ok_or_else(|| broken(&"it has no monolith"))?);
        let subject = Shader::new(Arc::clone(&graph), &[], options());
        let subject = subject.map_err(|error| broken(&error))?;
        let listening = Arc::new(Listening::to(Arc::new(subject)));
        let scene = scene(&listening, library).ok_or_else(|| broken(&"no default scene"))?;
        let settings =
            Settings { width: SIDE, height: SIDE, samples: 1, threads: 1, ..Settings::default() };
        render(&scene, &settings, &|_, _| ()).map_err(|error| broken(&error))?;
        let states = chosen(&listening.heard()).ok_or_else(|| broken(&"nobody sees it"))?;
        let context = Context::new(&scene, 1);
        let known = context.objects();
        let surfaces = states.iter().map(|state| surface(known, state)).collect();
        let (objects, camera) = (known.objects.into(), *known.camera);
        drop(context);
        Ok(Self { graph, scene, states, objects, camera, table: Table::of(surfaces) })
    }

    /// The points, of one ray type after the other.
    pub fn states(&self) -> &[State] {
        &self.states
    }

    /// Shades all points once, and keeps what the scene answers. Tells how much was asked.
    pub fn record(&mut self, shader: &dyn Shade) -> Asked {
        let mut context = Context::new(&self.scene, BATCH);
        let mut recording =
            Recording { table: &mut self.table, real: &mut context, asked: Asked::default() };
        let mut results = vec![Shaded::default(); self.states.len()];
        let calls = calls(&self.states, BATCH);
        pass(shader, &self.states, &calls, &mut recording, &mut results);
        recording.asked
    }

    /// Who answers from what was recorded.
    pub fn recorded(self) -> Recorded {
        let Self { table, objects, camera, .. } = self;
        Recorded { table: Arc::new(table), objects, camera, unknown: 0 }
    }
}

/// As the renderer compiles them, without machine code: contenders would share it.
fn options() -> Options {
    let engine = Engine::Batch;
    Options { engine, roots: CALLED_ROOTS, called_rays_only: true, ..Options::default() }
}

/// The default scene with a shader for its subject; none where it has become unusable.
fn scene(subject: &Arc<Listening>, library: &NodeLibrary) -> Option<Scene> {
    let description = default_scene().scene?;
    let built = description.build(|material| -> Result<Arc<dyn Shade>, Option<Infallible>> {
        let MaterialSource::File(path) = &material.source else {
            return Ok(Arc::clone(subject) as Arc<dyn Shade>);
        };
        let text = embedded_file(path).ok_or(None)?;
        let document = read(&path.display().to_string(), text.as_bytes()).map_err(|_| None)?;
        let graph = check_graph(&document, library).graph.ok_or(None)?;
        Ok(Arc::new(Shader::new(Arc::new(graph), &[], options()).map_err(|_| None)?))
    });
    built.ok()
}

/// As many as are shaded, evenly from all of them, each type of ray by itself, and each with its number for a
/// path; none if there are no points.
fn chosen(heard: &[State]) -> Option<Vec<State>> {
    let at = |number: usize| number * heard.len() / STATES;
    let some = (0..STATES).map(|number| heard.get(at(number)).copied());
    let mut some: Vec<State> = some.collect::<Option<_>>()?;
    some.sort_by_key(|state| state.ray_type as i32);
    for (number, state) in some.iter_mut().enumerate() {
        state.path = number as u64;
    }
    Some(some)
}

fn surface(known: Objects<'_>, state: &State) -> Surface {
    let of = known.surfaces;
    Surface {
        derivative_u: of.derivative_u(state),
        derivative_v: of.derivative_v(state),
        vertex_color: of.vertex_color(state),
        second_uv: of.second_uv(state),
        footprint: of.footprint(state),
    }
}
