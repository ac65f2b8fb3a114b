//! The flags that say what is looked at.

use std::path::Path;

use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::specialise::Asking;
use phenomenon_runtime::link::{NodePath, TextValue};

/// What the command line says about what is looked at.
#[derive(Clone, Debug, Default)]
pub struct Flags<'a> {
    /// `--set`.
    pub set: &'a [TextValue],
    /// `--preset`.
    pub preset: &'a [String],
    /// `--node`.
    pub node: Option<&'a NodePath>,
    /// `--scene`.
    pub stage: Option<&'a Path>,
    /// `--allow`.
    pub allow: &'a [Code],
    /// `--stats`: whether evaluations of nodes are counted.
    pub count: bool,
    /// `--all-effects`: whether all is asked for that could be.
    pub asking: Asking,
    /// Whether nothing is said of what is found and is no error: it was said before.
    pub silent: bool,
}
