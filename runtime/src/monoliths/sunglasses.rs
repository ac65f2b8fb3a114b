use glam::{Vec4, Vec4Swizzles};
use phenomenon_compiler::effects::{Effect, Trace};
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::{Field, State};

use super::arithmetic::Arithmetic;
use super::asking::Asking;
use super::optics::{fresnel, reflect, refract};
use super::pointwise::{Parameter, PointShader};
use super::site::Site;

const THROUGH: Site = Site::of("glass/through");
const MIRROR: Site = Site::of("glass/mirror");
/// Index of refraction of the glass.
const IOR: f32 = 1.5;

/// `graphs/sunglasses/sunglasses.json` by hand.
#[derive(Clone, Debug)]
pub struct Sunglasses {
    /// Colour of the matt surface.
    pub surface_color: Vec4,
    /// Light that passes at the top.
    pub tint_top: Vec4,
    /// Light that passes at the bottom.
    pub tint_bottom: Vec4,
    /// Share of the mirror image that a bright film adds to Fresnel's.
    pub reflectivity: f32,
    /// Share of what is seen through.
    pub refractivity: f32,
    /// How much of the film shows.
    pub rainbow: f32,
}

impl Default for Sunglasses {
    fn default() -> Self {
        Self {
            surface_color: Vec4::new(0.035, 0.03, 0.025, 1.0),
            tint_top: Vec4::new(0.1, 0.065, 0.04, 1.0),
            tint_bottom: Vec4::new(0.92, 0.8, 0.62, 1.0),
            reflectivity: 0.22,
            refractivity: 1.0,
            rainbow: 0.5,
        }
    }
}

impl PointShader for Sunglasses {
    const ROOTS: &'static [(RootKind, &'static [Effect])] = &[
        (
            RootKind::Material,
            &[Effect::TraceReflection, Effect::TraceRefraction, Effect::LightColor],
        ),
        (RootKind::Shadow, &[]),
    ];

    const FIELDS: &'static [Field] = &[Field::V];

    fn parameter(&mut self, name: &str) -> Option<Parameter<'_>> {
        Some(match name {
            "surface_color" => Parameter::Color(&mut self.surface_color),
            "tint_top" => Parameter::Color(&mut self.tint_top),
            "tint_bottom" => Parameter::Color(&mut self.tint_bottom),
            "reflectivity" => Parameter::Scalar(&mut self.reflectivity),
            "refractivity" => Parameter::Scalar(&mut self.refractivity),
            "rainbow" => Parameter::Scalar(&mut self.rainbow),
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
        let color = match (root, point.inv_normal) {
            (RootKind::Shadow, false) => {
                let tint = self.tint::<A>(point);
                (tint.xyz() * self.refractivity).extend(tint.w)
            }
            // The glass takes its share of the light once.
            (RootKind::Shadow, true) => Vec4::ONE,
            (_, false) => self.filmed::<A>(point, asking),
            // The far side of the glass only lets the ray out.
            (_, true) if self.refractivity > 0.0 => through::<A>(point, asking),
            (_, true) => Vec4::W,
        };
        Shaded { color: color.into(), ok: true }
    }
}

impl Sunglasses {
    /// Light that passes: it fades from the bottom to the top.
    #[inline(always)]
    fn tint<A: Arithmetic>(&self, point: &State) -> Vec4 {
        let [_, v] = point.uv;
        A::mix(self.tint_bottom, self.tint_top, A::smooth_step(v, 0.15, 0.85))
    }

    /// The glass under its film, whose hue is the cosine of the view angle, in turns.
    #[inline(always)]
    fn filmed<A: Arithmetic>(&self, point: &State, asking: &mut Asking<'_>) -> Vec4 {
        let glossy = self.glossy::<A>(point, asking);
        if self.rainbow == 0.0 {
            return glossy;
        }
        let turn = A::dot(point.normal.into(), point.direction.into()).abs();
        let film = A::of_hue(turn, 1.0, 1.0);
        let overlaid = A::overlay(glossy.xyz(), film).extend(glossy.w);
        A::mix(glossy, overlaid, self.rainbow)
    }

    /// Light on the surface, what is seen through, and what is mirrored.
    #[inline(always)]
    fn glossy<A: Arithmetic>(&self, point: &State, asking: &mut Asking<'_>) -> Vec4 {
        // Of the mirror image: Fresnel's share at least, as the film has it at most.
        let share = A::mix(fresnel::<A>(point, IOR), 1.0, self.reflectivity);
        let (mut surface, mut mirrored) = (Vec4::ZERO, Vec4::ZERO);
        if share != 1.0 {
            let mut color = asking.matt::<A>(point, self.surface_color.xyz());
            if self.refractivity != 0.0 {
                let tinted = self.tint::<A>(point) * through::<A>(point, asking);
                color += A::mix(Vec4::ZERO, tinted, self.refractivity).xyz();
            }
            surface = color.extend(1.0);
        }
        if share != 0.0 {
            mirrored = asking.see(Trace::Reflection, point, reflect::<A>(point), MIRROR);
        }
        A::mix(surface, mirrored, share)
    }
}

/// What is seen through the glass.
#[inline(always)]
fn through<A: Arithmetic>(point: &State, asking: &mut Asking<'_>) -> Vec4 {
    let (direction, _) = refract::<A>(point, IOR);
    asking.see(Trace::Refraction, point, direction, THROUGH)
}
