use glam::{Vec3, Vec4, Vec4Swizzles};
use phenomenon_compiler::effects::{Effect, Trace};
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::State;

use super::asking::Asking;
use super::optics::{fresnel_at, reflect};
use super::pointwise::{Parameter, PointShader};

/// Request site of the reflection ray.
const MIRROR: u64 = 0x7261_696e_626f_7700;

/// `graphs/rainbow/rainbow.json` by hand.
#[derive(Clone, Debug)]
pub struct Rainbow {
    /// Diffuse colour below the film.
    pub surface_color: Vec4,
    /// Light from all around.
    pub ambient: Vec4,
    /// Purity of the film's colours.
    pub saturation: f32,
    /// How much of the film shows.
    pub strength: f32,
    /// Share of the mirror image that shows.
    pub reflectivity: f32,
    /// Index of refraction of the film.
    pub ior: f32,
}

impl Default for Rainbow {
    fn default() -> Self {
        Self {
            surface_color: Vec4::new(0.55, 0.55, 0.6, 1.0),
            ambient: Vec4::new(0.25, 0.27, 0.3, 1.0),
            saturation: 0.9,
            strength: 0.85,
            reflectivity: 1.0,
            ior: 1.8,
        }
    }
}

impl PointShader for Rainbow {
    const ROOTS: &'static [(RootKind, &'static [Effect])] =
        &[(RootKind::Material, &[Effect::TraceReflection, Effect::LightColor])];

    fn parameter(&mut self, name: &str) -> Option<Parameter<'_>> {
        Some(match name {
            "surface_color" => Parameter::Color(&mut self.surface_color),
            "ambient" => Parameter::Color(&mut self.ambient),
            "saturation" => Parameter::Scalar(&mut self.saturation),
            "strength" => Parameter::Scalar(&mut self.strength),
            "reflectivity" => Parameter::Scalar(&mut self.reflectivity),
            "ior" => Parameter::Scalar(&mut self.ior),
            _ => return None,
        })
    }

    fn shade_point(&self, _: RootKind, point: &State, asking: &mut Asking<'_>) -> Shaded {
        let share = fresnel_at(point, self.ior) * self.reflectivity;
        let mut glossy = Vec4::ZERO;
        if share != 1.0 {
            let light = self.ambient.xyz() + asking.diffuse(point);
            let surface = self.surface_color.xyz() * light;
            glossy = surface.extend(self.surface_color.w) * (1.0 - share);
        }
        if share != 0.0 {
            let seen = asking.trace(Trace::Reflection, point, reflect(point), MIRROR);
            glossy += Vec4::from(seen.color) * share;
        }
        let facing = Vec3::from(point.normal).dot(Vec3::from(point.direction));
        let film = rainbow(facing.abs(), self.saturation);
        let overlaid = overlay(glossy.xyz(), film).extend(glossy.w);
        Shaded { color: glossy.lerp(overlaid, self.strength).into(), ok: true }
    }
}

/// The colour of a hue in turns, at value 1.
fn rainbow(hue: f32, saturation: f32) -> Vec3 {
    let sextants = (hue - hue.floor()) * 6.0;
    let red = (sextants - 3.0).abs() - 1.0;
    let green = 2.0 - (sextants - 2.0).abs();
    let blue = 2.0 - (sextants - 4.0).abs();
    let pure = Vec3::new(red, green, blue).clamp(Vec3::ZERO, Vec3::ONE);
    Vec3::ONE.lerp(pure, saturation)
}

/// A layer of colours in 0..=1 laid over a base; bases of 1 and more pass.
fn overlay(base: Vec3, layer: Vec3) -> Vec3 {
    let blended = base * (base + 2.0 * layer * (1.0 - base));
    let lit = Vec3::select(base.cmpgt(Vec3::ZERO), blended, Vec3::ZERO);
    Vec3::select(base.cmpge(Vec3::ONE), base, lit)
}
