//! The subcommands, a file each.

pub mod bench;
pub mod check;
pub mod compare;
pub mod completions;
pub mod effects;
pub mod eval;
pub mod explain;
pub mod fmt;
pub mod lsp;
pub mod man;
pub mod nodes;
pub mod render;
pub mod schema;
pub mod show;
