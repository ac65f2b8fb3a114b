//! What is known of the surface at a point, worked out only where something reads it.

use super::footprint::Footprint;
use super::shading_point::State;

/// What a surface is like at one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// How the point moves with u.
    pub derivative_u: [f32; 3],
    /// How the point moves with v.
    pub derivative_v: [f32; 3],
    /// Colour of the mesh there.
    pub vertex_color: [f32; 4],
    /// The second set of surface coordinates.
    pub second_uv: [f32; 2],
    /// What the pixel covers of it.
    pub footprint: Footprint,
}

impl Surface {
    /// Where there is no surface.
    pub const NONE: Self = Self {
        derivative_u: [0.0; 3],
        derivative_v: [0.0; 3],
        vertex_color: [1.0; 4],
        second_uv: [0.0; 2],
        footprint: Footprint { point: [[0.0; 3]; 2], uv: [[0.0; 2]; 2] },
    };
}

/// The plane in which the default state lies.
impl Default for Surface {
    fn default() -> Self {
        Self { derivative_u: [1.0, 0.0, 0.0], derivative_v: [0.0, 1.0, 0.0], ..Self::NONE }
    }
}

/// The surfaces of a scene. Asked for a point only what a graph reads there; answers depend on the
/// renderer's note on the hit, on surface coordinates, the ray and the geometric normal alone.
pub trait Surfaces {
    /// How the point moves with u, in scene units.
    fn derivative_u(&self, state: &State) -> [f32; 3];
    /// How the point moves with v, in scene units.
    fn derivative_v(&self, state: &State) -> [f32; 3];
    /// Colour of the mesh there; white where it has none.
    fn vertex_color(&self, state: &State) -> [f32; 4];
    /// The second set of surface coordinates; the first where there is one only.
    fn second_uv(&self, state: &State) -> [f32; 2];
    /// What the pixel covers of it; nothing where there is no surface.
    fn footprint(&self, state: &State) -> Footprint;
}

/// The same surface everywhere.
impl Surfaces for Surface {
    fn derivative_u(&self, _: &State) -> [f32; 3] {
        self.derivative_u
    }
    fn derivative_v(&self, _: &State) -> [f32; 3] {
        self.derivative_v
    }
    fn vertex_color(&self, _: &State) -> [f32; 4] {
        self.vertex_color
    }
    fn second_uv(&self, _: &State) -> [f32; 2] {
        self.second_uv
    }
    fn footprint(&self, _: &State) -> Footprint {
        self.footprint
    }
}
