use glam::Vec4;
use phenomenon_compiler::effects::{Effect, Trace};
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::State;

use super::asking::Asking;
use super::optics::{filtered, fresnel_at, reflect};
use super::pointwise::{Parameter, PointShader};

/// Request site of the reflection ray.
const MIRROR: u64 = 0x6d69_7272_6f72_0100;

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

    fn shade_point(&self, _: RootKind, point: &State, asking: &mut Asking<'_>) -> Shaded {
        let share = fresnel_at(point, self.ior);
        let mut color = Vec4::W;
        if share != 0.0 {
            let seen = asking.trace(Trace::Reflection, point, reflect(point), MIRROR);
            let seen = filtered(seen.color.into(), self.tint.truncate());
            color = color.lerp(seen, share);
        }
        Shaded { color: color.into(), ok: true }
    }
}
