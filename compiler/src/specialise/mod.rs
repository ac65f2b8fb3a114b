//! A checked graph, made concrete for one root and one ray type: every node evaluation that can be
//! demanded becomes an [`Instance`], in the epoch it belongs to, with all names resolved to words.

mod account;
mod decisions;
mod epochs;
mod error;
mod expand;
mod ids;
mod instances;
pub mod internal;
mod keys;
mod reads;
mod uniforms;
mod verify;
mod views;

pub use account::{Account, Cause, Fate, Named, Needed, Origin, Part, Reason, TOLD_REASONS};
pub use decisions::Decisions;
pub use epochs::{Epoch, EpochKind, Epochs};
pub use error::SpecialiseError;
pub use expand::{Asking, MAX_INSTANCES, MAX_NESTED_LOOPS, expand, expand_asking};
pub use ids::{EpochId, InstanceId, LightListId, LightTableId, TexturePosition};
pub use instances::{
    Context, Demand, Guard, Instance, InstanceKind, LightTable, Specialised, Subject, Turns,
};
pub use keys::{drawn, iteration_key, mix_key, site};
pub use uniforms::Uniforms;
pub use verify::verify;
