//! What others call the things a file can name: nodes, types, inputs, outputs, keys, roots. A name from
//! MaterialX, OSL, mental ray, Blender or GLSL is no misspelling, and the nearest of our names is
//! mostly not what it means (`max` is not `mix`), so these tables are looked at before spelling is.
//!
//! Plain data, keyed by our name, in the text files beside this. Case, `_`, `-` and spaces make no
//! difference to a foreign name, nor does a type at its end as MaterialX writes it (`ND_mix_color3`).

mod table;
mod tables;

pub(super) use table::folded;
pub use table::{Absent, Called, Synonym, Table};
pub use tables::{
    INPUTS, KEYS, NODES, OUTPUTS, ROOTS, SEVERAL, TYPES, also, input, is_word, key, node, of_node,
    output, root, value_type,
};
