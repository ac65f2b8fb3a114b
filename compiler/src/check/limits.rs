//! How large the parts of a file may be.

/// Most nodes a graph may have.
pub const MAX_NODES: usize = 1_000_000;

/// Longest name of a phenomenon, a parameter or a node, in characters.
pub const MAX_NAME: usize = 256;

/// Most parts the parameters of a phenomenon may have in all.
pub const MAX_PARTS: usize = 65_536;

/// Most outputs a phenomenon may declare.
pub const MAX_OUTPUTS: usize = 64;

/// Most phenomena within a file, those within others included.
pub const MAX_INNER: usize = 1024;

/// Most shaders in the list of a root.
pub const MAX_SHADERS: usize = 64;

/// Most names of parameters a graph has not that are compared with those it has: beyond, it is no slip.
pub const MAX_ADVISED: usize = 64;

/// Most turns that the maps and folds of a file may have in all.
pub const MAX_TURNS: usize = 65_536;

/// Most phenomena within one another, whether they stand in files of their own or not.
pub const MAX_FILE_DEPTH: usize = 32;

/// Nodes named in a message, and places shown with it. A cycle may be as long as the file.
pub const MAX_CYCLE_SHOWN: usize = 32;
