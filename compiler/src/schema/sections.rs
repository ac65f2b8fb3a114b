//! The schema of objects whose keys a table names.

use serde_json::{Map, Value, json};

use super::parts::{object, reference};
use crate::document::{Given, Key, Kind, Section};

/// The tables of a format, and what the definitions of its sections are called.
#[derive(Clone, Copy, Debug)]
pub struct Sections {
    /// The name of the definition of a section.
    pub definition: fn(&Section) -> String,
}

impl Sections {
    /// The schema of an object of a section.
    pub fn schema(self, section: &Section) -> Value {
        let required = |key: &&Key| key.given == Given::Required;
        let required: Vec<&str> =
            section.keys.iter().filter(required).map(|key| key.name).collect();
        let mut schema = object(&required, self.properties(section.keys));
        if !section.one_of.is_empty() {
            schema["oneOf"] =
                section.one_of.iter().map(|key| json!({ "required": [key] })).collect();
        }
        schema
    }

    /// The schemas of the values of some keys, by name.
    pub(super) fn properties<'k>(self, keys: impl IntoIterator<Item = &'k Key>) -> Value {
        let properties = keys.into_iter().map(|key| (key.name.to_owned(), self.property(key)));
        Value::Object(properties.collect::<Map<String, Value>>())
    }

    fn property(self, key: &Key) -> Value {
        let of_kind = self.of_kind(&key.kind);
        // What stands beside a reference is not read.
        let mut property = match of_kind.get("$ref") {
            Some(_) => json!({ "allOf": [of_kind] }),
            None => of_kind,
        };
        property["description"] = description(key).into();
        if let Given::Default(default) = key.given
            && let Ok(default) = serde_json::from_str::<Value>(default)
        {
            property["default"] = default;
        }
        property
    }

    /// The schema of a value.
    pub fn of_kind(self, kind: &Kind) -> Value {
        let section = |section: &Section| reference(&(self.definition)(section));
        match kind {
            Kind::Text => json!({ "type": "string" }),
            Kind::File(_) => json!({ "type": "string", "minLength": 1 }),
            Kind::Name => reference("name"),
            Kind::Word(words) => json!({ "enum": words }),
            Kind::True => json!({ "const": true }),
            Kind::Boolean => json!({ "type": "boolean" }),
            Kind::Whole(range) => {
                json!({ "type": "integer", "minimum": whole(*range.start()), "maximum": whole(*range.end()) })
            }
            Kind::Number(range) => {
                json!({ "type": "number", "minimum": range.start(), "maximum": range.end() })
            }
            Kind::Several(of, count) => json!({
                "type": "array", "items": self.of_kind(of),
                "minItems": count.start(), "maxItems": count.end(),
            }),
            Kind::Set(of, count) => json!({
                "type": "array", "items": self.of_kind(of),
                "minItems": count.start(), "maxItems": count.end(), "uniqueItems": true,
            }),
            Kind::Either(one, other) => {
                json!({ "anyOf": [self.of_kind(one), self.of_kind(other)] })
            }
            Kind::Object(of) => section(of),
            Kind::Objects(of) => json!({ "type": "array", "items": section(of) }),
            Kind::Named(of) => json!({
                "type": "object",
                "propertyNames": reference("name"),
                "additionalProperties": section(of),
            }),
            Kind::Labels => json!({
                "type": "array", "items": { "type": "string" }, "minItems": 1, "uniqueItems": true,
            }),
            Kind::Value { definition, .. } => reference(definition),
            Kind::Settings => reference("scene_settings"),
            Kind::Presets => json!({
                "type": "object",
                "propertyNames": reference("name"),
                "additionalProperties": reference("scene_settings"),
            }),
            Kind::Anything => json!({}),
        }
    }
}

fn description(key: &Key) -> String {
    let doc = key.doc.replace('`', "");
    match key.unit {
        "" => format!("{doc}."),
        unit => format!("{doc} ({unit})."),
    }
}

/// A number of JSON; bounds of 64 bits keep all their digits.
fn whole(number: i128) -> Value {
    match (u64::try_from(number), i64::try_from(number)) {
        (Ok(number), _) => number.into(),
        (_, Ok(number)) => number.into(),
        _ => (number as f64).into(),
    }
}
