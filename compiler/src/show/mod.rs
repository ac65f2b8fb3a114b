//! Drawings of a graph: SVG for people, DOT for Graphviz.
//!
//! ```
//! use phenomenon_compiler::graph::{Binding, Graph, Node, Root, RootKind};
//! use phenomenon_compiler::nodes::NodeLibrary;
//! use phenomenon_compiler::show::{draw_dot, draw_svg};
//! # fn graph() -> Graph {
//! #     let text = br#"{ "phenomenon": "mirror", "version": 1,
//! #         "nodes": { "mirror": { "type": "trace_reflection" } },
//! #         "roots": { "material": { "node": "mirror", "output": "color" } } }"#;
//! #     let document = phenomenon_compiler::document::read("mirror.json", text).unwrap();
//! #     phenomenon_compiler::check::check_graph(&document, &NodeLibrary::standard()).graph.unwrap()
//! # }
//!
//! let graph = graph();
//! assert!(draw_svg(&graph)?.starts_with("<svg "));
//! assert!(draw_dot(&graph)?.starts_with("digraph "));
//! # Ok::<(), phenomenon_compiler::show::ShowError>(())
//! ```
//!
//! The way of an SVG: a `diagram` says what is drawn, `frames` how large each box is,
//! `layers` in which column it stands, `routes` where long wires pass through columns, `order`
//! who stands above whom, `coordinates` where exactly (`compact` closes empty bands, `straighten`
//! makes wires level), and `svg` writes it down, with a panel for each box that opens (`opened`). Nothing depends
//! on hashes, time or addresses: the same graph gives the same bytes.

mod build;
mod cards;
mod compact;
mod coordinates;
mod dead;
mod diagram;
mod dot;
mod error;
mod escape;
mod expressions;
mod frames;
mod implied;
mod layers;
mod layout;
mod legend;
mod look;
mod marks;
mod opened;
mod order;
mod pen;
mod routes;
mod spacing;
mod straighten;
mod svg;
mod text;
mod theme;
mod values;
mod wires;

#[cfg(test)]
mod tests;

pub use dot::draw_dot;
pub use error::{MAX_BOXES, ShowError};
pub use svg::draw_svg;
