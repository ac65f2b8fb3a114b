use glam::{Vec3, Vec4, Vec4Swizzles};
use phenomenon_compiler::effects::Effect;
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::State;

use super::arithmetic::Arithmetic;
use super::asking::Asking;
use super::pointwise::{Parameter, PointShader};

/// `graphs/sky/gradient_sky.json` by hand.
#[derive(Clone, Debug)]
pub struct GradientSky {
    /// Colour overhead.
    pub zenith: Vec4,
    /// Colour at eye level.
    pub horizon: Vec4,
    /// Colour below.
    pub ground: Vec4,
    /// What the sun adds.
    pub sun_color: Vec4,
    /// Towards the sun, any length.
    pub sun_direction: Vec3,
    /// Cosine of the angle from the middle of the sun to where it ends.
    pub sun_edge: f32,
}

impl Default for GradientSky {
    fn default() -> Self {
        Self {
            zenith: Vec4::new(0.12, 0.28, 0.62, 1.0),
            horizon: Vec4::new(0.75, 0.85, 0.95, 1.0),
            ground: Vec4::new(0.3, 0.28, 0.25, 1.0),
            sun_color: Vec4::new(12.0, 11.0, 9.0, 1.0),
            sun_direction: Vec3::new(0.5, 0.8, 0.3),
            sun_edge: 0.9985,
        }
    }
}

impl PointShader for GradientSky {
    const ROOTS: &'static [(RootKind, &'static [Effect])] = &[(RootKind::Environment, &[])];

    fn parameter(&mut self, name: &str) -> Option<Parameter<'_>> {
        Some(match name {
            "zenith" => Parameter::Color(&mut self.zenith),
            "horizon" => Parameter::Color(&mut self.horizon),
            "ground" => Parameter::Color(&mut self.ground),
            "sun_color" => Parameter::Color(&mut self.sun_color),
            "sun_direction" => Parameter::Vector(&mut self.sun_direction),
            "sun_edge" => Parameter::Scalar(&mut self.sun_edge),
            _ => return None,
        })
    }

    #[inline(always)]
    fn shade_point<A: Arithmetic>(&self, _: RootKind, point: &State, _: &mut Asking<'_>) -> Shaded {
        let direction = Vec3::from(point.direction);
        let rise = direction.y.clamp(0.0, 1.0).sqrt();
        let near_sun = A::dot(direction, A::normalised(self.sun_direction));
        let sun = self.sun_color.xyz() * A::smooth_step(near_sun, self.sun_edge, 1.0);
        let sky = A::mix(self.horizon, self.zenith, rise) + sun.extend(0.0);
        let above = A::smooth_step(direction.y, -0.04, 0.0);
        Shaded { color: A::mix(self.ground, sky, above).into(), ok: true }
    }
}
