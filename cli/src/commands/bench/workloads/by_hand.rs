//! A function of one point as something that shades batches.

use glam::Vec4;
use phenomenon_compiler::effects::{EffectSet, Renderer};
use phenomenon_compiler::engine::{Links, Shade, Shaded};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::State;

/// A material that asks nothing. The function is a type of its own, so that it is inlined.
pub struct ByHand<F>(pub F);

impl<F: Fn(&State) -> Vec4 + Send + Sync> Shade for ByHand<F> {
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
        for (point, result) in points.iter().zip(results) {
            *result = Shaded { color: self.0(point).into(), ok: true };
        }
    }
}
