//! A hand-written shader of one point as something that shades batches.

use glam::{Vec3, Vec4};
use phenomenon_compiler::effects::{Effect, EffectSet, LightMode, Renderer};
use phenomenon_compiler::engine::{Links, Shade, Shaded};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::State;

use super::asking::Asking;

/// A parameter of a hand-written shader.
pub enum Parameter<'a> {
    /// A number.
    Scalar(&'a mut f32),
    /// A colour with alpha.
    Color(&'a mut Vec4),
    /// A vector.
    Vector(&'a mut Vec3),
}

/// A shader of one point, with its parameters as fields.
pub trait PointShader: Default + Send + Sync + 'static {
    /// The roots it has, each with the effects it may ask for.
    const ROOTS: &'static [(RootKind, &'static [Effect])];

    /// The parameter called `name`.
    fn parameter(&mut self, name: &str) -> Option<Parameter<'_>>;

    /// Shades one point for one of its roots.
    fn shade_point(&self, root: RootKind, point: &State, asking: &mut Asking<'_>) -> Shaded;
}

/// Shades batches point by point.
pub struct Pointwise<S>(pub S);

impl<S: PointShader> Shade for Pointwise<S> {
    fn has_root(&self, root: RootKind) -> bool {
        S::ROOTS.iter().any(|(kind, _)| *kind == root)
    }

    fn effects(&self, root: RootKind) -> EffectSet {
        let roots = S::ROOTS.iter().filter(|(kind, _)| *kind == root);
        roots.flat_map(|(_, effects)| effects.iter().copied()).collect()
    }

    fn link(&self, renderer: &mut dyn Renderer) -> Links {
        // All lights: what `Asking::diffuse` goes through.
        Links { light_lists: vec![renderer.light_list(&[], LightMode::All)], ..Links::default() }
    }

    fn shade_linked(
        &self,
        root: RootKind,
        points: &[State],
        links: &Links,
        renderer: &mut dyn Renderer,
        results: &mut [Shaded],
    ) {
        let mut asking = Asking::new(links, renderer);
        for (point, result) in points.iter().zip(results) {
            *result = self.0.shade_point(root, point, &mut asking);
        }
    }
}
