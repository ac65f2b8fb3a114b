//! The JSON Schema of graph and scene files: editors complete node types, inputs, keys and words from it, with
//! their docs.

use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::schema::{Given, Key, Kind, Section, define_graph, object, reference};
use serde_json::{Map, Value, json};

use super::keys::SCENE;

/// The schema as JSON text (draft 7, which editors know best). A file with the key `scene` is a
/// scene, any other a graph.
pub fn file_schema(library: &NodeLibrary) -> String {
    let mut definitions = Map::new();
    define_graph(library, &mut definitions);
    define_scene(&mut definitions);
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

/// Adds the definition `scene` and what it needs.
fn define_scene(definitions: &mut Map<String, Value>) {
    for section in SCENE.all() {
        definitions.insert(definition(section), schema(section));
    }
    definitions.insert(
        "scene_settings".into(),
        json!({
            "type": "object",
            "description": "Parameters of the graph and their values.",
            "additionalProperties": { "anyOf": [
                { "type": ["number", "string", "boolean", "array", "null"] },
                reference("light_literal"),
                reference("texture_literal"),
                object(&["struct"], json!({ "struct": { "type": "object" } })),
            ] },
        }),
    );
}

/// The name of the definition of a section.
fn definition(section: &Section) -> String {
    match section.name {
        "scene" => "scene".into(),
        name => format!("scene_{name}"),
    }
}

fn schema(section: &Section) -> Value {
    let required = |key: &&Key| key.given == Given::Required;
    let required: Vec<&str> = section.keys.iter().filter(required).map(|key| key.name).collect();
    let properties = section.keys.iter().map(|key| (key.name.to_owned(), property(key)));
    let mut schema = object(&required, Value::Object(properties.collect()));
    if !section.one_of.is_empty() {
        schema["oneOf"] = section.one_of.iter().map(|key| json!({ "required": [key] })).collect();
    }
    schema
}

fn property(key: &Key) -> Value {
    let of_kind = of_kind(&key.kind);
    // What stands beside a reference is not read.
    let mut property = match of_kind.get("$ref") {
        Some(_) => json!({ "allOf": [of_kind] }),
        None => of_kind,
    };
    let doc = key.doc.replace('`', "");
    property["description"] = match key.unit {
        "" => format!("{doc}."),
        unit => format!("{doc} ({unit})."),
    }
    .into();
    if let Given::Default(default) = key.given
        && let Ok(default) = serde_json::from_str::<Value>(default)
    {
        property["default"] = default;
    }
    property
}

/// A number of JSON; bounds of 64 bits keep all their digits.
fn whole(number: i128) -> Value {
    match (u64::try_from(number), i64::try_from(number)) {
        (Ok(number), _) => number.into(),
        (_, Ok(number)) => number.into(),
        _ => (number as f64).into(),
    }
}

fn of_kind(kind: &Kind) -> Value {
    match kind {
        Kind::Text => json!({ "type": "string" }),
        Kind::File => json!({ "type": "string", "minLength": 1 }),
        Kind::Word(words) => json!({ "enum": words }),
        Kind::True => json!({ "const": true }),
        Kind::Whole(range) => {
            json!({ "type": "integer", "minimum": whole(*range.start()), "maximum": whole(*range.end()) })
        }
        Kind::Number(range) => {
            json!({ "type": "number", "minimum": range.start(), "maximum": range.end() })
        }
        Kind::Several(of, count) => json!({
            "type": "array", "items": of_kind(of),
            "minItems": count.start(), "maxItems": count.end(),
        }),
        Kind::Either(one, other) => json!({ "anyOf": [of_kind(one), of_kind(other)] }),
        Kind::Object(section) => reference(&definition(section)),
        Kind::Objects(section) => {
            json!({ "type": "array", "items": reference(&definition(section)) })
        }
        Kind::Settings => reference("scene_settings"),
        Kind::Anything => json!({}),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_default_is_json_and_every_choice_a_key() {
        let mut names = Vec::new();
        for section in SCENE.all() {
            assert!(!names.contains(&section.name), "two sections are called {}", section.name);
            names.push(section.name);
            for key in section.keys {
                let at = format!("{}.{}", section.name, key.name);
                if let Given::Default(default) = key.given {
                    let default = serde_json::from_str::<Value>(default);
                    let schema = json!({ "allOf": [of_kind(&key.kind)], "definitions": {
                        "scene_settings": {} } });
                    let refers = key.kind.section().is_some();
                    let suits = |default: &Value| {
                        refers || jsonschema::draft7::new(&schema).unwrap().is_valid(default)
                    };
                    assert!(default.is_ok_and(|default| suits(&default)), "{at}");
                }
                let is_choice = section.one_of.contains(&key.name);
                assert_eq!(key.given == Given::Choice, is_choice, "{at}");
                assert!(!key.doc.is_empty() && !key.doc.ends_with('.'), "{at}");
            }
            let choices = section.keys.iter().filter(|key| key.given == Given::Choice);
            assert_eq!(choices.count(), section.one_of.len(), "{}", section.name);
        }
        assert!(names.len() >= 12, "{names:?}");
    }
}
