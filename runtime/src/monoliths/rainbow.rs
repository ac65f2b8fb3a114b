use glam::{Vec4, Vec4Swizzles};
use phenomenon_compiler::effects::{Effect, Trace};
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::State;

use super::arithmetic::Arithmetic;
use super::asking::Asking;
use super::optics::{fresnel, reflect};
use super::pointwise::{Parameter, PointShader};
use super::site::Site;

const MIRROR: Site = Site::of("mirror");

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

    #[inline(always)]
    fn shade_point<A: Arithmetic>(
        &self,
        _: RootKind,
        point: &State,
        asking: &mut Asking<'_>,
    ) -> Shaded {
        let share = fresnel::<A>(point, self.ior) * self.reflectivity;
        let (mut surface, mut mirrored) = (Vec4::ZERO, Vec4::ZERO);
        if share != 1.0 {
            let color = self.surface_color.xyz();
            let lit = color * self.ambient.xyz() + asking.matt::<A>(point, color);
            surface = lit.extend(self.surface_color.w);
        }
        if share != 0.0 {
            mirrored = asking.see(Trace::Reflection, point, reflect::<A>(point), MIRROR);
        }
        let glossy = A::mix(surface, mirrored, share);
        let facing = A::dot(point.normal.into(), point.direction.into());
        let film = A::of_hue(facing.abs(), self.saturation, 1.0);
        let overlaid = A::overlay(glossy.xyz(), film).extend(glossy.w);
        Shaded { color: A::mix(glossy, overlaid, self.strength).into(), ok: true }
    }
}
