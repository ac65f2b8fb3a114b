//! Checking a document against a node library: from text to a [`Graph`](crate::graph::Graph) the engines can trust.
//!
//! ```
//! use phenomenon_compiler::{check::check_graph, document, nodes::NodeLibrary};
//!
//! let text = br#"{ "phenomenon": "a", "nodes": { "n": { "type": "mxi" } },
//!                  "roots": { "material": { "node": "n" } } }"#;
//! let document = document::read("a.json", text).unwrap();
//! let checked = check_graph(&document, &NodeLibrary::standard());
//! assert!(checked.graph.is_none());
//! assert_eq!(checked.findings[0].help, "did you mean `mix`?");
//! ```

mod bind;
mod bind_inputs;
mod color_literals;
mod components;
mod compounds;
mod cycles;
mod dead_inputs;
mod declarations;
mod draft;
mod expand;
mod expressions;
mod files;
mod fixed_inputs;
mod graph;
mod hazards;
mod implied_scopes;
mod inner;
mod interface;
mod intervals;
pub mod keys;
mod limits;
mod lists;
mod literals;
mod loops;
mod mismatch;
mod names;
mod nested;
mod node_types;
mod nodes;
mod outputs;
mod phenomenon;
mod presets;
mod ramps;
mod ranges;
mod reach;
mod reachable;
mod references;
mod requirements;
mod roots;
mod settings;
mod shape;
mod sources;
mod splits;
mod stations;
mod textures;
pub mod turns;
mod type_names;
mod types;
mod unit_mistakes;
mod used_phenomena;
mod value_keys;

pub use color_literals::{read_color, space_of};
pub use expressions::{CONSTANTS, FUNCTIONS, Function, is_function};
pub use files::{Files, OnDisk};
pub use graph::{Checked, as_node, check_graph, check_graph_with, read_graph_file};
pub use limits::{
    MAX_ADVISED, MAX_CYCLE_SHOWN, MAX_FILE_DEPTH, MAX_INNER, MAX_NAME, MAX_NODES, MAX_OUTPUTS,
    MAX_PARTS, MAX_SHADERS, MAX_TURNS,
};
pub use names::name_mistake;
pub use settings::{Setting, SettingError, bind_setting, bind_settings, bind_text};
