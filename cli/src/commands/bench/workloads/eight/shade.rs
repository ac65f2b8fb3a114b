//! Functions of eight points as something that shades batches.

use std::arch::x86_64::*;

use phenomenon_compiler::engine::{Shade, Shaded};
use phenomenon_compiler::kernels::native_simd;
use phenomenon_compiler::state::State;

use crate::commands::bench::workloads::batches::Batches;

/// `ten.json`; none where the CPU lacks AVX2.
pub fn ten() -> Option<Box<dyn Shade>> {
    by_eight(shade_ten)
}

/// `mixed.json`; none where the CPU lacks AVX2.
pub fn mixed() -> Option<Box<dyn Shade>> {
    by_eight(shade_mixed)
}

fn by_eight(shade: unsafe fn(&[State], &mut [Shaded])) -> Option<Box<dyn Shade>> {
    native_simd().then(|| {
        Box::new(Batches(move |points: &[State], results: &mut [Shaded]| {
            // SAFETY: the CPU has the features.
            unsafe { shade(points, results) };
        })) as Box<dyn Shade>
    })
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
