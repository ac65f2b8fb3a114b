//! The entries through which bodies run natively: for one point, and for blocks of eight.

use super::block;
use super::recorded::{Recorded, kept, recorder};
use crate::emit::Body;
use crate::emit::scalar::Scalar;
use crate::storage::{Lanes, Placement};

/// Whether the CPU runs the native forms (AVX2 and FMA).
pub fn native_simd() -> bool {
    #[cfg(target_arch = "x86_64")]
    {
        std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma")
    }
    #[cfg(not(target_arch = "x86_64"))]
    {
        false
    }
}

/// What `B` recorded, for what it knows before shading.
fn recorded<B: Body>(word: &dyn Fn(usize) -> u32) -> &'static Recorded {
    let fixed = B::fixed(word);
    Recorded::of(recorder::<B>, B::OUTPUTS, if fixed.is_empty() { &[] } else { kept(&fixed) })
}

/// Runs `B` for one point: compiled with fused multiply-add where the CPU has it, from its operations
/// where it has not.
#[cfg(target_arch = "x86_64")]
pub(super) fn scalar<B: Body>(inputs: &[u32], outputs: &mut [u32]) {
    #[target_feature(enable = "avx2,fma")]
    fn with_fma<B: Body>(inputs: &[u32], mut outputs: &mut [u32]) {
        B::run(Scalar, &inputs, &mut outputs);
    }
    if native_simd() {
        // SAFETY: the features were detected.
        return unsafe { with_fma::<B>(inputs, outputs) };
    }
    super::point::run(recorded::<B>(&|word| inputs[word]), inputs, outputs);
}

/// Runs `B` for one point.
#[cfg(not(target_arch = "x86_64"))]
pub(super) fn scalar<B: Body>(inputs: &[u32], mut outputs: &mut [u32]) {
    B::run(Scalar, &inputs, &mut outputs);
}

/// Runs `B` over the blocks: compiled for eight lanes at once where the CPU can; from its operations
/// where it cannot, or the body has more inputs than the wide form takes.
pub(super) fn wide<B: Body>(lanes: &mut [Lanes], placement: &Placement<'_>) {
    #[cfg(target_arch = "x86_64")]
    if native_simd() && placement.sources.len() <= crate::emit::avx2::MOST_INPUTS {
        // SAFETY: the features were detected.
        return unsafe { crate::emit::avx2::run::<B>(lanes, placement) };
    }
    let word = |word| lanes[placement.input(word, 0)].0[0];
    let recorded = recorded::<B>(&word);
    block::run(recorded, lanes, placement);
}
