//! The subcommands, a file each.

pub mod compare;
pub mod eval;
pub mod nodes;
