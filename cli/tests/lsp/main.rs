//! `phenomenon lsp`, spoken to as an editor would.

mod answers;
mod disk;
mod editor;
mod expressions;
mod files;
mod foreign;
mod names;
mod protocol;
mod scenes;
mod scopes;
mod typing;
mod values;

/// A graph without mistakes.
const GRAPH: &str = r#"{
  "phenomenon": "a",
  "interface": { "tint": { "type": "color", "default": [1, 0, 0], "doc": "the é😀 colour" } },
  "nodes": {
    "mirror": { "type": "trace_reflection" },
    "shade": { "type": "mix", "inputs": { "weight": 0.5, "a": { "interface": "tint" }, "b": { "node": "mirror", "output": "color" } } }
  },
  "roots": { "material": { "node": "shade" } }
}"#;

/// A phenomenon that others use.
const INNER: &str = r#"{ "phenomenon": "inner", "doc": "A tinted mirror.",
  "interface": { "tint": { "type": "color", "default": 1, "doc": "its tint" } },
  "nodes": { "m": { "type": "trace_reflection" }, "t": { "type": "multiply", "inputs": { "a": { "node": "m" }, "b": { "interface": "tint" } } } },
  "roots": { "material": { "node": "t" } } }"#;

/// One that uses it.
const OUTER: &str = r#"{ "phenomenon": "outer",
  "nodes": { "used": { "type": { "file": "inner.json" }, "inputs": { "tint": [1, 0, 0] } } },
  "roots": { "material": { "node": "used", "output": "color" } } }"#;
