//! What a shader may ask of the renderer, and the trait through which it asks.

use crate::state::{Field, State};
use crate::values::Texture;

/// Anything a node asks of the renderer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Effect {
    /// Trace a reflection ray. Arguments: direction. Answer: see [`Answer`].
    TraceReflection,
    /// Trace a refraction ray. Arguments: direction.
    TraceRefraction,
    /// Trace on along the ray, unbent. No arguments.
    TraceTransparent,
    /// Ask the environment, without geometry. Arguments: direction.
    TraceEnvironment,
    /// Intersect only, call no shader. Arguments: direction, origin.
    TraceProbe,
    /// The colour a light sample sends to the point, after shadows. Only inside a light loop.
    LightColor,
    /// The colour of a texture. Arguments: two coordinates. Answer: see [`Renderer::read_texture`].
    ReadTexture,
}

impl Effect {
    /// Every effect.
    pub const ALL: [Effect; 7] = [
        Effect::TraceReflection,
        Effect::TraceRefraction,
        Effect::TraceTransparent,
        Effect::TraceEnvironment,
        Effect::TraceProbe,
        Effect::LightColor,
        Effect::ReadTexture,
    ];

    /// Name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Effect::TraceReflection => "trace_reflection",
            Effect::TraceRefraction => "trace_refraction",
            Effect::TraceTransparent => "trace_transparent",
            Effect::TraceEnvironment => "trace_environment",
            Effect::TraceProbe => "trace_probe",
            Effect::LightColor => "light_color",
            Effect::ReadTexture => "read_texture",
        }
    }

    /// State fields the request reads besides its arguments; a scope that changes one of them asks
    /// anew. All of the state goes to the renderer, but only these may matter to it.
    pub fn reads(self) -> &'static [Field] {
        match self {
            Effect::ReadTexture => &[],
            Effect::TraceReflection | Effect::TraceRefraction => {
                &[Field::Point, Field::NormalGeom, Field::Ior, Field::IorIn, Field::Time]
            }
            Effect::TraceTransparent => &[
                Field::Point,
                Field::NormalGeom,
                Field::Direction,
                Field::Ior,
                Field::IorIn,
                Field::Time,
            ],
            Effect::TraceEnvironment => &[Field::Point, Field::Time],
            Effect::TraceProbe => &[Field::Point, Field::NormalGeom, Field::Time],
            Effect::LightColor => {
                &[Field::Point, Field::NormalGeom, Field::LightDirection, Field::LightDistance]
            }
        }
    }
}

/// A ray a shader asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// The point that asks, with the changes of the scopes round the request.
    pub state: State,
    /// Where it starts: the point, or for a probe the given origin.
    pub origin: [f32; 3],
    /// Its direction, of any length (the renderer normalises it; zero misses everything).
    pub direction: [f32; 3],
    /// Key of the random numbers below it: a hash of the asking node's path of names and of the
    /// iterations round it.
    pub site: u64,
}

/// What came back from a ray.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Answer {
    /// Colour r, g, b, a; zero for a probe.
    pub color: [f32; 4],
    /// Whether some shader the ray caused to run returned true.
    pub ok: bool,
    /// Whether it hit a surface.
    pub hit: bool,
    /// Distance to that surface; 0 where it hit nothing.
    pub distance: f32,
}

/// One of the lights or light samples a loop runs over.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LightSample {
    /// Unit direction from the point towards the light.
    pub direction: [f32; 3],
    /// Distance to it; 0 for a light at infinity.
    pub distance: f32,
    /// Whether the point can be lit by it at all (within its cone, not at its centre …).
    pub reachable: bool,
}

/// A list of lights, resolved by the renderer from the names in a graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct LightList(pub u32);

/// A texture, resolved by the renderer from the file in a graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct TextureId(pub u32);

/// The renderer as engines see it. Every call carries many points; an engine that runs one point
/// at a time passes one. Answers may depend on the arguments only, never on order or grouping.
pub trait Renderer {
    /// Traces `rays` and writes one answer each. `effect` is one of the trace effects.
    fn trace(&mut self, effect: Effect, rays: &[Ray], answers: &mut [Answer]);

    /// The texture of a file. A renderer opens all of [`crate::engine::Shade::textures`] beforehand and
    /// refuses to start where it cannot. One that has no textures need not implement this.
    fn texture(&mut self, _texture: &Texture) -> TextureId {
        TextureId(u32::MAX)
    }

    /// The colour (r, g, b, a) of `texture` at each pair of coordinates, the picture filling 0..1 in
    /// both, the second upwards, and repeated outside; none where a coordinate is not finite, or there
    /// is no such texture.
    fn read_texture(
        &mut self,
        _texture: TextureId,
        _coordinates: &[[f32; 2]],
        colors: &mut [Option<[f32; 4]>],
    ) {
        colors.fill(None);
    }

    /// The list of the lights called `names`; no names means all lights of the scene.
    fn light_list(&mut self, names: &[String]) -> LightList;

    /// How many iterations a loop over `list` takes: its lights, each with its samples.
    fn light_count(&mut self, list: LightList) -> usize;

    /// Where sample `iteration` of `list` lies as seen from each point. Casts no ray.
    fn light_samples(
        &mut self,
        list: LightList,
        iteration: usize,
        points: &[State],
        samples: &mut [LightSample],
    );

    /// What sample `iteration` of `list` sends to each point, after shadows (r, g, b), divided by the
    /// number of samples of its light: a loop only adds.
    fn light_colors(
        &mut self,
        list: LightList,
        iteration: usize,
        points: &[State],
        colors: &mut [[f32; 3]],
    );
}
