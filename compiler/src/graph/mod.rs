//! A checked graph: names resolved, types settled, every input bound. What [`crate::check`] makes
//! and the engines start from.

pub(crate) mod bind;
mod checked;
pub(crate) mod parts;
mod presets;
mod requirements;
mod root_kind;
mod with_root;

pub use bind::BindError;
pub use checked::{Binding, Expression, Graph, Node, Output, Parameter, Preset, Root};
pub use presets::NoSuchPreset;
pub use requirements::Requirements;
pub use root_kind::RootKind;
pub use with_root::WithRootError;
