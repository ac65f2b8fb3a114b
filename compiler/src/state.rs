//! The state of a shading point: what mental ray's `miState` holds.

use std::ops::RangeInclusive;

use crate::values::Type;

/// Why a ray was cast.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum RayType {
    /// From the camera.
    Eye = 0,
    /// By `trace_reflection`.
    Reflection = 1,
    /// By `trace_refraction`.
    Refraction = 2,
    /// By `trace_transparent`.
    Transparent = 3,
    /// From a light to the point it may light.
    Shadow = 4,
    /// To the environment only.
    Environment = 5,
    /// For displacement; no engine runs it yet.
    Displace = 6,
}

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

macro_rules! fields {
    ($($(#[doc = $doc:literal])+ $variant:ident $name:literal $type:ident |$state:ident| $words:expr, |$set:ident, $w:ident| $write:expr;)+) => {
        /// A field of the state that nodes can read.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Field { $($(#[doc = $doc])+ $variant,)+
            /// Unit direction towards the light sample; only inside a light loop.
            LightDirection,
            /// Distance to the light sample, 0 for one at infinity; only inside a light loop.
            LightDistance,
        }

        impl Field {
            /// Every field, those of loops last.
            pub const ALL: &'static [Field] = &[$(Field::$variant,)+ Field::LightDirection, Field::LightDistance];

            /// Name in graph files and on the command line.
            pub fn name(self) -> &'static str {
                match self { $(Field::$variant => $name,)+
                    Field::LightDirection => "light_direction",
                    Field::LightDistance => "light_distance",
                }
            }

            /// Meaning and unit.
            pub fn doc(self) -> &'static str {
                match self { $(Field::$variant => concat!($($doc),+).trim_ascii(),)+
                    Field::LightDirection => "Unit direction towards the light sample; only inside a light loop.",
                    Field::LightDistance => "Distance to the light sample, 0 for one at infinity; only inside a light loop.",
                }
            }

            /// Its type.
            pub fn value_type(self) -> Type {
                match self { $(Field::$variant => Type::$type,)+
                    Field::LightDirection => Type::Vector,
                    Field::LightDistance => Type::Scalar,
                }
            }

            /// Its words in `state`, the first `value_type().width()` of four; zero for fields of
            /// loops, which no state holds.
            #[inline]
            pub fn read(self, state: &State) -> [u32; 4] {
                match self { $(Field::$variant => { let $state = state; $words })+
                    Field::LightDirection | Field::LightDistance => [0; 4],
                }
            }

            /// Sets the field from its words; fields of loops are not kept.
            #[inline]
            pub fn write(self, state: &mut State, words: [u32; 4]) {
                match self { $(Field::$variant => { let ($set, $w) = (state, words); $write })+
                    Field::LightDirection | Field::LightDistance => {}
                }
            }
        }
    };
}

fields! {
    /// Origin of the ray, world space.
    Origin "origin" Vector |s| three(s.origin), |s, w| s.origin = vector(w);
    /// Unit direction of the ray, towards the surface.
    Direction "direction" Vector |s| three(s.direction), |s, w| s.direction = vector(w);
    /// The point that is shaded, world space.
    Point "point" Vector |s| three(s.point), |s, w| s.point = vector(w);
    /// Unit shading normal, on the side the ray came from.
    Normal "normal" Vector |s| three(s.normal), |s, w| s.normal = vector(w);
    /// Unit geometric normal, on the side the ray came from.
    NormalGeom "normal_geom" Vector |s| three(s.normal_geom), |s, w| s.normal_geom = vector(w);
    /// Shading normal times ray direction, at most 0 unless a scope bends the normal.
    DotNd "dot_nd" Scalar |s| one(s.dot_nd), |s, w| s.dot_nd = number(w);
    /// Distance from the ray's origin to the point; 0 where it hit nothing.
    Dist "dist" Scalar |s| one(s.dist), |s, w| s.dist = number(w);
    /// Whether the surface was hit from inside.
    InvNormal "inv_normal" Boolean |s| [if s.inv_normal { u32::MAX } else { 0 }, 0, 0, 0], |s, w| s.inv_normal = w[0] != 0;
    /// Index of refraction of the outgoing medium; 0 means unset.
    Ior "ior" Scalar |s| one(s.ior), |s, w| s.ior = number(w);
    /// Index of refraction of the incoming medium; 0 means unset, read as 1.
    IorIn "ior_in" Scalar |s| one(s.ior_in), |s, w| s.ior_in = number(w);
    /// First surface coordinate.
    U "u" Scalar |s| one(s.uv[0]), |s, w| s.uv[0] = number(w);
    /// Second surface coordinate.
    V "v" Scalar |s| one(s.uv[1]), |s, w| s.uv[1] = number(w);
    /// Time within the shutter, 0 to 1.
    Time "time" Scalar |s| one(s.time), |s, w| s.time = number(w);
    /// Horizontal film position in pixels, from the left.
    RasterX "raster_x" Scalar |s| one(s.raster[0]), |s, w| s.raster[0] = number(w);
    /// Vertical film position in pixels, from the top.
    RasterY "raster_y" Scalar |s| one(s.raster[1]), |s, w| s.raster[1] = number(w);
    /// Why the ray was cast: 0 eye, 1 reflection, 2 refraction, 3 transparent, 4 shadow, 5 environment, 6 displace.
    RayType "ray_type" Integer |s| [s.ray_type as i32 as u32, 0, 0, 0], |s, w| s.ray_type = ray_type(w);
    /// Reflections so far.
    ReflectionLevel "reflection_level" Integer |s| [s.reflection_level as u32, 0, 0, 0], |s, w| s.reflection_level = w[0] as i32;
    /// Refractions and transparencies so far.
    RefractionLevel "refraction_level" Integer |s| [s.refraction_level as u32, 0, 0, 0], |s, w| s.refraction_level = w[0] as i32;
    /// Colour handed on by the shader before in the list of a root; for the first what the renderer starts from: white for shadows, else zero.
    Incoming "incoming" Color |s| s.incoming.map(f32::to_bits), |s, w| s.incoming = w.map(f32::from_bits);
}

impl Field {
    /// The field called `name` in graph files.
    pub fn from_name(name: &str) -> Option<Field> {
        Field::ALL.iter().copied().find(|field| field.name() == name)
    }

    /// The values it takes, per component, where the renderer keeps it within some: what it builds
    /// states from, and what scopes make of unit vectors. None where it may be anything.
    pub fn range(self) -> Option<RangeInclusive<f64>> {
        /// A product of two unit vectors, each rounded.
        const COSINE: f64 = 1.0 + 1e-6;
        /// Distances beyond the largest number are infinite.
        const DISTANCE: RangeInclusive<f64> = 0.0..=f64::INFINITY;
        match self {
            Field::Direction | Field::Normal | Field::NormalGeom | Field::LightDirection => {
                Some(-1.0..=1.0)
            }
            Field::DotNd => Some(-COSINE..=COSINE),
            Field::Dist | Field::LightDistance => Some(DISTANCE),
            Field::Time => Some(0.0..=1.0),
            Field::RasterX | Field::RasterY => Some(0.0..=f64::from(f32::MAX)),
            Field::RayType => Some(0.0..=6.0),
            Field::ReflectionLevel | Field::RefractionLevel => Some(0.0..=f64::from(i32::MAX)),
            _ => None,
        }
    }

    /// Whether the field exists only inside a light loop.
    pub fn is_of_light(self) -> bool {
        matches!(self, Field::LightDirection | Field::LightDistance)
    }
}

fn one(x: f32) -> [u32; 4] {
    [x.to_bits(), 0, 0, 0]
}
fn three(v: [f32; 3]) -> [u32; 4] {
    [v[0].to_bits(), v[1].to_bits(), v[2].to_bits(), 0]
}
fn number(words: [u32; 4]) -> f32 {
    f32::from_bits(words[0])
}
fn vector(words: [u32; 4]) -> [f32; 3] {
    [f32::from_bits(words[0]), f32::from_bits(words[1]), f32::from_bits(words[2])]
}
fn ray_type(words: [u32; 4]) -> RayType {
    match words[0] {
        1 => RayType::Reflection,
        2 => RayType::Refraction,
        3 => RayType::Transparent,
        4 => RayType::Shadow,
        5 => RayType::Environment,
        6 => RayType::Displace,
        _ => RayType::Eye,
    }
}
