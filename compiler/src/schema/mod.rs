//! The JSON Schema of graph and scene files, made from the list of nodes: editors complete node
//! types, inputs and enumerations from it, with their docs.

mod graph;
mod scene;

use serde_json::{Map, Value, json};

use crate::nodes::NodeLibrary;

/// The schema as JSON text (draft 7, which editors know best). A file with the key `scene` is a
/// scene, any other a graph.
pub fn file_schema(library: &NodeLibrary) -> String {
    let mut definitions = Map::new();
    graph::define(library, &mut definitions);
    scene::define(&mut definitions);
    let schema = json!({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "phenomenon graph or scene, version 1",
        "type": "object",
        "if": { "required": ["scene"] },
        "then": reference("scene"),
        "else": reference("graph"),
        "definitions": definitions,
    });
    format!("{schema:#}\n")
}

/// A reference to a definition.
fn reference(name: &str) -> Value {
    json!({ "$ref": format!("#/definitions/{name}") })
}

/// A reference to a definition, with a description of its own.
fn described(name: &str, description: &str) -> Value {
    json!({ "allOf": [reference(name)], "description": description })
}

/// An object with known keys.
fn object(required: &[&str], properties: Value) -> Value {
    json!({
        "type": "object",
        "required": required,
        "additionalProperties": false,
        "properties": properties,
    })
}
