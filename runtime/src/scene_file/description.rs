//! A scene as its file describes it, before its materials are compiled.

use std::path::PathBuf;
use std::sync::Arc;

use phenomenon_compiler::check::Setting;
use phenomenon_compiler::diagnostics::Place;
use phenomenon_compiler::engine::Shade;
use phenomenon_compiler::graph::{Graph, RootKind};
use phenomenon_compiler::specialise::Asking;

use crate::camera::Camera;
use crate::geometry::{Mesh, ShadowTerminator, Transform};
use crate::lights::{Environment, Light};
use crate::scene::{Scene, SceneBuilder, SceneError, TraceDepth, placed_sphere};

/// A scene as its file describes it.
#[derive(Clone)]
pub struct SceneDescription {
    /// Its name.
    pub name: String,
    /// The camera.
    pub camera: Camera,
    /// The objects, in file order.
    pub objects: Vec<ObjectDescription>,
    /// The lights, in file order.
    pub lights: Vec<Light>,
    /// What rays see that leave the scene.
    pub environment: Option<EnvironmentDescription>,
    /// How it is rendered unless the command line says otherwise.
    pub options: SceneOptions,
}

/// How a scene is rendered unless the command line says otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SceneOptions {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Samples of a pixel.
    pub samples: u32,
    /// How deep rays are traced.
    pub depth: TraceDepth,
    /// Seed of all random numbers.
    pub seed: u64,
}

impl Default for SceneOptions {
    fn default() -> Self {
        Self { width: 512, height: 512, samples: 16, depth: TraceDepth::default(), seed: 0 }
    }
}

/// An object.
#[derive(Clone, Debug)]
pub struct ObjectDescription {
    /// Its name, or what it is.
    pub name: String,
    /// Its shape.
    pub shape: ShapeDescription,
    /// Where it stands.
    pub transform: Transform,
    /// What it is made of.
    pub material: MaterialRef,
    /// Where its own shadow ends, if it is a mesh with normals.
    pub terminator: ShadowTerminator,
}

/// The shape of an object.
#[derive(Clone, Debug)]
pub enum ShapeDescription {
    /// A sphere.
    Sphere {
        /// Its centre.
        center: [f64; 3],
        /// Its radius.
        radius: f64,
    },
    /// A mesh.
    Mesh(Arc<Mesh>),
}

impl ShapeDescription {
    /// Whether [`SceneBuilder`] would take the shape where a transform puts it.
    pub(super) fn check_placed(&self, transform: &Transform) -> Result<(), SceneError> {
        match self {
            ShapeDescription::Sphere { center, radius } => {
                placed_sphere(*center, *radius, transform).map(drop)
            }
            // Most meshes stand as they are, and need no copy.
            ShapeDescription::Mesh(mesh) if *transform == Transform::default() => {
                Ok(mesh.validate()?)
            }
            ShapeDescription::Mesh(mesh) => Ok(mesh.transformed(transform).map(drop)?),
        }
    }
}

/// Which graph shades something.
#[derive(Clone, Debug)]
pub struct MaterialRef {
    /// The graph.
    pub source: MaterialSource,
    /// The preset it is given, which counts after what is set.
    pub preset: Option<PresetRef>,
    /// Parameters it is given, in file order.
    pub set: Vec<Setting>,
    /// Where the scene names it.
    pub place: Place,
    /// What the caller changes about this use, by a number of the caller's; none as read from a
    /// file. Uses with different changes share no shader.
    pub change: Option<usize>,
}

/// A preset of a graph, as a scene names it.
#[derive(Clone, Debug)]
pub struct PresetRef {
    /// Its name.
    pub name: String,
    /// Where the scene names it.
    pub place: Place,
}

/// A graph a scene uses, and what for.
#[derive(Clone, Debug)]
pub struct GraphUse {
    /// The graph with its parameters.
    pub material: MaterialRef,
    /// The root that is called.
    pub root: RootKind,
}

/// Where a material's graph comes from.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum MaterialSource {
    /// The graph being looked at: `{"subject": true}`.
    Subject,
    /// A graph file; its path starts at the scene's folder.
    File(PathBuf),
}

/// What rays see that leave a scene.
#[derive(Clone)]
pub enum EnvironmentDescription {
    /// Something built in.
    BuiltIn(Environment),
    /// A graph with an environment root.
    Shader(MaterialRef),
}

/// Why no scene could be built.
#[derive(Debug, thiserror::Error)]
pub enum BuildError<E> {
    /// A material could not be had.
    #[error("a material cannot be used")]
    Material(E),
    /// An object is not usable.
    #[error("object `{object}`: {source}")]
    Object {
        /// Its name.
        object: String,
        /// What is wrong.
        source: SceneError,
    },
    /// All of it together is not usable.
    #[error(transparent)]
    Scene(SceneError),
}

impl SceneDescription {
    /// Whether an object is made of the graph being looked at.
    pub fn has_subject(&self) -> bool {
        self.materials().any(|material| material.source == MaterialSource::Subject)
    }

    /// Every reference to a graph, the environment's last.
    pub fn materials(&self) -> impl Iterator<Item = &MaterialRef> {
        self.objects.iter().map(|object| &object.material).chain(self.environment_material())
    }

    /// The environment's reference to a graph.
    pub fn environment_material(&self) -> Option<&MaterialRef> {
        match &self.environment {
            Some(EnvironmentDescription::Shader(material)) => Some(material),
            _ => None,
        }
    }

    /// Shows a graph where the scene shows the one that is looked at. One with an environment root
    /// becomes the environment; one without a material leaves the place of its object empty.
    pub fn show(&mut self, graph: &Graph) {
        let is_subject = |material: &MaterialRef| material.source == MaterialSource::Subject;
        let subject = self.materials().find(|material| is_subject(material)).cloned();
        if let Some(subject) = subject
            && graph.root(RootKind::Environment).is_some()
        {
            self.environment = Some(EnvironmentDescription::Shader(subject));
        }
        if graph.root(RootKind::Material).is_none() {
            self.objects.retain(|object| !is_subject(&object.material));
        }
    }

    /// Builds the scene; `resolve` makes shaders of its materials, once for each that differs.
    pub fn build<E>(
        &self,
        resolve: impl FnMut(&MaterialRef) -> Result<Arc<dyn Shade>, E>,
    ) -> Result<Scene, BuildError<E>> {
        self.build_asking(Asking::Guarded, resolve)
    }

    /// The same; asking for all, its renderer does all it can at every point, see [`SceneBuilder::do_everything`].
    pub fn build_asking<E>(
        &self,
        asking: Asking,
        mut resolve: impl FnMut(&MaterialRef) -> Result<Arc<dyn Shade>, E>,
    ) -> Result<Scene, BuildError<E>> {
        let mut builder = SceneBuilder::new(self.camera);
        builder.depth(self.options.depth);
        if asking == Asking::All {
            builder.do_everything();
        }
        let mut known: Vec<(&MaterialRef, u32)> = Vec::new();
        for object in &self.objects {
            let same = |(other, _): &&(&MaterialRef, u32)| equal(other, &object.material);
            let material = match known.iter().find(same) {
                Some((_, material)) => *material,
                None => {
                    let shader = resolve(&object.material).map_err(BuildError::Material)?;
                    let material = builder.material(shader);
                    known.push((&object.material, material));
                    material
                }
            };
            let transform = &object.transform;
            let added = match &object.shape {
                ShapeDescription::Sphere { center, radius } => {
                    builder.sphere(*center, *radius, transform, material)
                }
                ShapeDescription::Mesh(mesh) => {
                    builder.mesh_with(mesh, transform, material, object.terminator)
                }
            };
            if let Err(source) = added {
                return Err(BuildError::Object { object: object.name.clone(), source });
            }
        }
        for light in &self.lights {
            builder.light(light.clone());
        }
        match &self.environment {
            None => {}
            Some(EnvironmentDescription::BuiltIn(environment)) => {
                builder.environment(environment.clone());
            }
            Some(EnvironmentDescription::Shader(material)) => {
                let shader = resolve(material).map_err(BuildError::Material)?;
                builder.environment(Environment::Shader(shader));
            }
        }
        builder.build().map_err(BuildError::Scene)
    }
}

/// Whether two references give the same shader, wherever they stand.
fn equal(a: &MaterialRef, b: &MaterialRef) -> bool {
    let same = |(a, b): (&Setting, &Setting)| a.is_same(b);
    let preset = |it: &MaterialRef| it.preset.as_ref().map(|preset| preset.name.clone());
    a.source == b.source
        && a.change == b.change
        && preset(a) == preset(b)
        && a.set.len() == b.set.len()
        && a.set.iter().zip(&b.set).all(same)
}
