use glam::{Vec3, Vec4};
use phenomenon_compiler::effects::{Effect, Trace};
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::State;

use super::arithmetic::Arithmetic;
use super::asking::Asking;
use super::optics::{filtered, fresnel, reflect, refract};
use super::pointwise::{Parameter, PointShader};
use super::site::Site;

const MIRROR: [Site; 2] = [Site::of("mirror"), Site::of("mirror_sky")];
const THROUGH: [Site; 2] = [Site::of("through"), Site::of("through_sky")];
const AHEAD: Site = Site::of("ahead");
const BEHIND: Site = Site::of("behind");

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

    #[inline(always)]
    fn shade_point<A: Arithmetic>(
        &self,
        root: RootKind,
        point: &State,
        asking: &mut Asking<'_>,
    ) -> Shaded {
        let color = match root {
            RootKind::Shadow => self.shadow::<A>(point, asking),
            _ => self.material::<A>(point, asking),
        };
        Shaded { color: color.into(), ok: true }
    }
}

impl AdvancedGlass {
    #[inline(always)]
    fn material<A: Arithmetic>(&self, point: &State, asking: &mut Asking<'_>) -> Vec4 {
        // Inside, only total reflection is followed.
        let mirror_share = if point.inv_normal { 0.0 } else { fresnel::<A>(point, self.ior) };
        let (mut inner, mut mirrored) = (Vec4::ZERO, Vec4::ZERO);
        if mirror_share != 1.0 {
            inner = self.inner::<A>(point, asking);
        }
        if mirror_share != 0.0 {
            mirrored = asking.see_or_sky(Trace::Reflection, point, reflect::<A>(point), MIRROR);
        }
        A::mix(inner, mirrored, mirror_share)
    }

    /// What comes from behind the surface.
    #[inline(always)]
    fn inner<A: Arithmetic>(&self, point: &State, asking: &mut Asking<'_>) -> Vec4 {
        let entering = !point.inv_normal;
        let (direction, total) = refract::<A>(point, self.ior);
        let (mut tint, mut body_share) = (Vec3::ONE, 0.0);
        let opaque = self.opacity >= 1.0;
        if entering || total && !opaque {
            let share = self.depth_share::<A>(point, direction, AHEAD, asking);
            tint = self.passed::<A>(share);
            body_share = if entering { A::mix(self.opacity, 1.0, share) } else { 0.0 };
        }
        let (mut seen, mut body) = (Vec4::ZERO, Vec4::ZERO);
        if body_share != 1.0 {
            seen = Vec4::W;
            if !opaque {
                seen = asking.see_or_sky(Trace::Refraction, point, direction, THROUGH);
                seen = filtered(seen, tint);
            }
        }
        if body_share != 0.0 {
            body = asking.matt::<A>(point, tint).extend(1.0);
        }
        A::mix(seen, body, body_share)
    }

    /// Light is dimmed where it enters; the far side takes nothing away again.
    #[inline(always)]
    fn shadow<A: Arithmetic>(&self, point: &State, asking: &mut Asking<'_>) -> Vec4 {
        if point.inv_normal {
            return Vec4::ONE;
        }
        let share = self.depth_share::<A>(point, point.direction.into(), BEHIND, asking);
        let clear = 1.0 - A::mix(self.opacity, 1.0, share);
        let passed = self.passed::<A>(share) * (clear * (1.0 - fresnel::<A>(point, self.ior)));
        passed.extend(self.surface_color.w)
    }

    /// Length of the way through the glass, as a share of the full depth.
    #[inline(always)]
    fn depth_share<A: Arithmetic>(
        &self,
        point: &State,
        direction: Vec3,
        site: Site,
        asking: &mut Asking<'_>,
    ) -> f32 {
        let thickness = asking.trace(Trace::Probe, point, direction, site).distance;
        A::share(thickness, self.depth)
    }

    /// Beer's law: what is left of the light falls geometrically.
    #[inline(always)]
    fn passed<A: Arithmetic>(&self, share: f32) -> Vec3 {
        self.surface_color.truncate() * A::powers(self.depth_color.truncate(), share)
    }
}
