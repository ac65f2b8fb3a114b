//! The entries through which bodies run natively: for one point, and for blocks of eight.

use crate::emit::scalar::Scalar;
use crate::emit::{Body, MAX_OUTPUTS};
use crate::storage::{LANES, Lanes, Placement};

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

/// Runs `B` for one point, fused multiply-add in hardware where there is one.
pub fn scalar<B: Body>(inputs: &[u32], outputs: &mut [u32]) {
    #[cfg(target_arch = "x86_64")]
    {
        #[target_feature(enable = "avx2,fma")]
        fn with_fma<B: Body>(inputs: &[u32], mut outputs: &mut [u32]) {
            B::run(Scalar, &inputs, &mut outputs);
        }
        if native_simd() {
            // SAFETY: the features were detected.
            return unsafe { with_fma::<B>(inputs, outputs) };
        }
    }
    let mut outputs = outputs;
    B::run(Scalar, &inputs, &mut outputs);
}

/// Runs `B` over the blocks, eight lanes at once where the CPU can; lane by lane where it cannot, or
/// the body has more inputs than the wide form takes.
pub fn wide<B: Body>(lanes: &mut [Lanes], placement: &Placement<'_>) {
    #[cfg(target_arch = "x86_64")]
    if native_simd() && placement.sources.len() <= crate::emit::avx2::MOST_INPUTS {
        // SAFETY: the features were detected.
        return unsafe { crate::emit::avx2::run::<B>(lanes, placement) };
    }
    wide_portable::<B>(lanes, placement);
}

/// Runs `B` over the blocks lane by lane: same bits, any CPU.
pub fn wide_portable<B: Body>(lanes: &mut [Lanes], placement: &Placement<'_>) {
    let mut inputs = vec![0; placement.sources.len()];
    let mut outputs = [0; MAX_OUTPUTS];
    let mut outputs = &mut outputs[..B::OUTPUTS];
    for block in 0..placement.blocks {
        for lane in 0..LANES {
            for (word, input) in inputs.iter_mut().enumerate() {
                *input = lanes[placement.input(word, block)].0[lane];
            }
            B::run(Scalar, &&inputs[..], &mut outputs);
            for (word, output) in outputs.iter().enumerate() {
                lanes[placement.output(word, block)].0[lane] = *output;
            }
        }
    }
}
