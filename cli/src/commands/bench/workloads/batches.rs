//! Functions written by hand as something that shades batches.

use glam::Vec4;
use phenomenon_compiler::effects::{EffectSet, Renderer};
use phenomenon_compiler::engine::{Links, Shade, Shaded};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::State;

/// A material that asks nothing, from a function of batches. The function is a type of its own, so that it is inlined.
pub struct Batches<F>(pub F);

/// A material that asks nothing, from a function of one point.
pub fn of_points(shade: impl Fn(&State) -> Vec4 + Send + Sync + 'static) -> Box<dyn Shade> {
    Box::new(Batches(move |points: &[State], results: &mut [Shaded]| {
        for (point, result) in points.iter().zip(results) {
            *result = Shaded { color: shade(point).into(), ok: true };
        }
    }))
}

impl<F: Fn(&[State], &mut [Shaded]) + Send + Sync> Shade for Batches<F> {
    fn has_root(&self, root: RootKind) -> bool {
        root == RootKind::Material
    }

    fn effects(&self, _: RootKind) -> EffectSet {
        EffectSet::NONE
    }

    fn shade_linked(
        &self,
        _: RootKind,
        points: &[State],
        _: &Links,
        _: &mut dyn Renderer,
        results: &mut [Shaded],
    ) {
        self.0(points, results);
    }
}
