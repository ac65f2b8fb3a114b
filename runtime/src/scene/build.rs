//! Building a scene.

use std::sync::{Arc, OnceLock};
use std::time::Instant;

use glam::DVec3;
use phenomenon_compiler::effects::EffectSet;
use phenomenon_compiler::engine::Shade;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::{self, Hit};

use super::called_for::CalledFor;
use super::depth::TraceDepth;
use super::object::Object;
use crate::bvh::{PrimitiveId, Tree, TreeError};
use crate::camera::Camera;
use crate::geometry::{
    COORDINATE_LIMIT, Mesh, MeshError, PreparedRay, Primitive, RawHit, ShadowTerminator, Shape,
    Sphere, Surface, Transform, double, single,
};
use crate::lights::{DirectionTable, Environment, Light};
use crate::texture::{TextureError, Textures};

/// Why a scene could not be built.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// A mesh is not usable.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// A sphere is not usable.
    #[error("a sphere needs a finite centre and a radius above 0, both at most 1e12 in magnitude")]
    BadSphere,
    /// A sphere would become an ellipsoid.
    #[error("a sphere can be scaled only by the same factor in every direction")]
    UnevenSphere,
    /// A texture of a shader is not usable.
    #[error(transparent)]
    Texture(#[from] TextureError),
    /// No tree could be built.
    #[error(transparent)]
    Tree(#[from] TreeError),
}

/// Collects what a scene is made of.
pub struct SceneBuilder {
    camera: Camera,
    depth: TraceDepth,
    primitives: Vec<(PrimitiveId, Primitive)>,
    objects: Vec<Object>,
    materials: Vec<Arc<dyn Shade>>,
    lights: Vec<Light>,
    environment: Option<Environment>,
    does_everything: bool,
}

/// A scene ready to be rendered.
pub struct Scene {
    pub(crate) tree: Tree,
    pub(crate) materials: Vec<Material>,
    pub(crate) lights: Vec<Light>,
    pub(crate) environment: Option<Environment>,
    /// How bright the environment is in all directions, once a sample of it has been asked for.
    pub(crate) directions: OnceLock<Option<DirectionTable>>,
    pub(crate) camera: Camera,
    pub(crate) depth: TraceDepth,
    /// Middle of the box round everything, and half its diagonal.
    pub(crate) extent: (DVec3, f64),
    pub(super) objects: Vec<Object>,
    /// What shaders can know of them.
    pub(crate) known_objects: Vec<state::Object>,
    /// What they can know of the camera.
    pub(crate) known_camera: state::Camera,
    pub(crate) textures: Textures,
    /// What its shaders call for.
    pub(crate) called_for: CalledFor,
    /// Whether everything else is done as well, and thrown away.
    pub(crate) does_everything: bool,
    /// Time it took to build the tree.
    pub(crate) tree_milliseconds: f64,
}

/// A material with the roots it has.
pub(crate) struct Material {
    pub(crate) shader: Arc<dyn Shade>,
    pub(crate) has_material: bool,
    pub(crate) has_shadow: bool,
    /// What its points may ask for.
    pub(crate) effects: EffectSet,
}

impl SceneBuilder {
    /// An empty scene.
    pub fn new(camera: Camera) -> Self {
        Self {
            camera,
            depth: TraceDepth::default(),
            primitives: Vec::new(),
            objects: Vec::new(),
            materials: Vec::new(),
            lights: Vec::new(),
            environment: None,
            does_everything: false,
        }
    }

    /// Sets the trace depth.
    pub fn depth(&mut self, depth: TraceDepth) -> &mut Self {
        self.depth = depth;
        self
    }

    /// Has the renderer do all it can at every point, whether anything calls for it or not. No picture changes: it
    /// is the baseline of what is saved by leaving out the rest.
    pub fn do_everything(&mut self) -> &mut Self {
        self.does_everything = true;
        self
    }

    /// Sets what rays see that leave the scene.
    pub fn environment(&mut self, environment: Environment) -> &mut Self {
        self.environment = Some(environment);
        self
    }

    /// Adds a light.
    pub fn light(&mut self, light: Light) -> &mut Self {
        self.lights.push(light);
        self
    }

    /// Adds a material; objects name it by the number returned.
    pub fn material(&mut self, shader: Arc<dyn Shade>) -> u32 {
        self.materials.push(shader);
        (self.materials.len() - 1) as u32
    }

    /// Adds a sphere.
    pub fn sphere(
        &mut self,
        center: [f64; 3],
        radius: f64,
        transform: &Transform,
        material: u32,
    ) -> Result<&mut Self, SceneError> {
        let sphere = placed_sphere(center, radius, transform)?;
        let id = PrimitiveId { object: self.objects.len() as u32, primitive: 0 };
        self.primitives.push((id, Primitive::Sphere(sphere)));
        let terminator = ShadowTerminator::default();
        let transform = *transform;
        let shape = Shape::Sphere(sphere);
        self.objects.push(Object { shape, transform, material, terminator });
        Ok(self)
    }

    /// Adds a mesh. Where it has normals, its own shadow ends as on a round surface.
    pub fn mesh(
        &mut self,
        mesh: &Mesh,
        transform: &Transform,
        material: u32,
    ) -> Result<&mut Self, SceneError> {
        self.mesh_with(mesh, transform, material, ShadowTerminator::default())
    }

    /// Adds a mesh whose own shadow ends as said.
    pub fn mesh_with(
        &mut self,
        mesh: &Mesh,
        transform: &Transform,
        material: u32,
        terminator: ShadowTerminator,
    ) -> Result<&mut Self, SceneError> {
        let mesh = mesh.transformed(transform)?;
        let object = self.objects.len() as u32;
        self.primitives.try_reserve(mesh.triangles.len()).map_err(MeshError::from)?;
        self.primitives.extend((0..mesh.triangles.len()).map(|number| {
            let id = PrimitiveId { object, primitive: number as u32 };
            (id, Primitive::Triangle(mesh.vertices(number)))
        }));
        let (shape, transform) = (Shape::Mesh(Arc::new(mesh)), *transform);
        self.objects.push(Object { shape, transform, material, terminator });
        Ok(self)
    }

    /// Opens the textures and builds the tree. Objects whose material does not exist are shaded by nothing: black.
    pub fn build(self) -> Result<Scene, SceneError> {
        let mut textures = Textures::default();
        let environment = self.environment.as_ref().and_then(Environment::shader);
        for shader in self.materials.iter().chain(environment) {
            textures.open_those_of(&**shader)?;
        }
        if self.does_everything {
            textures.make_all_levels()?;
        }
        let start = Instant::now();
        let tree = Tree::build(&self.primitives)?;
        let tree_milliseconds = start.elapsed().as_secs_f64() * 1e3;
        let called_for = self.called_for();
        let extent = match tree.bounds() {
            Some((low, high)) => {
                let (low, high) = (double(low), double(high));
                ((low + high) * 0.5, (high - low).length() * 0.5)
            }
            None => (DVec3::ZERO, 0.0),
        };
        let material = |shader: Arc<dyn Shade>| Material {
            has_material: shader.has_root(RootKind::Material),
            has_shadow: shader.has_root(RootKind::Shadow),
            effects: shader.effects(RootKind::Material),
            shader,
        };
        Ok(Scene {
            tree,
            materials: self.materials.into_iter().map(material).collect(),
            lights: self.lights,
            environment: self.environment,
            directions: OnceLock::new(),
            camera: self.camera,
            depth: self.depth,
            extent,
            known_objects: match called_for.objects() {
                true => (0..).zip(&self.objects).map(|(at, object)| object.known(at)).collect(),
                false => Vec::new(),
            },
            known_camera: self.camera.known(),
            objects: self.objects,
            textures,
            called_for,
            does_everything: self.does_everything,
            tree_milliseconds,
        })
    }

    /// What the shaders call for, joined.
    fn called_for(&self) -> CalledFor {
        let mut called_for = match self.does_everything {
            true => CalledFor::everything(),
            false => CalledFor::default(),
        };
        for shader in &self.materials {
            for root in [RootKind::Material, RootKind::Shadow] {
                called_for.join(&**shader, root);
            }
        }
        if let Some(shader) = self.environment.as_ref().and_then(Environment::shader) {
            called_for.join(&**shader, RootKind::Environment);
        }
        called_for
    }
}

/// The sphere where a transform puts it.
pub(crate) fn placed_sphere(
    center: [f64; 3],
    radius: f64,
    transform: &Transform,
) -> Result<Sphere, SceneError> {
    if !transform.is_regular() {
        return Err(MeshError::IrregularTransform.into());
    }
    let scale = transform.uniform_scale().ok_or(SceneError::UnevenSphere)?;
    let center = single(transform.point(DVec3::from(center)));
    let radius = (radius * scale) as f32;
    let inside = |x: f32| x.abs() <= COORDINATE_LIMIT;
    if !(radius > 0.0 && inside(radius) && center.into_iter().all(inside)) {
        return Err(SceneError::BadSphere);
    }
    Ok(Sphere { center, radius })
}

impl Scene {
    /// Nearest hit past the ray's start and at most `farthest` away.
    #[inline]
    pub fn intersect(&self, ray: &PreparedRay, farthest: f64) -> Option<RawHit> {
        self.tree.nearest(ray, farthest)
    }

    /// Gives `found` every hit past the ray's start and before its end, in no order, until it
    /// returns false.
    #[inline]
    pub fn every(&self, ray: &PreparedRay, found: impl FnMut(RawHit) -> bool) {
        self.tree.every(ray, ray.reach(), found);
    }

    /// The surface where the ray from `origin` along `direction` hit.
    #[inline]
    pub fn surface(&self, origin: DVec3, direction: DVec3, hit: &RawHit) -> Surface {
        let id = self.tree.id(hit.slot);
        let shape = &self.objects[id.object as usize].shape;
        let primitive = self.tree.primitive(hit.slot);
        let coordinates = self.called_for.coordinates;
        Surface::at((origin, direction), hit, primitive, shape, id.primitive, coordinates)
    }

    /// Where a shadow ray from a point of a surface starts: the point itself, or lifted off a facet
    /// that stands for a round surface.
    #[inline]
    pub(crate) fn shadow_start(&self, hit: &Hit, point: DVec3, inside: bool) -> DVec3 {
        match self.objects.get(hit.instance as usize) {
            Some(Object { shape: Shape::Mesh(mesh), terminator, .. })
                if *terminator == ShadowTerminator::Smooth =>
            {
                mesh.lifted(hit.primitive, point, inside)
            }
            _ => point,
        }
    }

    /// Position of the material at a hit.
    #[inline]
    pub(crate) fn material_at(&self, hit: &RawHit) -> u32 {
        self.objects[self.tree.id(hit.slot).object as usize].material
    }

    /// How many primitives it has.
    pub fn primitive_count(&self) -> usize {
        self.tree.len()
    }
}
