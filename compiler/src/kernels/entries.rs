//! The entries through which bodies run natively: for one point, and for blocks of eight.

use crate::emit::Body;
use crate::emit::scalar::Scalar;
use crate::storage::{Lanes, Placement};

/// Whether the CPU runs the native forms of eight points (AVX2 and FMA).
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

/// Whether it runs those of one point: fused multiply-add is part of other architectures.
fn native_point() -> bool {
    cfg!(not(target_arch = "x86_64")) || native_simd()
}

/// A body for one point.
///
/// # Safety
/// The CPU must have what it was compiled for: fused multiply-add, and on x86-64 AVX2.
pub(super) type Point = unsafe fn(inputs: &[u32], outputs: &mut [u32]);

/// The native form of a body for one point, on a CPU that runs it.
#[derive(Clone, Copy, Debug)]
pub struct NativePoint(Point);

impl NativePoint {
    /// This form, if the CPU runs it.
    pub(super) fn new(point: Point) -> Option<Self> {
        native_point().then_some(Self(point))
    }

    /// From the input words to the output words.
    #[inline]
    pub fn run(self, inputs: &[u32], outputs: &mut [u32]) {
        // SAFETY: the CPU was asked when it was made.
        unsafe { (self.0)(inputs, outputs) }
    }
}

/// A body for blocks of eight points.
///
/// # Safety
/// The CPU must have AVX2 and fused multiply-add.
pub(super) type Blocks = unsafe fn(lanes: &mut [Lanes], placement: &Placement<'_>);

/// `B` for one point, compiled with fused multiply-add.
#[cfg(target_arch = "x86_64")]
pub(super) const fn point<B: Body>() -> Point {
    #[target_feature(enable = "avx2,fma")]
    fn with_fma<B: Body>(inputs: &[u32], mut outputs: &mut [u32]) {
        B::run(Scalar, &inputs, &mut outputs);
    }
    with_fma::<B>
}

/// `B` for one point.
#[cfg(not(target_arch = "x86_64"))]
pub(super) const fn point<B: Body>() -> Point {
    fn plain<B: Body>(inputs: &[u32], mut outputs: &mut [u32]) {
        B::run(Scalar, &inputs, &mut outputs);
    }
    plain::<B>
}

/// `B` for blocks of eight points, with the most inputs it takes; none where no CPU has eight lanes.
pub(super) const fn blocks<B: Body>() -> Option<(Blocks, usize)> {
    #[cfg(target_arch = "x86_64")]
    {
        Some((crate::emit::avx2::run::<B>, crate::emit::avx2::MOST_INPUTS))
    }
    #[cfg(not(target_arch = "x86_64"))]
    {
        None
    }
}
