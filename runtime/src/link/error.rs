//! Why a scene cannot be linked with its graphs.

use std::path::PathBuf;

use phenomenon_compiler::diagnostics::Place;
use phenomenon_compiler::engine::ShaderError;
use phenomenon_compiler::graph::{NoSuchPreset, WithRootError};

use super::node_path::{NoSuchNode, NodePath};
use super::notes::line_of;
use super::values::ValueError;
use crate::monoliths::NoMonolith;
use crate::scene::SceneError;

/// Why a scene cannot be linked with its graphs.
#[derive(Debug, thiserror::Error)]
pub enum LinkError {
    /// What was found in a file, and told before, makes it unusable.
    #[error("{} cannot be used", file.display())]
    Unusable {
        /// The file, as findings call it.
        file: PathBuf,
    },
    /// The scene shows the graph that is looked at, and there is none.
    #[error("{}: no graph is looked at", line_of(place))]
    NoSubject {
        /// Where the scene shows it.
        place: Place,
    },
    /// A value that a use of a graph is changed to does not suit it.
    #[error("{object}:{error}")]
    Value {
        /// The object.
        object: String,
        /// The value, and what is wrong with it.
        error: ValueError,
    },
    /// A preset that a use of a graph is changed to is none of that graph.
    #[error("{object}:{}: {error}", error.name)]
    Preset {
        /// The object.
        object: String,
        /// The name, and what there is.
        error: NoSuchPreset,
    },
    /// The node that is to be shown cannot be.
    #[error(transparent)]
    Node(#[from] ShowNodeError),
    /// A graph is too large for the engine, or the engine does not run here.
    #[error("`{graph}`: {error}")]
    Compile {
        /// The graph.
        graph: String,
        /// What is wrong.
        error: ShaderError,
    },
    /// A graph is not written by hand, or not with these values.
    #[error(transparent)]
    ByHand(#[from] NoMonolith),
    /// Pictures that graphs read cannot be used, which was told where they are named.
    #[error("pictures of the scene cannot be used")]
    Pictures,
    /// An object is not usable.
    #[error("object `{object}`: {error}")]
    Object {
        /// Its name.
        object: String,
        /// What is wrong.
        error: SceneError,
    },
    /// All of the scene together is not usable.
    #[error(transparent)]
    Scene(SceneError),
}

/// Why a node of a graph cannot be shown.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ShowNodeError {
    /// What is written by hand has no nodes.
    #[error("a monolith has no nodes to show")]
    ByHand,
    /// There is no such node.
    #[error("{path}: {error}")]
    Missing {
        /// The path that was given.
        path: NodePath,
        /// What there is not.
        error: NoSuchNode,
    },
    /// It has no value to look at.
    #[error(transparent)]
    NoValue(#[from] WithRootError),
}
