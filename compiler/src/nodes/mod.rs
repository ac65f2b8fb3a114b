//! The nodes, one file each, and the list that makes them known.

#[macro_use]
mod macros;

mod code;
mod library;
mod signature;

pub use code::{Body, Code};
pub use library::{Definition, NodeLibrary, NodeType, Overload, paragraph};
pub use signature::{
    BLACK, Default, FINITE, Input, Kind, Literal, NOT_NEGATIVE, Output, POSITIVE, Signature, Type,
    WHITE, node, required, state,
};

/// Declares the folders and files of nodes, and the list [`NodeLibrary::standard`] is made from.
macro_rules! nodes {
    ($($(#[doc = $doc:literal])+ $group:ident { $($node:ident),+ $(,)? })+) => {
        $($(#[doc = $doc])+ pub mod $group { $(#[doc = concat!("The node `", stringify!($node), "`.")] pub mod $node;)+ })+

        /// Every node there is, by group.
        fn definitions() -> Vec<Definition> {
            vec![$($($group::$node::definition(),)+)+]
        }

        /// The groups with their descriptions, in order.
        pub const GROUPS: &[(&str, &str)] = &[$((stringify!($group), concat!($($doc),+)),)+];
    };
}

nodes! {
    /// Arithmetic on numbers, vectors and colours.
    arithmetic { add }
    /// Blending and converting colours.
    color { mix }
    /// Rays: directions, and requests to the renderer.
    rays { light_color, reflection_direction, trace_reflection }
    /// Nodes that evaluate an input under a changed state, or many times.
    scopes { light_loop, perturb_normal }
    /// What is known about the point that is shaded.
    state { light, state }
}
