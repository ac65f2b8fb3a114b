//! What a phenomenon requires of the renderer.

use std::collections::{BTreeMap, BTreeSet};

use super::RootKind;

/// Mental ray's requirements, joined over a phenomenon, its nodes and the phenomena it uses. What is
/// not set does not matter.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Requirements {
    /// `scanline`, `trace`, `shadow`, `face` and `space` with the word that is required.
    pub choices: BTreeMap<&'static str, &'static str>,
    /// Least number of texture spaces.
    pub texture: u32,
    /// Least number of bump bases.
    pub bump: u32,
    /// Level by which volumes are ordered.
    pub volume_level: u32,
    /// Orders of surface derivatives, 1 and 2.
    pub derivative: BTreeSet<u8>,
    /// Whether an output shader may run in parallel.
    pub parallel: Option<bool>,
    /// Shader types it may be used as; none given: all.
    pub apply: Option<BTreeSet<RootKind>>,
}

impl Requirements {
    /// Whether it may be used as a shader of this type.
    pub fn applies_to(&self, kind: RootKind) -> bool {
        self.apply.as_ref().is_none_or(|apply| apply.contains(&kind))
    }
}
