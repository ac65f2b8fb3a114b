//! What a specialised graph asks of the renderer, node by node, and why it does not ask for the rest.

mod cause;
mod looked_at;
mod part;
mod pruned;

pub use part::{Account, Cause, Fate, Named, Needed, Origin, Part, Reason, TOLD_REASONS};
