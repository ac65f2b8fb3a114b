//! Reads, checks, compiles and evaluates shader graphs.
//!
//! A *phenomenon* is a graph of elementary shaders with typed parameters and roots. This crate turns
//! its file into something that shades points; whatever a shader asks of the outside (rays, light)
//! it asks through the [`effects::Renderer`] trait, which any renderer can implement.
//!
//! ```
//! use std::sync::Arc;
//!
//! use phenomenon_compiler::check::check_graph;
//! use phenomenon_compiler::document;
//! use phenomenon_compiler::effects::{Answer, Ray, Renderer, Trace};
//! use phenomenon_compiler::engine::{Options, Shade, Shaded, Shader};
//! use phenomenon_compiler::graph::RootKind;
//! use phenomenon_compiler::nodes::NodeLibrary;
//! use phenomenon_compiler::state::State;
//!
//! /// A renderer with nothing in it but a sky that is brighter towards +z.
//! struct Sky {
//!     rays: usize,
//! }
//!
//! impl Renderer for Sky {
//!     fn trace(&mut self, _: Trace, _: &[State], rays: &[Ray], answers: &mut [Answer]) {
//!         self.rays += rays.len();
//!         for (ray, answer) in rays.iter().zip(answers) {
//!             let up = ray.direction[2].max(0.0);
//!             *answer = Answer { color: [up, up, 1.0, 1.0], ok: true, ..Answer::default() };
//!         }
//!     }
//! }
//!
//! let text = br#"{
//!     "phenomenon": "tinted_mirror", "version": 1,
//!     "interface": { "tint": { "type": "color", "default": [1.0, 0.5, 0.25] } },
//!     "nodes": {
//!         "mirror": { "type": "trace_reflection" },
//!         "shade": { "type": "multiply",
//!             "inputs": { "a": { "node": "mirror" }, "b": { "interface": "tint" } } }
//!     },
//!     "roots": { "material": { "node": "shade" } }
//! }"#;
//!
//! let library = NodeLibrary::standard();
//! let document = document::read("tinted_mirror.json", text).expect("it is JSON");
//! let checked = check_graph(&document, &library);
//! for finding in &checked.findings {
//!     println!("{}: {}", finding.severity, finding.message);
//! }
//! let graph = Arc::new(checked.graph.expect("it has no errors"));
//! let shader = Shader::new(graph, &[], Options::default())?;
//!
//! // Two points, seen from above: the mirror looks straight up.
//! let points = [State::default(); 2];
//! let mut results = [Shaded::default(); 2];
//! let mut sky = Sky { rays: 0 };
//! shader.shade(RootKind::Material, &points, &mut sky, &mut results);
//! assert_eq!(results[0].color, [1.0, 0.5, 0.25, 1.0]);
//! assert_eq!(sky.rays, 2);
//! # Ok::<(), phenomenon_compiler::engine::ShaderError>(())
//! ```
//!
//! The way through the crate is the pipeline: [`document`] reads JSON with places, [`check`] makes a
//! [`graph`] of it or findings ([`diagnostics`]), [`specialise`] makes every evaluation concrete,
//! [`schedule`] orders them for batches, [`ops`] is what the jit compiles, and [`engine`] runs it.
//! [`nodes`] holds the elementary shaders, whose bodies are written once over [`emit`].

pub mod check;
pub mod diagnostics;
pub mod document;
pub mod effects;
pub mod emit;
pub mod engine;
pub mod graph;
pub mod kernels;
pub mod nodes;
pub mod ops;
pub mod schedule;
pub mod schema;
pub mod show;
pub mod specialise;
pub mod state;
pub mod storage;
#[cfg(any(test, feature = "testing"))]
pub mod testing;
pub mod values;
