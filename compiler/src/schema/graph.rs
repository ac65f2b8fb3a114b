//! The schema of graph files.

use serde_json::{Map, Value, json};

use super::{described, object, reference};
use crate::check::MAX_SHADERS;
use crate::graph::RootKind;
use crate::nodes::{Default, Input, NodeLibrary, Signature, Type};

/// Adds the definition `graph` and what it needs.
pub(super) fn define(library: &NodeLibrary, definitions: &mut Map<String, Value>) {
    definitions.insert("graph".into(), graph());
    definitions
        .insert("name".into(), json!({ "type": "string", "pattern": NAME, "maxLength": 256 }));
    definitions.insert("parameter".into(), parameter());
    definitions.insert("requires".into(), requires());
    definitions.insert("root".into(), root());
    definitions.insert("shaders".into(), shaders());
    definitions.insert("node".into(), node(library));
    sources(definitions);
}

/// Names of phenomena, parameters and nodes: letters and digits of any script, `_` and `-`.
const NAME: &str =
    "^[^\\s\\u0000-\\u002c\\u002e-\\u002f\\u003a-\\u0040\\u005b-\\u005e\\u0060\\u007b-\\u007f]+$";

fn graph() -> Value {
    let by_name = |definition: &str, description: &str| {
        json!({
            "type": "object",
            "description": description,
            "propertyNames": reference("name"),
            "additionalProperties": reference(definition),
        })
    };
    let roots: Map<String, Value> =
        RootKind::ALL.iter().map(|kind| (kind.name().to_owned(), reference("root"))).collect();
    let mut roots = object(&[], Value::Object(roots));
    roots["description"] = json!("What it is called for.");
    roots["minProperties"] = json!(1);
    object(
        &["phenomenon", "roots"],
        json!({
            "$schema": { "type": "string" },
            "phenomenon": described("name", "Name of the phenomenon."),
            "version": {
                "type": "integer", "minimum": 0, "maximum": i32::MAX,
                "description": "Version of the phenomenon; 0 where none is given.",
            },
            "doc": { "type": "string", "description": "What it is." },
            "requires": described("requires", "What the renderer must do for it."),
            "interface": by_name("parameter", "Its parameters, by name."),
            "nodes": by_name("node", "Its nodes, by name."),
            "roots": roots,
            "editor": { "description": "Whatever editors keep here; it changes nothing." },
        }),
    )
}

/// What an input of each type may be given.
fn sources(definitions: &mut Map<String, Value>) {
    let connection = json!({ "anyOf": [
        object(&["node"], json!({ "node": { "type": "string" }, "output": { "type": "string" } })),
        object(&["interface"], json!({ "interface": { "type": "string" } })),
    ] });
    let number = json!({ "type": "number", "minimum": -f64::from(f32::MAX), "maximum": f64::from(f32::MAX) });
    let list = |least: usize, most: usize| json!({ "type": "array", "items": { "$ref": "#/definitions/number" }, "minItems": least, "maxItems": most });
    let integer = json!({ "type": "integer", "minimum": i32::MIN, "maximum": i32::MAX });
    let number_here = reference("number");
    let lights = json!({ "type": "array", "items": object(&["light"], json!({ "light": { "type": "string" } })) });
    for (name, literal) in [
        ("boolean", vec![json!({ "type": "boolean" })]),
        ("integer", vec![integer]),
        ("scalar", vec![number_here.clone()]),
        ("color", vec![number_here.clone(), list(3, 4)]),
        ("vector", vec![list(3, 3)]),
        ("generic", vec![number_here, list(3, 4)]),
        ("lights", vec![lights]),
    ] {
        definitions.insert(format!("{name}_literal"), json!({ "anyOf": literal }));
        let own = json!({ "$ref": format!("#/definitions/{name}_literal") });
        let source = json!({ "anyOf": [own, { "$ref": "#/definitions/connection" }] });
        definitions.insert(name.into(), source);
    }
    definitions.insert("number".into(), number);
    definitions.insert("connection".into(), connection);
}

fn source_name(value_type: Type) -> &'static str {
    match value_type {
        Type::Generic => "generic",
        other => other.name(),
    }
}

fn parameter() -> Value {
    let number = json!({ "$ref": "#/definitions/number" });
    let text = json!({ "type": "string" });
    let mut ordered = json!({
        "type": {}, "default": {}, "min": number, "max": number, "soft_min": number,
        "soft_max": number, "unit": text, "doc": text, "editor": {},
    });
    let mut choices = Vec::new();
    for value_type in
        [Type::Scalar, Type::Integer, Type::Color, Type::Vector, Type::Boolean, Type::Lights]
    {
        let name = value_type.name();
        let literal = json!({ "$ref": format!("#/definitions/{name}_literal") });
        let plain = matches!(value_type, Type::Boolean | Type::Lights);
        let mut properties = if plain {
            json!({ "type": {}, "default": {}, "doc": text, "editor": {} })
        } else {
            ordered.clone()
        };
        properties["type"] = json!({ "const": name });
        properties["default"] = literal.clone();
        if value_type == Type::Integer {
            properties["default"] = json!({ "anyOf": [literal, { "type": "string" }] });
            properties["values"] = json!({ "type": "array", "items": text, "minItems": 1, "uniqueItems": true, "description": "Names of 0, 1, 2 …" });
        }
        let required: &[&str] =
            if value_type == Type::Lights { &["type"] } else { &["type", "default"] };
        choices.push(json!({
            "if": { "properties": { "type": { "const": name } }, "required": ["type"] },
            "then": object(required, properties),
        }));
    }
    ordered["type"] =
        json!({ "enum": ["scalar", "integer", "boolean", "color", "vector", "lights"] });
    json!({ "type": "object", "required": ["type"], "properties": { "type": ordered["type"] }, "allOf": choices })
}

/// The requirements of mental ray's grammar.
fn requires() -> Value {
    let switch = json!({ "enum": ["on", "off"] });
    let count = json!({ "type": "integer", "minimum": 0, "maximum": 1000 });
    let properties = json!({
        "scanline": switch,
        "trace": switch,
        "shadow": { "enum": ["on", "off", "sort", "segments"] },
        "face": { "enum": ["front", "back", "both"] },
        "space": { "enum": ["object", "camera", "mixed"] },
        "texture": count,
        "bump": count,
        "volume_level": count,
        "derivative": { "type": "array", "items": { "enum": [1, 2] }, "minItems": 1, "uniqueItems": true },
        "parallel": { "type": "boolean" },
        "apply": { "type": "array", "items": { "type": "string" }, "minItems": 1, "uniqueItems": true },
    });
    object(&[], properties)
}

fn root() -> Value {
    json!({ "anyOf": [
        { "$ref": "#/definitions/shaders" },
        object(&["color"], json!({
            "color": { "$ref": "#/definitions/shaders" },
            "ok": { "$ref": "#/definitions/boolean" },
        })),
    ] })
}

/// A color, or a list of shaders that hand one another their color.
fn shaders() -> Value {
    json!({ "anyOf": [
        { "$ref": "#/definitions/color" },
        {
            "type": "array", "items": { "$ref": "#/definitions/color" },
            "minItems": 1, "maxItems": MAX_SHADERS,
        },
    ] })
}

fn node(library: &NodeLibrary) -> Value {
    let mut names = Vec::new();
    let mut docs = Vec::new();
    let mut choices = Vec::new();
    for (_, definition) in library.iter() {
        let signature = &definition.signature;
        names.push(signature.name);
        docs.push(signature.doc.as_str());
        let inputs: Map<String, Value> = signature
            .inputs
            .iter()
            .map(|input| (input.name.to_owned(), input_schema(input)))
            .collect();
        let required = required_inputs(signature);
        let mut of_type =
            json!({ "properties": { "inputs": object(&required, Value::Object(inputs)) } });
        if !required.is_empty() {
            of_type["required"] = json!(["inputs"]);
        }
        choices.push(json!({
            "if": { "properties": { "type": { "const": signature.name } }, "required": ["type"] },
            "then": of_type,
        }));
    }
    let mut node = object(
        &["type"],
        json!({
            "type": {
                "anyOf": [
                    { "enum": names, "enumDescriptions": docs },
                    object(&["file"], json!({ "file": { "type": "string", "minLength": 1 } })),
                ],
            },
            "version": { "type": "integer", "minimum": 0, "maximum": i32::MAX },
            "doc": { "type": "string" },
            "inputs": { "type": "object" },
            "editor": {},
        }),
    );
    node["allOf"] = Value::Array(choices);
    node
}

fn required_inputs(signature: &Signature) -> Vec<&'static str> {
    let required =
        signature.inputs.iter().filter(|input| matches!(input.default, Default::Required));
    required.map(|input| input.name).collect()
}

fn input_schema(input: &Input) -> Value {
    let default = match &input.default {
        Default::Required => String::new(),
        Default::Literal(_) => " Has a default.".into(),
        Default::State(field) => format!(" By default the state's {}.", field.name()),
        Default::Node(name) => format!(" By default what `{name}` yields."),
    };
    described(source_name(input.value_type), &format!("{}{default}", input.doc))
}
