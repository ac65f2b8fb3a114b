//! Which roots are called.

use phenomenon_compiler::graph::RootKind;

/// The shader types this renderer calls. Roots of other types are checked and compiled by whoever
/// wants them, but no picture depends on them.
pub const CALLED_ROOTS: &[RootKind] =
    &[RootKind::Material, RootKind::Shadow, RootKind::Environment];
