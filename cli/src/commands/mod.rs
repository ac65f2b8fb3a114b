//! The subcommands, a file each.

pub mod check;
pub mod compare;
pub mod eval;
pub mod nodes;
pub mod render;
