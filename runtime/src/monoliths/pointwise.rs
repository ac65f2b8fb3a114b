//! A hand-written shader of one point as something that shades batches.

use std::collections::BTreeSet;
use std::marker::PhantomData;

use glam::{Vec3, Vec4};
use phenomenon_compiler::effects::{Effect, EffectSet, LightMode, Renderer};
use phenomenon_compiler::engine::{Links, Shade, Shaded};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::{Field, FieldSet, State};
use phenomenon_compiler::values::Texture;

use super::arithmetic::{Arithmetic, Std};
use super::asking::Asking;

/// A parameter of a hand-written shader.
pub enum Parameter<'a> {
    /// A number.
    Scalar(&'a mut f32),
    /// A whole number; of a choice the position of its name.
    Integer(&'a mut i32),
    /// A colour with alpha.
    Color(&'a mut Vec4),
    /// A vector.
    Vector(&'a mut Vec3),
}

/// A shader of one point, with its parameters as fields.
pub trait PointShader: Default + Send + Sync + 'static {
    /// The roots it has, each with the effects it may ask for.
    const ROOTS: &'static [(RootKind, &'static [Effect])];

    /// The fields it reads of those that the renderer works out only where something reads them: surface
    /// coordinates, and what [`Asking::look_up`] finds.
    const FIELDS: &'static [Field] = &[];

    /// The pictures it reads, by their numbers in [`Asking::texel`].
    fn textures(&self) -> Vec<Texture> {
        Vec::new()
    }

    /// The parameter called `name`.
    fn parameter(&mut self, name: &str) -> Option<Parameter<'_>>;

    /// Shades one point for one of its roots. It is written once for all kinds of arithmetic. It is inlined
    /// always, and so is what it calls that computes: what multiplies and adds in one step is compiled for CPUs
    /// that do.
    fn shade_point<A: Arithmetic>(
        &self,
        root: RootKind,
        point: &State,
        asking: &mut Asking<'_>,
    ) -> Shaded;
}

/// Shades batches point by point.
pub struct Pointwise<S, A = Std> {
    shader: S,
    arithmetic: PhantomData<A>,
}

impl<S: PointShader, A: Arithmetic> Pointwise<S, A> {
    /// Of a shader with its parameters.
    pub fn new(shader: S) -> Self {
        Self { shader, arithmetic: PhantomData }
    }

    /// Shades points one after another.
    #[inline(always)]
    fn each(&self, root: RootKind, points: &[State], asking: &mut Asking<'_>, to: &mut [Shaded]) {
        for (point, result) in points.iter().zip(to) {
            *result = self.shader.shade_point::<A>(root, point, asking);
        }
    }

    /// The same, compiled for CPUs that multiply and add in one step.
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma")]
    fn fused(&self, root: RootKind, points: &[State], asking: &mut Asking<'_>, to: &mut [Shaded]) {
        self.each(root, points, asking, to);
    }
}

impl<S: PointShader, A: Arithmetic> Shade for Pointwise<S, A> {
    fn has_root(&self, root: RootKind) -> bool {
        S::ROOTS.iter().any(|(kind, _)| *kind == root)
    }

    fn effects(&self, root: RootKind) -> EffectSet {
        let roots = S::ROOTS.iter().filter(|(kind, _)| *kind == root);
        roots.flat_map(|(_, effects)| effects.iter().copied()).collect()
    }

    fn fields(&self, root: RootKind) -> FieldSet {
        if !self.has_root(root) {
            return FieldSet::NONE;
        }
        let always = |field: &Field| field.of_point() && !matches!(field, Field::U | Field::V);
        let always = Field::ALL.iter().filter(|field| always(field));
        always.chain(S::FIELDS).copied().collect()
    }

    fn textures(&self) -> BTreeSet<Texture> {
        self.shader.textures().into_iter().collect()
    }

    fn link(&self, renderer: &mut dyn Renderer) -> Links {
        // All lights: what `Asking::lights` counts.
        let light_lists = vec![renderer.light_list(&[], LightMode::All)];
        let textures = self.shader.textures();
        let textures = textures.iter().map(|texture| renderer.texture(texture)).collect();
        Links { light_lists, textures }
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
        #[cfg(target_arch = "x86_64")]
        if A::FUSED && is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
            // SAFETY: the CPU was asked for what the function needs.
            return unsafe { self.fused(root, points, &mut asking, results) };
        }
        self.each(root, points, &mut asking, results);
    }
}
