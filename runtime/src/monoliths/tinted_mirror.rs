use glam::Vec4;
use phenomenon_compiler::effects::{Effect, Trace};
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::State;

use super::arithmetic::Arithmetic;
use super::asking::Asking;
use super::optics::{filtered, fresnel, reflect};
use super::pointwise::{Parameter, PointShader};
use super::site::Site;

const MIRROR: Site = Site::of("mirror");

/// `graphs/mirror/tinted_mirror.json` by hand.
#[derive(Clone, Debug)]
pub struct TintedMirror {
    /// Colour of the reflection.
    pub tint: Vec4,
    /// Index of refraction.
    pub ior: f32,
}

impl Default for TintedMirror {
    fn default() -> Self {
        Self { tint: Vec4::new(0.9, 0.7, 0.4, 1.0), ior: 1.5 }
    }
}

impl PointShader for TintedMirror {
    const ROOTS: &'static [(RootKind, &'static [Effect])] =
        &[(RootKind::Material, &[Effect::TraceReflection])];

    fn parameter(&mut self, name: &str) -> Option<Parameter<'_>> {
        Some(match name {
            "tint" => Parameter::Color(&mut self.tint),
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
        let share = fresnel::<A>(point, self.ior);
        let mut mirrored = Vec4::ZERO;
        if share != 0.0 {
            mirrored = asking.see(Trace::Reflection, point, reflect::<A>(point), MIRROR);
            mirrored = filtered(mirrored, self.tint.truncate());
        }
        Shaded { color: A::mix(Vec4::W, mirrored, share).into(), ok: true }
    }
}
