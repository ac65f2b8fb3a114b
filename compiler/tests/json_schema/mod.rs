//! As much of JSON Schema, draft 7, as the schema of graphs uses. Patterns are not looked at.

use serde_json::{Map, Value};

/// Whether a value suits a schema; `whole` is what references start from. A keyword that is not
/// known is a panic: the schema must not say what is not tested.
pub fn suits(whole: &Value, schema: &Value, value: &Value) -> bool {
    match schema {
        Value::Bool(allowed) => *allowed,
        Value::Object(keywords) => keywords
            .iter()
            .all(|(keyword, argument)| holds(whole, keywords, keyword, argument, value)),
        _ => panic!("no schema: {schema}"),
    }
}

fn holds(
    whole: &Value,
    keywords: &Map<String, Value>,
    keyword: &str,
    argument: &Value,
    value: &Value,
) -> bool {
    let list = || argument.as_array().expect("a list of schemas");
    let matching = || list().iter().filter(|schema| suits(whole, schema, value)).count();
    match keyword {
        "$ref" => {
            let pointer =
                argument.as_str().and_then(|it| it.strip_prefix('#')).expect("a local reference");
            suits(whole, whole.pointer(pointer).expect("a definition"), value)
        }
        "anyOf" => matching() > 0,
        "oneOf" => matching() == 1,
        "allOf" => matching() == list().len(),
        "if" => {
            let branch = if suits(whole, argument, value) { "then" } else { "else" };
            keywords.get(branch).is_none_or(|schema| suits(whole, schema, value))
        }
        "enum" => list().contains(value),
        "const" => argument == value,
        "type" => match argument {
            Value::Array(names) => names.iter().any(|name| is_of(value, name)),
            name => is_of(value, name),
        },
        "minimum" | "maximum" | "exclusiveMinimum" => value.as_f64().is_none_or(|number| {
            let bound = argument.as_f64().expect("a bound");
            match keyword {
                "minimum" => number >= bound,
                "maximum" => number <= bound,
                _ => number > bound,
            }
        }),
        "minItems" => value.as_array().is_none_or(|items| items.len() as u64 >= count(argument)),
        "maxItems" => value.as_array().is_none_or(|items| items.len() as u64 <= count(argument)),
        "uniqueItems" => value.as_array().is_none_or(|items| {
            items.iter().enumerate().all(|(at, item)| !items[..at].contains(item))
        }),
        "items" => {
            value.as_array().is_none_or(|items| items.iter().all(|it| suits(whole, argument, it)))
        }
        "minLength" => value.as_str().is_none_or(|it| it.chars().count() as u64 >= count(argument)),
        "maxLength" => value.as_str().is_none_or(|it| it.chars().count() as u64 <= count(argument)),
        "minProperties" => value.as_object().is_none_or(|it| it.len() as u64 >= count(argument)),
        "required" => value.as_object().is_none_or(|object| {
            list().iter().all(|key| object.contains_key(key.as_str().expect("a key")))
        }),
        "properties" => value.as_object().is_none_or(|object| {
            let schemas = argument.as_object().expect("schemas by key");
            object.iter().all(|(key, value)| {
                schemas.get(key).is_none_or(|schema| suits(whole, schema, value))
            })
        }),
        "additionalProperties" => value.as_object().is_none_or(|object| {
            let known = keywords.get("properties").and_then(Value::as_object);
            object
                .iter()
                .filter(|(key, _)| known.is_none_or(|known| !known.contains_key(*key)))
                .all(|(_, value)| suits(whole, argument, value))
        }),
        "propertyNames" => value.as_object().is_none_or(|object| {
            object.keys().all(|key| suits(whole, argument, &Value::from(key.as_str())))
        }),
        "$schema" | "title" | "description" | "definitions" | "enumDescriptions" | "pattern"
        | "then" | "else" => true,
        other => panic!("the keyword `{other}` is not tested"),
    }
}

fn count(argument: &Value) -> u64 {
    argument.as_u64().expect("a count")
}

fn is_of(value: &Value, name: &Value) -> bool {
    match name.as_str().expect("the name of a type") {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "string" => value.is_string(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        "number" => value.is_number(),
        "integer" => value.as_f64().is_some_and(|number| number.fract() == 0.0),
        other => panic!("no type `{other}`"),
    }
}
