//! The JSON Schema of graph and scene files, made from the list of nodes: editors complete node
//! types, inputs and enumerations from it, with their docs. What is known of the keys of scenes stands in one table.

mod graph;
mod key;
mod page;
mod scene;
mod scene_keys;

use serde_json::{Map, Value, json};

use crate::nodes::NodeLibrary;

pub use key::{Given, Key, Kind, Section};
pub use page::scene_page;
pub use scene_keys::{
    CAMERA, COORDINATES, DIRECTIONAL, ENVIRONMENT, GRADIENT, LENGTHS, LIGHT, LIGHT_SOURCE,
    MATERIAL, OBJECT, OPTIONS, POINT, RECTANGLE, SCENE, SPHERE, TRANSFORM,
};

/// The schema as JSON text (draft 7, which editors know best). A file with the key `scene` is a
/// scene, any other a graph.
pub fn file_schema(library: &NodeLibrary) -> String {
    let mut definitions = Map::new();
    graph::define(library, &mut definitions);
    scene::define(&mut definitions);
    let schema = json!({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "phenomenon graph or scene, format 1",
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
