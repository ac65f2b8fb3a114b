use super::boundaries::Boundaries;
use super::bumps::Bumps;
use super::colors::Colors;
use super::directions::Directions;
use super::flakes::Flakes;
use super::frames::Frames;
use super::highlights::Highlights;
use super::kinds::{SameBits, Std};
use super::lobes::Lobes;
use super::noises::Noises;
use super::numbers::Numbers;
use super::patterns::Patterns;

/// All that hand-written shaders compute with.
pub trait Arithmetic:
    Numbers
    + Colors
    + Boundaries
    + Frames
    + Lobes
    + Directions
    + Highlights
    + Noises
    + Flakes
    + Bumps
    + Patterns
    + Send
    + Sync
    + 'static
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
