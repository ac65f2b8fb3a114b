//! Functions of eight points as something that shades batches.

use std::arch::x86_64::*;

use phenomenon_compiler::effects::{EffectSet, Renderer};
use phenomenon_compiler::engine::{Links, Shade, Shaded};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::kernels::native_simd;
use phenomenon_compiler::state::State;

/// A material that asks nothing, for CPUs with AVX2 and FMA.
struct ByEight(unsafe fn(&[State], &mut [Shaded]));

/// `ten.json`; none where the CPU lacks AVX2.
pub fn ten() -> Option<Box<dyn Shade>> {
    by_eight(shade_ten)
}

/// `mixed.json`; none where the CPU lacks AVX2.
pub fn mixed() -> Option<Box<dyn Shade>> {
    by_eight(shade_mixed)
}

fn by_eight(shade: unsafe fn(&[State], &mut [Shaded])) -> Option<Box<dyn Shade>> {
    native_simd().then(|| Box::new(ByEight(shade)) as Box<dyn Shade>)
}

/// A function over all points, compiled for AVX2 with all it calls.
macro_rules! shaders {
    ($($name:ident: $of:path;)+) => {$(
        #[target_feature(enable = "avx2,fma")]
        fn $name(points: &[State], results: &mut [Shaded]) {
            for (points, results) in points.chunks(8).zip(results.chunks_mut(8)) {
                let last = points.len() - 1;
                let words = $of(&[0, 1, 2, 3, 4, 5, 6, 7].map(|lane: usize| &points[lane.min(last)]));
                write(words, results);
            }
        }
    )+};
}
shaders! {
    shade_ten: super::ten::shade;
    shade_mixed: super::mixed::shade;
}

#[target_feature(enable = "avx2,fma")]
#[inline]
fn write(words: [__m256; 4], results: &mut [Shaded]) {
    // SAFETY: both are 128 bytes, and all bit patterns are numbers.
    let words = unsafe { std::mem::transmute::<[__m256; 4], [[f32; 8]; 4]>(words) };
    for (lane, result) in results.iter_mut().enumerate() {
        *result = Shaded { color: words.map(|word| word[lane]), ok: true };
    }
}

impl Shade for ByEight {
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
        // SAFETY: there is one of these only where the CPU has the features; see `by_eight`.
        unsafe { (self.0)(points, results) };
    }
}
