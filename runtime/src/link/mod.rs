//! Scenes with the graphs they use: checked together, compiled, and made ready to be rendered.

mod by_hand;
mod changes;
mod check;
mod error;
mod ledger;
mod linker;
mod materials;
mod node_path;
mod notes;
mod shown;
mod texture_sum;
mod uncompilable;
mod values;

pub use changes::{Change, Changes, NoSuchUse, objects_in_words};
pub use check::check_with_graphs;
pub use error::{LinkError, ShowNodeError};
pub use ledger::{Asked, Bytes, Ledger, Row};
pub use linker::{Linked, Linker};
pub use materials::{Remark, ShaderUse, Shading, Subject};
pub use node_path::{HalfNodePath, NoSuchNode, NodePath};
pub use notes::Note;
pub use shown::shown_node;
pub use uncompilable::uncompilable;
pub use values::{TextValue, ValueError, ValueFault, bind_texts};
