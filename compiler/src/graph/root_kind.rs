//! The kinds of roots.

use crate::state::RayType;
use crate::values::Type;

/// What a root is called for: the shader types of mental ray. Engines run a root of any type; which
/// of them a renderer calls is its own matter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum RootKind {
    /// A visible ray hit the surface; yields the colour it sees.
    Material,
    /// A shadow ray hit the surface; yields the colour by which light is multiplied.
    Shadow,
    /// A ray left the scene; yields the colour it sees.
    Environment,
    /// A ray passed through a volume; changes the colour it saw.
    Volume,
    /// A light is asked what it sends to a point.
    Light,
    /// A ray leaves the camera.
    Lens,
    /// Another shader asks for a texture.
    Texture,
    /// A vertex is displaced along its normal; yields a distance.
    Displacement,
    /// The picture is finished, pixel by pixel.
    Output,
    /// A photon hit the surface; changes its energy.
    Photon,
    /// A contour line is drawn.
    Contour,
    /// A light map is written.
    Lightmap,
    /// Geometry is made before rendering.
    Geometry,
    /// A state is set up or taken down.
    State,
}

impl RootKind {
    /// Every kind.
    pub const ALL: [RootKind; 14] = [
        RootKind::Material,
        RootKind::Shadow,
        RootKind::Environment,
        RootKind::Volume,
        RootKind::Light,
        RootKind::Lens,
        RootKind::Texture,
        RootKind::Displacement,
        RootKind::Output,
        RootKind::Photon,
        RootKind::Contour,
        RootKind::Lightmap,
        RootKind::Geometry,
        RootKind::State,
    ];

    /// Name in graph files.
    pub fn name(self) -> &'static str {
        match self {
            RootKind::Material => "material",
            RootKind::Shadow => "shadow",
            RootKind::Environment => "environment",
            RootKind::Volume => "volume",
            RootKind::Light => "light",
            RootKind::Lens => "lens",
            RootKind::Texture => "texture",
            RootKind::Displacement => "displacement",
            RootKind::Output => "output",
            RootKind::Photon => "photon",
            RootKind::Contour => "contour",
            RootKind::Lightmap => "lightmap",
            RootKind::Geometry => "geometry",
            RootKind::State => "state",
        }
    }

    /// The ray types a renderer calls it for. Of kinds that no renderer here calls, all.
    pub fn ray_types(self) -> &'static [RayType] {
        match self {
            RootKind::Material => {
                use RayType::{Eye, Reflection, Refraction, Transparent};
                &[Eye, Reflection, Refraction, Transparent]
            }
            RootKind::Shadow => &[RayType::Shadow],
            RootKind::Environment => &[RayType::Environment],
            RootKind::Displacement => &[RayType::Displace],
            _ => &RayType::ALL,
        }
    }

    /// The type of its value: a displacement is a scalar, all others are colours.
    pub fn value_type(self) -> Type {
        match self {
            RootKind::Displacement => Type::Scalar,
            _ => Type::Color,
        }
    }
}
