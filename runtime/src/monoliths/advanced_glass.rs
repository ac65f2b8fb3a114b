use glam::{Vec3, Vec4};
use phenomenon_compiler::effects::{Effect, Trace};
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::State;

use super::asking::Asking;
use super::optics::{filtered, fresnel, fresnel_at, media, reflect, refract};
use super::pointwise::{Parameter, PointShader};

/// Request site of the reflection ray; the environment in its stead is one above.
const MIRROR: u64 = 0x676c_6173_7300;
/// Request site of the refraction ray; the environment in its stead is one above.
const THROUGH: u64 = MIRROR + 2;
/// Request site of the probe of thickness.
const PROBE: u64 = MIRROR + 4;

/// `graphs/glass/advanced_glass.json` by hand.
#[derive(Clone, Debug)]
pub struct AdvancedGlass {
    /// Light that passes where the glass is thin.
    pub surface_color: Vec4,
    /// Share of that light left at full depth.
    pub depth_color: Vec4,
    /// Opacity where the glass is thin.
    pub opacity: f32,
    /// Thickness at which nothing is seen through, in scene units.
    pub depth: f32,
    /// Index of refraction.
    pub ior: f32,
}

impl Default for AdvancedGlass {
    fn default() -> Self {
        Self {
            surface_color: Vec4::new(0.93, 0.98, 0.86, 1.0),
            depth_color: Vec4::new(0.006, 0.035, 0.0008, 1.0),
            opacity: 0.02,
            depth: 7.0,
            ior: 1.5,
        }
    }
}

impl PointShader for AdvancedGlass {
    const ROOTS: &'static [(RootKind, &'static [Effect])] = &[
        (
            RootKind::Material,
            &[
                Effect::TraceReflection,
                Effect::TraceRefraction,
                Effect::TraceEnvironment,
                Effect::TraceProbe,
                Effect::LightColor,
            ],
        ),
        (RootKind::Shadow, &[Effect::TraceProbe]),
    ];

    fn parameter(&mut self, name: &str) -> Option<Parameter<'_>> {
        Some(match name {
            "surface_color" => Parameter::Color(&mut self.surface_color),
            "depth_color" => Parameter::Color(&mut self.depth_color),
            "opacity" => Parameter::Scalar(&mut self.opacity),
            "depth" => Parameter::Scalar(&mut self.depth),
            "ior" => Parameter::Scalar(&mut self.ior),
            _ => return None,
        })
    }

    fn shade_point(&self, root: RootKind, point: &State, asking: &mut Asking<'_>) -> Shaded {
        let color = match root {
            RootKind::Shadow => self.shadow(point, asking),
            _ => self.material(point, asking),
        };
        Shaded { color: color.into(), ok: true }
    }
}

impl AdvancedGlass {
    fn material(&self, point: &State, asking: &mut Asking<'_>) -> Vec4 {
        let entering = !point.inv_normal;
        let (n1, n2) = media(point, self.ior);
        // Inside, only total reflection is followed.
        let mirror_share = if entering { fresnel(n1, n2, -point.dot_nd) } else { 0.0 };
        let mut color = Vec4::ZERO;
        if mirror_share != 1.0 {
            color = self.inner(point, n1, n2, asking) * (1.0 - mirror_share);
        }
        if mirror_share != 0.0 {
            let mirrored = asking.see(Trace::Reflection, point, reflect(point), MIRROR);
            color += mirrored * mirror_share;
        }
        color
    }

    /// What comes from behind the surface.
    fn inner(&self, point: &State, n1: f32, n2: f32, asking: &mut Asking<'_>) -> Vec4 {
        let entering = !point.inv_normal;
        let (direction, total) = refract(point, n1, n2);
        let mut tint = Vec3::ONE;
        let mut body_share = 0.0;
        if entering || total {
            let share = self.depth_share(point, direction, asking);
            tint = self.passed(share);
            if entering {
                body_share = self.cloud(share);
            }
        }
        let mut color = Vec4::ZERO;
        if body_share != 1.0 {
            let seen = asking.see(Trace::Refraction, point, direction, THROUGH);
            color = filtered(seen, tint) * (1.0 - body_share);
        }
        if body_share != 0.0 {
            color += (tint * asking.diffuse(point)).extend(1.0) * body_share;
        }
        color
    }

    /// Light is dimmed where it enters; the far side takes nothing away again.
    fn shadow(&self, point: &State, asking: &mut Asking<'_>) -> Vec4 {
        if point.inv_normal {
            return Vec4::ONE;
        }
        let share = self.depth_share(point, Vec3::from(point.direction), asking);
        let clear = (1.0 - self.cloud(share)) * (1.0 - fresnel_at(point, self.ior));
        (self.passed(share) * clear).extend(self.surface_color.w)
    }

    /// Length of the way through the glass, as a share of the full depth.
    fn depth_share(&self, point: &State, direction: Vec3, asking: &mut Asking<'_>) -> f32 {
        let thickness = asking.trace(Trace::Probe, point, direction, PROBE).distance;
        if self.depth == 0.0 {
            return if thickness > 0.0 { 1.0 } else { 0.0 };
        }
        (thickness / self.depth).clamp(0.0, 1.0)
    }

    /// Beer's law: what is left of the light falls geometrically.
    fn passed(&self, share: f32) -> Vec3 {
        self.surface_color.truncate() * self.depth_color.truncate().powf(share)
    }

    /// From the least opacity to 1 at full depth.
    fn cloud(&self, share: f32) -> f32 {
        self.opacity * (1.0 - share) + share
    }
}
