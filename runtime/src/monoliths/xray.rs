use glam::{Vec3, Vec4};
use phenomenon_compiler::effects::{Effect, Trace};
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::State;

use super::arithmetic::Arithmetic;
use super::asking::Asking;
use super::pointwise::{Parameter, PointShader};
use super::site::{Site, turns};
use super::strata::Strata;

const BEHIND: Site = Site::of("behind");
const THIN: Site = Site::of("thin");
const WALL: Site = Site::of("thin/wall");

/// `graphs/xray/xray.json` by hand.
#[derive(Clone, Debug)]
pub struct Xray {
    /// Colour of thin walls.
    pub glow: Vec4,
    /// Walls up to here glow wholly.
    pub near: f32,
    /// Walls from here do not glow.
    pub far: f32,
    /// How much a glowing wall hides.
    pub intensity: f32,
    /// 0 looks into the wall squarely, 1 along the view.
    pub slant: f32,
    /// How far the rays spread, in radians.
    pub spread: f32,
    /// Rays for each point.
    pub samples: i32,
}

impl Default for Xray {
    fn default() -> Self {
        Self {
            glow: Vec4::new(0.391_572_48, 0.715_693_5, 1.0, 1.0),
            near: 0.05,
            far: 1.2,
            intensity: 0.8,
            slant: 0.9,
            spread: 0.35,
            samples: 9,
        }
    }
}

impl PointShader for Xray {
    const ROOTS: &'static [(RootKind, &'static [Effect])] = &[
        (RootKind::Material, &[Effect::TraceProbe, Effect::TraceTransparent]),
        (RootKind::Shadow, &[]),
    ];

    fn parameter(&mut self, name: &str) -> Option<Parameter<'_>> {
        Some(match name {
            "glow" => Parameter::Color(&mut self.glow),
            "near" => Parameter::Scalar(&mut self.near),
            "far" => Parameter::Scalar(&mut self.far),
            "intensity" => Parameter::Scalar(&mut self.intensity),
            "slant" => Parameter::Scalar(&mut self.slant),
            "spread" => Parameter::Scalar(&mut self.spread),
            "samples" => Parameter::Integer(&mut self.samples),
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
        if root == RootKind::Shadow {
            return Shaded { color: Vec4::ONE.into(), ok: true };
        }
        // Where a ray leaves the body, it only passes on.
        let thin = if point.inv_normal { 0.0 } else { self.thin::<A>(point, asking) };
        let glows = self.intensity * thin;
        let mut behind = Vec4::ZERO;
        if glows != 1.0 {
            behind = asking.see(Trace::Transparent, point, point.direction.into(), BEHIND);
        }
        Shaded { color: A::mix(behind, self.glow, glows).into(), ok: true }
    }
}

impl Xray {
    /// How thin the body is, 0 to 1: the mean over a cone of rays into it.
    #[inline(always)]
    fn thin<A: Arithmetic>(&self, point: &State, asking: &mut Asking<'_>) -> f32 {
        let axis = A::mix(-Vec3::from(point.normal), point.direction.into(), self.slant);
        let count = turns(self.samples);
        let strata = Strata::of(count);
        let mut sum = 0.0;
        for sample in 0..count {
            let numbers = strata.spread(sample, THIN.numbers(point, sample));
            let inwards = A::in_cone(axis, self.spread, numbers);
            let wall = asking.trace(Trace::Probe, point, inwards, WALL.turn(sample)).distance;
            sum += A::smooth_step(wall, self.far, self.near);
        }
        sum / count.max(1) as f32
    }
}
