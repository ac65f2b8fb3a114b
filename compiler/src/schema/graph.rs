//! The schema of graph files.

use serde_json::{Map, Value, json};

use super::parts::{described, object, reference};
use crate::check::{MAX_SHADERS, keys};
use crate::document::FORMAT;
use crate::graph::RootKind;
use crate::nodes::{DefaultValue, Input, NodeLibrary, Signature};
use crate::values::{Space, Type};

/// Adds the definition `graph` of graph files, and what it needs.
pub fn define_graph(library: &NodeLibrary, definitions: &mut Map<String, Value>) {
    definitions.insert("graph".into(), graph());
    definitions
        .insert("name".into(), json!({ "type": "string", "pattern": NAME, "maxLength": 256 }));
    definitions.insert("parameter".into(), declaration(true));
    definitions.insert("element".into(), declaration(false));
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
            "format": {
                "type": "integer", "minimum": 1, "maximum": FORMAT, "default": 1,
                "description": "Format of the file.",
            },
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
    let text = json!({ "type": "string" });
    let number = json!({ "type": "number", "minimum": -f64::from(f32::MAX), "maximum": f64::from(f32::MAX) });
    let list = |least: usize, most: usize| json!({ "type": "array", "items": { "$ref": "#/definitions/number" }, "minItems": least, "maxItems": most });
    let integer = json!({ "type": "integer", "minimum": i32::MIN, "maximum": i32::MAX });
    let number_here = reference("number");
    let light = object(&["light"], json!({ "light": text }));
    let spaces: Vec<&str> = Space::ALL.iter().map(|(name, _)| *name).collect();
    let texture = object(&["texture"], json!({ "texture": text, "space": { "enum": spaces } }));
    let null = json!({ "type": "null" });
    for (name, literal) in [
        ("boolean", vec![json!({ "type": "boolean" })]),
        ("integer", vec![integer]),
        ("scalar", vec![number_here.clone()]),
        ("color", vec![number_here.clone(), list(3, 4)]),
        ("vector", vec![list(3, 3)]),
        ("transform", vec![list(16, 16)]),
        ("string", vec![text]),
        ("texture", vec![texture, null.clone()]),
        ("light", vec![light.clone()]),
        ("lights", vec![json!({ "type": "array", "items": light })]),
        ("shader", vec![null]),
        ("generic", vec![number_here, list(3, 4)]),
    ] {
        definitions.insert(format!("{name}_literal"), json!({ "anyOf": literal }));
        let own = json!({ "$ref": format!("#/definitions/{name}_literal") });
        let source = json!({ "anyOf": [own, { "$ref": "#/definitions/connection" }] });
        definitions.insert(name.into(), source);
        let values = json!({ "type": "array", "items": reference(name), "minItems": 1 });
        let list = json!({ "anyOf": [values, reference("connection")] });
        definitions.insert(format!("{name}_list"), list);
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

/// A parameter, or a member of a struct; without a default what an array is of.
fn declaration(with_default: bool) -> Value {
    let text = json!({ "type": "string" });
    let mut choices = Vec::new();
    let mut choice = |name: &str, required: &[&str], mut properties: Value| {
        if !with_default && let Some(properties) = properties.as_object_mut() {
            properties.remove("default");
        }
        let required: Vec<&str> =
            required.iter().copied().filter(|key| with_default || *key != "default").collect();
        choices.push(json!({
            "if": { "properties": { "type": { "const": name } }, "required": ["type"] },
            "then": object(&required, properties),
        }));
    };
    for value_type in Type::ALL {
        let name = value_type.name();
        let (required, properties) = one(value_type);
        choice(name, required, properties);
    }
    choice(
        "array",
        &["type", "of", "default"],
        json!({
            "type": { "const": "array" },
            "of": described("element", "What each of its values is."),
            "default": { "type": "array", "minItems": 1, "description": "Its values; as many as there ever are." },
            "doc": text, "editor": {},
        }),
    );
    choice(
        "struct",
        &["type", "members"],
        json!({
            "type": { "const": "struct" },
            "members": {
                "type": "object", "minProperties": 1,
                "propertyNames": reference("name"),
                "additionalProperties": reference("parameter"),
            },
            "default": object(&["struct"], json!({ "struct": { "type": "object" } })),
            "doc": text, "editor": {},
        }),
    );
    let names = keys::declared_types();
    json!({ "type": "object", "required": ["type"], "properties": { "type": { "enum": names } }, "allOf": choices })
}

/// The keys of a parameter of one value, and which of them it must have.
fn one(value_type: Type) -> (&'static [&'static str], Value) {
    let number = json!({ "$ref": "#/definitions/number" });
    let text = json!({ "type": "string" });
    let name = value_type.name();
    let literal = json!({ "$ref": format!("#/definitions/{name}_literal") });
    let mut properties =
        json!({ "type": { "const": name }, "default": literal, "doc": text, "editor": {} });
    if value_type.is_numeric() {
        for key in ["min", "max", "soft_min", "soft_max"] {
            properties[key] = number.clone();
        }
        properties["unit"] = text.clone();
    }
    if value_type == Type::Integer {
        properties["default"] = json!({ "anyOf": [literal, { "type": "string" }] });
        properties["values"] = json!({ "type": "array", "items": text, "minItems": 1, "uniqueItems": true, "description": "Names of 0, 1, 2 …" });
    }
    let has_own = matches!(value_type, Type::Lights | Type::Texture | Type::Shader);
    (if has_own { &["type"] } else { &["type", "default"] }, properties)
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
        names.push(&*signature.name);
        docs.push(signature.doc.as_str());
        let inputs: Map<String, Value> = signature
            .inputs
            .iter()
            .map(|input| (input.name.to_string(), input_schema(input)))
            .collect();
        let required = required_inputs(signature);
        let mut of_type =
            json!({ "properties": { "inputs": object(&required, Value::Object(inputs)) } });
        if !required.is_empty() {
            of_type["required"] = json!(["inputs"]);
        }
        choices.push(json!({
            "if": { "properties": { "type": { "const": &*signature.name } }, "required": ["type"] },
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

fn required_inputs(signature: &Signature) -> Vec<&str> {
    let required =
        signature.inputs.iter().filter(|input| matches!(input.default, DefaultValue::Required));
    required.map(|input| &*input.name).collect()
}

fn input_schema(input: &Input) -> Value {
    let default = match &input.default {
        DefaultValue::Required => String::new(),
        DefaultValue::Literal(_) => " Has a default.".into(),
        DefaultValue::State(field) => format!(" By default the state's {}.", field.name()),
        DefaultValue::Node(name) => format!(" By default what `{name}` yields."),
    };
    let doc = format!("{}{default}", input.doc);
    if input.fixed {
        let (least, most) = (*input.range.start() as i64, *input.range.end() as i64);
        let number = json!({ "type": "integer", "minimum": least, "maximum": most });
        let parameter = object(&["interface"], json!({ "interface": { "type": "string" } }));
        let mut given = vec![number, parameter];
        if !input.choices.is_empty() {
            given.insert(0, json!({ "enum": input.choices }));
        }
        return json!({ "anyOf": given, "description": doc });
    }
    if input.list {
        return described(&format!("{}_list", source_name(input.value_type)), &doc);
    }
    described(source_name(input.value_type), &doc)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn properties(of: &Value) -> Vec<&str> {
        let mut keys: Vec<&str> =
            of["properties"].as_object().unwrap().keys().map(String::as_str).collect();
        keys.sort_unstable();
        keys
    }

    fn sorted<'k>(keys: &[&'k str]) -> Vec<&'k str> {
        let mut keys = keys.to_vec();
        keys.sort_unstable();
        keys
    }

    /// The schema's objects have the keys the reader knows, no more and no less.
    #[test]
    fn the_schema_knows_the_keys_of_the_reader() {
        assert_eq!(properties(&graph()), sorted(&keys::PHENOMENON));
        assert_eq!(properties(&node(&NodeLibrary::standard())), sorted(&keys::NODE));
        assert_eq!(properties(&requires()), sorted(&keys::REQUIRES));
        let declarations = declaration(true);
        let choices = declarations["allOf"].as_array().unwrap();
        assert_eq!(choices.len(), keys::declared_types().len());
        for choice in choices {
            let name = choice["if"]["properties"]["type"]["const"].as_str();
            let known = keys::of_declaration(name, false);
            assert_eq!(properties(&choice["then"]), sorted(known), "{name:?}");
        }
        let of_enumerations = keys::of_declaration(Some("integer"), true);
        assert!(
            of_enumerations
                .iter()
                .all(|key| { keys::of_declaration(Some("integer"), false).contains(key) })
        );
    }
}
