//! The table of the fields of the state.

use std::ops::RangeInclusive;

use crate::storage::{LANES, Lanes};
use crate::values::Type;

use super::held::Held;
use super::iterated::Iterated;
use super::known::Known;
use super::place::Place;
use super::shading_point::State;

/// Declares the fields: name, type, range, and where the state, its object, the surface there or the
/// camera holds it, or which loop provides it.
macro_rules! fields {
    ($($(#[doc = $doc:literal])+ $variant:ident $name:literal $type:ident $(in $range:expr)?, $how:tt $place:tt;)+) => {
        /// A field of the state that nodes can read.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Field { $($(#[doc = $doc])+ $variant,)+ }

        impl Field {
            /// Every field, those of loops last.
            pub const ALL: &'static [Field] = &[$(Field::$variant),+];

            /// Words of the widest field.
            pub const MOST_WORDS: usize = {
                let (mut most, mut at) = (0, 0);
                while at < Field::ALL.len() {
                    let width = Field::ALL[at].value_type().width();
                    most = if width > most { width } else { most };
                    at += 1;
                }
                most
            };

            /// Name in graph files and on the command line.
            pub fn name(self) -> &'static str {
                match self { $(Field::$variant => $name,)+ }
            }

            /// Meaning and unit.
            pub fn doc(self) -> &'static str {
                match self { $(Field::$variant => concat!($($doc),+).trim_ascii(),)+ }
            }

            /// Its type.
            pub const fn value_type(self) -> Type {
                match self { $(Field::$variant => Type::$type,)+ }
            }

            /// The values it takes, per component, where the renderer keeps it within some: what it
            /// builds states from, and what scopes make of unit vectors. None where it may be anything.
            pub fn range(self) -> Option<RangeInclusive<f64>> {
                match self { $(Field::$variant => fields!(@range $($range)?),)+ }
            }

            /// Who holds it.
            pub const fn holder(self) -> Holder {
                match self { $(Field::$variant => fields!(@holder $how $place),)+ }
            }

            /// Writes its words as they are in what is known round a point; zeros for those of the state
            /// itself and of loops.
            #[inline]
            pub fn look_up(self, known: &Known<'_>, words: &mut [u32]) {
                match self { $(Field::$variant => fields!(@look_up $how $place, known, words),)+ }
            }

            /// Sets the field of a place from its words; those of loops are not kept.
            pub fn put(self, place: &mut Place, words: &[u32]) {
                match self { $(Field::$variant => fields!(@put $how $place, place, words),)+ }
            }

            /// Writes its words, [`Field::value_type`] wide, as they are in `state`; zeros for those that
            /// no state holds.
            #[inline]
            pub fn read(self, state: &State, words: &mut [u32]) {
                match self { $(Field::$variant => fields!(@read $how $place, state, words),)+ }
            }

            /// Writes its words of up to eight states, each in a lane of its own; nothing for
            /// those that no state holds.
            #[inline]
            pub fn gather(self, states: &[State], lanes: &mut [Lanes]) {
                match self { $(Field::$variant => {
                    const WIDTH: usize = Field::$variant.value_type().width();
                    fields!(@gather $how $place, WIDTH, states, lanes)
                })+ }
            }

            /// Writes its words of one state into all lanes; false for those that no state holds.
            #[inline]
            pub fn spread(self, state: &State, lanes: &mut [Lanes]) -> bool {
                match self { $(Field::$variant => {
                    const WIDTH: usize = Field::$variant.value_type().width();
                    fields!(@spread $how $place, WIDTH, state, lanes)
                })+ }
            }

            /// Sets the field from its words; those that no state holds are not kept.
            #[inline]
            pub fn write(self, state: &mut State, words: &[u32]) {
                match self { $(Field::$variant => fields!(@write $how $place, state, words),)+ }
            }
        }
    };
    (@range) => { None };
    (@range $range:expr) => { Some($range) };
    (@holder held $place:tt) => { Holder::State };
    (@holder object $place:tt) => { Holder::Object };
    (@holder surface $place:tt) => { Holder::Surface };
    (@holder camera $place:tt) => { Holder::Camera };
    (@holder of $loop:ident) => { Holder::Loop(Iterated::$loop) };
    (@look_up object ($($place:tt)+), $known:ident, $words:ident) => {
        $known.object.$($place)+.read($words)
    };
    (@look_up surface ($place:ident $($part:tt)*), $known:ident, $words:ident) => {
        $known.surfaces.$place($known.state)$($part)*.read($words)
    };
    (@look_up camera ($($place:tt)+), $known:ident, $words:ident) => {
        $known.camera.$($place)+.read($words)
    };
    (@look_up $how:ident $place:tt, $known:ident, $words:ident) => { $words.fill(0) };
    (@put held ($($part:tt)+), $place:ident, $words:ident) => { $place.state.$($part)+.write($words) };
    (@put object ($($part:tt)+), $place:ident, $words:ident) => { $place.object.$($part)+.write($words) };
    (@put surface ($($part:tt)+), $place:ident, $words:ident) => { $place.surface.$($part)+.write($words) };
    (@put camera ($($part:tt)+), $place:ident, $words:ident) => { $place.camera.$($part)+.write($words) };
    (@put of $loop:ident, $place:ident, $words:ident) => { () };
    (@read held ($($place:tt)+), $state:ident, $words:ident) => { $state.$($place)+.read($words) };
    (@read $how:ident $place:tt, $state:ident, $words:ident) => { $words.fill(0) };
    (@gather held ($($place:tt)+), $width:ident, $states:ident, $lanes:ident) => {
        for (lane, state) in $states.iter().enumerate() {
            let mut words = [0; $width];
            state.$($place)+.read(&mut words);
            for (lanes, word) in $lanes.iter_mut().zip(words) {
                lanes.0[lane] = word;
            }
        }
    };
    (@gather $how:ident $place:tt, $width:ident, $states:ident, $lanes:ident) => {{
        let _: usize = $width;
    }};
    (@spread held ($($place:tt)+), $width:ident, $state:ident, $lanes:ident) => {{
        let mut words = [0; $width];
        $state.$($place)+.read(&mut words);
        for (lanes, word) in $lanes[..$width].iter_mut().zip(words) {
            *lanes = Lanes([word; LANES]);
        }
        true
    }};
    (@spread $how:ident $place:tt, $width:ident, $state:ident, $lanes:ident) => {{
        let _: usize = $width;
        false
    }};
    (@write held ($($place:tt)+), $state:ident, $words:ident) => { $state.$($place)+.write($words) };
    (@write $how:ident $place:tt, $state:ident, $words:ident) => { () };
}

/// Who holds a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Holder {
    /// The state of the point: scopes may change it.
    State,
    /// The object the point is on: the same all over it.
    Object,
    /// The surface at the point: worked out where something reads it.
    Surface,
    /// The camera: the same everywhere.
    Camera,
    /// A turn of a loop over these.
    Loop(Iterated),
}

/// Components of unit vectors.
const UNIT: RangeInclusive<f64> = -1.0..=1.0;
/// A product of two unit vectors, each rounded.
const COSINE: RangeInclusive<f64> = -1.0 - 1e-6..=1.0 + 1e-6;
/// Distances beyond the largest number are infinite.
const DISTANCE: RangeInclusive<f64> = 0.0..=f64::INFINITY;
/// Pixels.
const RASTER: RangeInclusive<f64> = 0.0..=f32::MAX as f64;
/// Counts.
const COUNT: RangeInclusive<f64> = 0.0..=i32::MAX as f64;

fields! {
    /// Origin of the ray, world space.
    Origin "origin" Vector, held (origin);
    /// Unit direction of the ray, towards the surface.
    Direction "direction" Vector in UNIT, held (direction);
    /// The point that is shaded, world space.
    Point "point" Vector, held (point);
    /// Unit shading normal, on the side the ray came from.
    Normal "normal" Vector in UNIT, held (normal);
    /// Unit geometric normal, on the side the ray came from.
    NormalGeom "normal_geom" Vector in UNIT, held (normal_geom);
    /// Shading normal times ray direction, at most 0 unless a scope bends the normal.
    DotNd "dot_nd" Scalar in COSINE, held (dot_nd);
    /// Distance from the ray's origin to the point; 0 where it hit nothing.
    Dist "dist" Scalar in DISTANCE, held (dist);
    /// Whether the surface was hit from inside.
    InvNormal "inv_normal" Boolean, held (inv_normal);
    /// Index of refraction of the outgoing medium; 0 means unset.
    Ior "ior" Scalar, held (ior);
    /// Index of refraction of the incoming medium; 0 means unset, read as 1.
    IorIn "ior_in" Scalar, held (ior_in);
    /// First surface coordinate.
    U "u" Scalar, held (uv[0]);
    /// Second surface coordinate.
    V "v" Scalar, held (uv[1]);
    /// Time within the shutter, 0 to 1.
    Time "time" Scalar in 0.0..=1.0, held (time);
    /// Horizontal film position in pixels, from the left.
    RasterX "raster_x" Scalar in RASTER, held (raster[0]);
    /// Vertical film position in pixels, from the top.
    RasterY "raster_y" Scalar in RASTER, held (raster[1]);
    /// Why the ray was cast: 0 eye, 1 reflection, 2 refraction, 3 transparent, 4 shadow, 5 environment, 6 displace.
    RayType "ray_type" Integer in 0.0..=6.0, held (ray_type);
    /// Reflections so far.
    ReflectionLevel "reflection_level" Integer in COUNT, held (reflection_level);
    /// Refractions and transparencies so far.
    RefractionLevel "refraction_level" Integer in COUNT, held (refraction_level);
    /// Colour handed on by the shader before in the list of a root; for the first what the renderer starts from: white for shadows, else zero.
    Incoming "incoming" Color, held (incoming);
    /// How the point moves with u, in scene units: the derivative of the surface, not of unit length; 0 where there is no surface.
    DerivativeU "derivative_u" Vector, surface (derivative_u);
    /// How the point moves with v, in scene units: the derivative of the surface, not of unit length; 0 where there is no surface.
    DerivativeV "derivative_v" Vector, surface (derivative_v);
    /// Colour of the mesh there, between those of its vertices; white where it has none.
    VertexColor "vertex_color" Color, surface (vertex_color);
    /// First coordinate of the second set; the first set where a surface has one only.
    SecondU "second_u" Scalar, surface (second_uv[0]);
    /// Second coordinate of the second set; the first set where a surface has one only.
    SecondV "second_v" Scalar, surface (second_uv[1]);
    /// How the point moves along the longer axis of what the pixel covers, in scene units: across all of it.
    DpDx "dp_dx" Vector, surface (footprint.point[0]);
    /// How the point moves along the shorter axis of what the pixel covers.
    DpDy "dp_dy" Vector, surface (footprint.point[1]);
    /// How u changes along the longer axis of what the pixel covers.
    DuDx "du_dx" Scalar, surface (footprint.uv[0][0]);
    /// How v changes along the longer axis of what the pixel covers.
    DvDx "dv_dx" Scalar, surface (footprint.uv[0][1]);
    /// How u changes along the shorter axis of what the pixel covers.
    DuDy "du_dy" Scalar, surface (footprint.uv[1][0]);
    /// How v changes along the shorter axis of what the pixel covers.
    DvDy "dv_dy" Scalar, surface (footprint.uv[1][1]);
    /// Number of the object, from 1 in the order of the scene; 0 where there is none.
    ObjectId "object_id" Integer in COUNT, object (id);
    /// A number of the object's own, 0 to below 1; 0 where there is none.
    ObjectRandom "object_random" Scalar in 0.0..=1.0, object (random);
    /// From the space of the object to that of the scene.
    ObjectToWorld "object_to_world" Transform, object (to_world);
    /// From the space of the scene to that of the object.
    WorldToObject "world_to_object" Transform, object (to_object);
    /// From the space of the camera to that of the scene: x to the right, y up, and -z is looked along.
    CameraToWorld "camera_to_world" Transform, camera (to_world);
    /// From the space of the scene to that of the camera.
    WorldToCamera "world_to_camera" Transform, camera (to_camera);
    /// Half the height of what the camera sees at distance 1: the tangent of half its field of view.
    CameraHeight "camera_height" Scalar in DISTANCE, camera (height);
    /// Unit direction towards the light sample; only inside a light loop.
    LightDirection "light_direction" Vector in UNIT, of Lights;
    /// Distance to the light sample, 0 for one at infinity; only inside a light loop.
    LightDistance "light_distance" Scalar in DISTANCE, of Lights;
    /// How densely the samples of the light lie in its direction, per steradian; infinite for a light that no ray finds, as all are but the environment; only inside a light loop.
    LightDensity "light_density" Scalar in DISTANCE, of Lights;
    /// Number of the sample, from 0; only inside a sample loop.
    SampleIndex "sample_index" Integer in COUNT, of Samples;
    /// First number drawn for the sample, 0 to below 1; only inside a sample loop.
    SampleU "sample_u" Scalar in 0.0..=1.0, of Samples;
    /// Second number drawn for the sample, 0 to below 1; only inside a sample loop.
    SampleV "sample_v" Scalar in 0.0..=1.0, of Samples;
}

impl Field {
    /// Whether a state holds it.
    pub const fn of_point(self) -> bool {
        matches!(self.holder(), Holder::State)
    }

    /// The loop that provides it; none for those of points.
    pub const fn of_loop(self) -> Option<Iterated> {
        match self.holder() {
            Holder::Loop(iterated) => Some(iterated),
            _ => None,
        }
    }

    /// The field called `name` in graph files.
    pub fn from_name(name: &str) -> Option<Field> {
        Field::ALL.iter().copied().find(|field| field.name() == name)
    }
}

#[cfg(test)]
mod tests {
    use super::super::ray_type::RayType;
    use super::*;

    #[test]
    fn numbers_of_ray_types_lead_back_and_the_field_tells_them() {
        let told: Vec<String> =
            RayType::ALL.iter().map(|it| format!("{} {}", *it as i32, it.name())).collect();
        let doc = format!("Why the ray was cast: {}.", told.join(", "));
        assert_eq!(Field::RayType.doc(), doc);
        for (at, ray_type) in RayType::ALL.into_iter().enumerate() {
            assert_eq!(RayType::from_number(at as i32), ray_type);
        }
        assert_eq!(RayType::from_number(-1), RayType::Eye);
        assert_eq!(RayType::from_number(7), RayType::Eye);
    }

    #[test]
    fn what_is_written_is_read_and_nothing_else_changes() {
        let read = |field: Field, state: &State| {
            let mut words = vec![0; field.value_type().width()];
            field.read(state, &mut words);
            words
        };
        for &field in Field::ALL {
            let mut state = State::default();
            let mut words = vec![3; field.value_type().width()];
            if field.value_type() == Type::Boolean {
                words[0] = u32::MAX;
            }
            field.write(&mut state, &words);
            match field.of_point() {
                false => assert_eq!(read(field, &state), vec![0; words.len()]),
                true => assert_eq!(read(field, &state), words, "{field:?}"),
            }
            for &other in Field::ALL.iter().filter(|other| **other != field) {
                assert_eq!(read(other, &state), read(other, &State::default()), "{field:?}");
            }
            let mut lanes = [Lanes([7; LANES]); Field::MOST_WORDS];
            field.gather(&[state, State::default()], &mut lanes[..words.len()]);
            if field.of_point() {
                let other = read(field, &State::default());
                for (at, lanes) in lanes[..words.len()].iter().enumerate() {
                    assert_eq!(lanes.0[..3], [words[at], other[at], 7], "{field:?}");
                }
            }
            let mut lanes = [Lanes([7; LANES]); Field::MOST_WORDS];
            assert_eq!(field.spread(&state, &mut lanes), field.of_point(), "{field:?}");
            let spread = if field.of_point() { words.clone() } else { vec![7; words.len()] };
            let all = spread.iter().map(|word| [*word; LANES]).chain(std::iter::repeat([7; LANES]));
            assert!(lanes.iter().map(|lanes| lanes.0).zip(all).all(|(is, should)| is == should));
            assert!(words.len() <= Field::MOST_WORDS);
        }
    }
}
