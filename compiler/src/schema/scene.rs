//! The schema of scene files.

use serde_json::{Map, Value, json};

use super::{described, object, reference};

/// Adds the definition `scene` and what it needs.
pub(super) fn define(definitions: &mut Map<String, Value>) {
    definitions.insert("scene".into(), scene());
    definitions.insert("scene_camera".into(), camera());
    definitions.insert("scene_object".into(), scene_object());
    definitions.insert("scene_material".into(), material());
    definitions.insert("scene_light".into(), light());
    definitions.insert("scene_environment".into(), environment());
    definitions.insert("scene_options".into(), options());
    definitions.insert(
        "scene_settings".into(),
        json!({
            "type": "object",
            "description": "Parameters of the graph and their values.",
            "additionalProperties": { "anyOf": [
                { "type": ["number", "string", "boolean", "array", "null"] },
                reference("light_literal"),
                reference("texture_literal"),
            ] },
        }),
    );
}

fn scene() -> Value {
    let text = json!({ "type": "string" });
    object(
        &["scene", "camera", "objects"],
        json!({
            "$schema": text,
            "scene": { "type": "string", "description": "Name of the scene." },
            "version": { "const": 1 },
            "doc": text,
            "camera": reference("scene_camera"),
            "objects": { "type": "array", "items": reference("scene_object") },
            "lights": { "type": "array", "items": reference("scene_light") },
            "environment": described("scene_environment", "What rays see that leave the scene."),
            "options": reference("scene_options"),
            "editor": { "description": "Whatever editors keep here; it changes nothing." },
        }),
    )
}

fn vector(description: &str) -> Value {
    described("vector_literal", description)
}

fn camera() -> Value {
    object(
        &["position", "look_at"],
        json!({
            "position": vector("Where it stands."),
            "look_at": vector("The point in the middle of the picture."),
            "up": vector("A direction that points up in the picture."),
            "field_of_view": { "type": "number", "description": "Angle over the picture's height, in degrees." },
        }),
    )
}

fn scene_object() -> Value {
    let text = json!({ "type": "string" });
    let length = json!({ "type": "number", "exclusiveMinimum": 0 });
    let mut schema = object(
        &["material"],
        json!({
            "name": text,
            "doc": text,
            "sphere": object(&["radius"], json!({ "center": vector("Its centre."), "radius": length })),
            "mesh": { "type": "string", "description": "An OBJ file; its path starts at the scene's folder." },
            "rectangle": object(&["width", "depth"], json!({ "width": length, "depth": length })),
            "normals": { "enum": ["smooth", "flat"] },
            "transform": object(&[], json!({
                "scale": { "type": ["number", "array"] },
                "rotate": vector("Angles in degrees."),
                "translate": vector("In scene units."),
                "matrix": { "type": "array", "items": { "type": "number" }, "minItems": 12, "maxItems": 12 },
            })),
            "material": reference("scene_material"),
        }),
    );
    schema["oneOf"] = json!([
        { "required": ["sphere"] }, { "required": ["mesh"] }, { "required": ["rectangle"] },
    ]);
    schema
}

fn material() -> Value {
    json!({ "anyOf": [
        object(&["subject"], json!({ "subject": { "const": true }, "set": reference("scene_settings") })),
        object(&["file"], json!({
            "file": { "type": "string", "description": "A graph file; its path starts at the scene's folder." },
            "set": reference("scene_settings"),
        })),
    ] })
}

fn light() -> Value {
    let mut schema = object(
        &["name"],
        json!({
            "name": { "type": "string", "description": "What graphs call it." },
            "point": object(&["position"], json!({ "position": vector("Where it stands.") })),
            "directional": object(&["direction"], json!({ "direction": vector("Where its light goes.") })),
            "color": reference("vector_literal"),
            "intensity": { "type": "number", "minimum": 0 },
        }),
    );
    schema["oneOf"] = json!([{ "required": ["point"] }, { "required": ["directional"] }]);
    schema
}

fn environment() -> Value {
    let color = reference("vector_literal");
    let mut schema = object(
        &[],
        json!({
            "color": color,
            "gradient": object(
                &["zenith", "horizon", "ground"],
                json!({ "zenith": color, "horizon": color, "ground": color }),
            ),
            "image": { "type": "string", "description": "A picture of the whole sky; its path starts at the scene's folder." },
            "intensity": { "type": "number", "minimum": 0 },
            "rotation": { "type": "number", "description": "Degrees about the vertical." },
            "file": { "type": "string", "description": "A graph with an environment root." },
            "set": reference("scene_settings"),
        }),
    );
    schema["minProperties"] = json!(1);
    schema
}

fn options() -> Value {
    let count = json!({ "type": "integer", "minimum": 0 });
    object(
        &[],
        json!({
            "size": { "type": "array", "items": { "type": "integer", "minimum": 1 }, "minItems": 2, "maxItems": 2 },
            "samples": { "type": "integer", "minimum": 1, "description": "Samples per pixel." },
            "trace_depth": {
                "anyOf": [count, { "type": "array", "items": count, "minItems": 1, "maxItems": 3 }],
                "description": "Reflections; or reflections and refractions; or both and their sum.",
            },
            "seed": count,
        }),
    )
}
