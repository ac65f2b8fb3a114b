//! Eight points at once, over AVX2 and FMA.

use crate::engine::lanes::{Lanes, Placement};
use crate::nodes::Body;

/// Runs `B` over the blocks.
#[target_feature(enable = "avx2,fma")]
pub fn run<B: Body>(lanes: &mut [Lanes], placement: &Placement<'_>) {
    crate::engine::lanes::wide_portable::<B>(lanes, placement);
}
