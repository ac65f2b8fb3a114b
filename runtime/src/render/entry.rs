//! The one table of what a rendering may have to do beyond camera rays and shading: a ledger has a row for each.
//!
//! Whatever shaders may ask for leads to an entry, by matches without a rest: an effect, a loop or a field that is
//! added does not compile until it has one.

use phenomenon_compiler::effects::Effect;
use phenomenon_compiler::state::{Field, Iterated};

/// What is counted of an entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Rays that are cast.
    Rays,
    /// Points that are shaded.
    Points,
    /// Places that are looked up.
    Lookups,
    /// Nothing: its cost lies in other rows.
    None,
}

impl Unit {
    /// What so many are called.
    pub fn name(self, count: u64) -> &'static str {
        match (self, count) {
            (Unit::Rays, 1) => "ray",
            (Unit::Rays, _) => "rays",
            (Unit::Points, 1) => "point",
            (Unit::Points, _) => "points",
            (Unit::Lookups, 1) => "lookup",
            (Unit::Lookups, _) => "lookups",
            (Unit::None, _) => "",
        }
    }
}

/// Declares the entries: name in reports, and what is counted.
macro_rules! entries {
    ($($(#[doc = $doc:literal])+ $variant:ident $name:literal counts $unit:ident;)+) => {
        /// Something a rendering does only where a scene calls for it.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Entry { $($(#[doc = $doc])+ $variant,)+ }

        impl Entry {
            /// How many there are.
            pub const COUNT: usize = [$($name),+].len();

            /// Every entry, in the order of reports.
            pub const ALL: [Entry; Entry::COUNT] = [$(Entry::$variant),+];

            /// Name in reports.
            pub fn name(self) -> &'static str {
                match self { $(Entry::$variant => $name,)+ }
            }

            /// What it is, in a sentence.
            pub fn doc(self) -> &'static str {
                match self { $(Entry::$variant => concat!($($doc),+).trim_ascii(),)+ }
            }

            /// What is counted of it.
            pub fn unit(self) -> Unit {
                match self { $(Entry::$variant => Unit::$unit,)+ }
            }
        }
    };
}

entries! {
    /// Rays that are mirrored, and the shading of what they meet.
    Reflection "reflection" counts Rays;
    /// Rays that are bent, and the shading of what they meet.
    Refraction "refraction" counts Rays;
    /// Rays that go on unbent, and the shading of what they meet.
    Transparent "transparent" counts Rays;
    /// Rays that look for the next surface and shade nothing.
    Probe "probe" counts Rays;
    /// What is seen where no surface is: asked for by nodes, and by rays that leave the scene.
    Environment "environment" counts Lookups;
    /// The graph that shades the environment.
    EnvironmentShader "environment_shader" counts Points;
    /// Loops over lights: where each of their samples lies, seen from a point.
    LightLoops "light_loops" counts Lookups;
    /// How likely the environment light would have chosen a direction that something else chose.
    LightDensities "light_densities" counts None;
    /// Rays from points towards lights.
    ShadowRays "shadow_rays" counts Rays;
    /// Shadow roots, called at each surface between a point and a light.
    ShadowShaders "shadow_shaders" counts Points;
    /// Loops over samples: of glossy lobes, of occlusion. What each turn asks for counts in its own row.
    SampleLoops "sample_loops" counts None;
    /// A picture file: opened, decoded and read.
    Texture "texture" counts Lookups;
    /// Coarser versions of pictures that are read by what a pixel covers.
    TextureLevels "texture_levels" counts None;
    /// What a pixel covers on a surface: the cones of rays, and derivatives along the raster.
    Footprints "footprints" counts Lookups;
    /// Surface coordinates u and v of each hit.
    Coordinates "surface_coordinates" counts Points;
    /// How points move with u and v: tangents.
    Derivatives "surface_derivatives" counts Lookups;
    /// The second set of surface coordinates.
    SecondCoordinates "second_coordinates" counts Lookups;
    /// Colours of the corners of meshes.
    VertexColors "vertex_colors" counts Lookups;
    /// Transforms and numbers of objects, and the inverse of each transform.
    ObjectFields "object_fields" counts None;
    /// The tree of boxes in which rays find surfaces.
    Tree "acceleration_structure" counts None;
    /// Time within the shutter.
    Motion "motion" counts None;
}

impl From<Effect> for Entry {
    fn from(effect: Effect) -> Self {
        match effect {
            Effect::TraceReflection => Entry::Reflection,
            Effect::TraceRefraction => Entry::Refraction,
            Effect::TraceTransparent => Entry::Transparent,
            Effect::TraceEnvironment => Entry::Environment,
            Effect::TraceProbe => Entry::Probe,
            Effect::LightColor => Entry::ShadowRays,
            Effect::LightDensity => Entry::LightDensities,
            Effect::ReadTexture | Effect::TextureSize => Entry::Texture,
        }
    }
}

impl From<Iterated> for Entry {
    fn from(iterated: Iterated) -> Self {
        match iterated {
            Iterated::Lights => Entry::LightLoops,
            Iterated::Samples => Entry::SampleLoops,
        }
    }
}

impl Entry {
    /// What a field of the state has the renderer do; nothing for what every hit knows anyway.
    pub fn of_field(field: Field) -> Option<Self> {
        Some(match field {
            Field::U | Field::V => Entry::Coordinates,
            Field::DerivativeU | Field::DerivativeV => Entry::Derivatives,
            Field::SecondU | Field::SecondV => Entry::SecondCoordinates,
            Field::VertexColor => Entry::VertexColors,
            Field::DpDx | Field::DpDy | Field::DuDx | Field::DvDx | Field::DuDy | Field::DvDy => {
                Entry::Footprints
            }
            Field::ObjectId | Field::ObjectRandom | Field::ObjectToWorld | Field::WorldToObject => {
                Entry::ObjectFields
            }
            Field::Time => Entry::Motion,
            Field::Origin
            | Field::Direction
            | Field::Point
            | Field::Normal
            | Field::NormalGeom
            | Field::DotNd
            | Field::Dist
            | Field::InvNormal
            | Field::Ior
            | Field::IorIn
            | Field::RasterX
            | Field::RasterY
            | Field::RayType
            | Field::ReflectionLevel
            | Field::RefractionLevel
            | Field::Incoming
            | Field::CameraToWorld
            | Field::WorldToCamera
            | Field::CameraHeight
            | Field::LightDirection
            | Field::LightDistance
            | Field::LightDensity
            | Field::SampleIndex
            | Field::SampleU
            | Field::SampleV => return None,
        })
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn names_differ_and_say_what_they_are_of() {
        let names: BTreeSet<&str> = Entry::ALL.iter().map(|entry| entry.name()).collect();
        assert_eq!(names.len(), Entry::COUNT);
        for (at, entry) in Entry::ALL.into_iter().enumerate() {
            assert_eq!(entry as usize, at);
            assert!(entry.doc().ends_with('.'), "{}", entry.doc());
        }
    }
}
