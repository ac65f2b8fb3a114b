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

mod bind_inputs;
mod cycles;
mod dead_inputs;
mod draft;
mod expand;
mod graph;
mod hazards;
mod interface;
mod intervals;
mod light_loops;
mod lists;
mod literals;
mod mismatch;
mod nested;
mod nodes;
mod ranges;
mod reach;
mod references;
mod requirements;
mod roots;
mod settings;
mod shapes;
mod sources;
mod stations;
mod textures;
mod types;

pub use cycles::MAX_CYCLE_SHOWN;
pub use graph::{Checked, MAX_NODES, check_graph, check_graph_with, read_graph_file};
pub use nested::{Files, MAX_FILE_DEPTH, OnDisk};
pub use nodes::MAX_NAME;
pub use roots::MAX_SHADERS;
pub use settings::{Setting, SettingError, bind_setting, bind_settings, bind_text};
pub use shapes::MAX_PARTS;
