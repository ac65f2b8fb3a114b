use super::boundaries::Boundaries;
use super::colors::Colors;
use super::directions::Directions;
use super::frames::Frames;
use super::kinds::{SameBits, Std};
use super::lobes::Lobes;
use super::numbers::Numbers;
use super::patterns::Patterns;

/// All that hand-written shaders compute with.
pub trait Arithmetic:
    Numbers + Colors + Boundaries + Frames + Lobes + Directions + Patterns + Send + Sync + 'static
{
    /// Whether it multiplies and adds in one step, which only some CPUs do fast.
    const FUSED: bool;
}

impl Arithmetic for Std {
    const FUSED: bool = false;
}

impl Arithmetic for SameBits {
    const FUSED: bool = true;
}
