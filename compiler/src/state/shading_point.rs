//! The state of a shading point: what mental ray's `miState` holds.

use super::footprint::Cone;
use super::ray_type::RayType;

/// What nodes can know about the point that is shaded. Lengths in scene units, directions of unit
/// length, all in world space. Built by the renderer, which keeps each field in its range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Origin of the ray.
    pub origin: [f32; 3],
    /// Unit direction of the ray, towards the surface.
    pub direction: [f32; 3],
    /// The point that is shaded.
    pub point: [f32; 3],
    /// Unit shading normal, on the side the ray came from.
    pub normal: [f32; 3],
    /// Unit geometric normal, on the side the ray came from.
    pub normal_geom: [f32; 3],
    /// `normal · direction`, -1..=0 unless a scope bends the normal.
    pub dot_nd: f32,
    /// Distance from origin to point; 0 where the ray hit nothing.
    pub dist: f32,
    /// Whether the normals were flipped: the surface was hit from inside.
    pub inv_normal: bool,
    /// Index of refraction of the outgoing medium; 0 means unset.
    pub ior: f32,
    /// Index of refraction of the incoming medium; 0 means unset, read as 1.
    pub ior_in: f32,
    /// Surface coordinates.
    pub uv: [f32; 2],
    /// Time within the shutter, 0..=1.
    pub time: f32,
    /// Position on the film, in pixels from the top left.
    pub raster: [f32; 2],
    /// Why the ray was cast.
    pub ray_type: RayType,
    /// Reflections so far.
    pub reflection_level: i32,
    /// Refractions and transparencies so far.
    pub refraction_level: i32,
    /// Colour handed on by the shader before in the list of a root; what the first gets is what the
    /// renderer starts from: white for shadows, else zero.
    pub incoming: [f32; 4],
    /// Key of the path: a hash of seed, pixel, sample and every request site on the way. The
    /// source of all random numbers.
    pub path: u64,
    /// Where the renderer keeps what it knows about the hit; no node reads it.
    pub hit: Hit,
}

/// The renderer's own note on a hit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Hit {
    /// Instance number.
    pub instance: u32,
    /// Primitive number within the instance.
    pub primitive: u32,
    /// The point in double precision. The renderer takes it for `point` where `point` is its
    /// rounding; a scope that moves the point leaves it behind.
    pub position: [f64; 3],
    /// What the pixel sees along the ray.
    pub cone: Cone,
}

impl Default for State {
    fn default() -> Self {
        Self {
            origin: [0.0, 0.0, 1.0],
            direction: [0.0, 0.0, -1.0],
            point: [0.0; 3],
            normal: [0.0, 0.0, 1.0],
            normal_geom: [0.0, 0.0, 1.0],
            dot_nd: -1.0,
            dist: 1.0,
            inv_normal: false,
            ior: 0.0,
            ior_in: 0.0,
            uv: [0.0; 2],
            time: 0.0,
            raster: [0.0; 2],
            ray_type: RayType::Eye,
            reflection_level: 0,
            refraction_level: 0,
            incoming: [0.0; 4],
            path: 0,
            hit: Hit::default(),
        }
    }
}
