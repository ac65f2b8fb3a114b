//! The data of a row.

use phenomenon_compiler::diagnostics::Place;

use crate::render::Entry;

/// One effect: on or off, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The effect.
    pub entry: Entry,
    /// The file, where it is a texture.
    pub file: Option<String>,
    /// Who asks for it, where a node does; in a row that is off the node that would.
    pub asked: Option<Asked>,
    /// Whether the scene calls for it.
    pub on: bool,
    /// Why, in words.
    pub reason: String,
}

/// A node that asks.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// Its graph.
    pub graph: String,
    /// Its name.
    pub node: String,
    /// Its type.
    pub node_type: String,
    /// Where it stands; for one of a phenomenon in the graph, where that is used. None for one that a default implies.
    pub place: Option<Place>,
}

/// What an effect holds in memory, in bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bytes(pub u64);
