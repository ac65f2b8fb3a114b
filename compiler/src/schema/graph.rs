//! The schema of graph files.

use serde_json::{Map, Value, json};

use super::parts::{described, object, reference};
use super::sections::Sections;
use crate::check::turns::{ACCUMULATED, Form, INDEX, INITIAL, ITEM, OVER};
use crate::check::{MAX_OUTPUTS, MAX_SHADERS, keys};
use crate::document::{Given, Key, Section};
use crate::nodes::{DefaultValue, Input, NodeLibrary, Signature};
use crate::values::{ColorSpace, Type};

/// Adds the definition `graph` of graph files, and what it needs.
pub fn define_graph(library: &NodeLibrary, definitions: &mut Map<String, Value>) {
    definitions.insert("graph".into(), called_for(&keys::PHENOMENON));
    definitions.insert("phenomena".into(), called_for(&keys::INNER));
    definitions.insert("output".into(), output());
    definitions
        .insert("name".into(), json!({ "type": "string", "pattern": NAME, "maxLength": 256 }));
    definitions.insert("parameter".into(), declaration(true));
    definitions.insert("element".into(), declaration(false));
    definitions.insert("requires".into(), SECTIONS.schema(&keys::REQUIRES));
    definitions.insert("roots".into(), roots());
    definitions.insert("root".into(), root());
    definitions.insert("shaders".into(), shaders());
    definitions.insert("node".into(), node(library));
    let file = object(&["file"], json!({ "file": { "type": "string", "minLength": 1 } }));
    let inner = object(&["phenomenon"], json!({ "phenomenon": reference("name") }));
    definitions.insert("phenomenon_type".into(), json!({ "anyOf": [file, inner] }));
    sources(definitions);
}

/// Names of phenomena, parameters and nodes: letters and digits of any script, `_` and `-`.
const NAME: &str =
    "^[^\\s\\u0000-\\u002c\\u002e-\\u002f\\u003a-\\u0040\\u005b-\\u005e\\u0060\\u007b-\\u007f]+$";

const SECTIONS: Sections = Sections {
    definition: |section| match section.name {
        "phenomenon" => "graph".into(),
        name => name.into(),
    },
};

/// What an input of each type may be given.
fn sources(definitions: &mut Map<String, Value>) {
    let (parameter, node): (Vec<&Key>, Vec<&Key>) =
        keys::CONNECTION.keys.iter().partition(|key| key.name == "interface");
    let connection = json!({ "anyOf": [
        object(&["node"], SECTIONS.properties(node)),
        object(&["interface"], SECTIONS.properties(parameter)),
    ] });
    let own = json!({ "$ref": "#/definitions/expression" });
    let connection = json!({ "anyOf": [connection["anyOf"][0], connection["anyOf"][1], own] });
    let text = json!({ "type": "string" });
    let number = json!({ "type": "number", "minimum": -f64::from(f32::MAX), "maximum": f64::from(f32::MAX) });
    let list = |least: usize, most: usize| json!({ "type": "array", "items": { "$ref": "#/definitions/number" }, "minItems": least, "maxItems": most });
    let integer = json!({ "type": "integer", "minimum": i32::MIN, "maximum": i32::MAX });
    let number_here = reference("number");
    let light = object(&["light"], json!({ "light": text }));
    let texture = SECTIONS.schema(&keys::TEXTURE);
    let null = json!({ "type": "null" });
    for (name, literal) in [
        ("boolean", vec![json!({ "type": "boolean" })]),
        ("integer", vec![integer]),
        ("scalar", vec![number_here.clone()]),
        (
            "color",
            [vec![number_here.clone(), list(3, 4)], vec![reference("color_of_space")]].concat(),
        ),
        ("vector", vec![list(3, 3)]),
        ("transform", vec![list(16, 16)]),
        ("string", vec![text]),
        ("texture", vec![texture, null.clone()]),
        ("light", vec![light.clone()]),
        ("lights", vec![json!({ "type": "array", "items": light })]),
        ("shader", vec![null]),
        ("generic", vec![number_here.clone(), list(3, 4), reference("color_of_space")]),
        (
            "computed",
            vec![
                json!({ "type": "boolean" }),
                number_here,
                list(3, 4),
                list(16, 16),
                reference("color_of_space"),
            ],
        ),
    ] {
        definitions.insert(format!("{name}_literal"), json!({ "anyOf": literal }));
        let own = json!({ "$ref": format!("#/definitions/{name}_literal") });
        let source = json!({ "anyOf": [own, { "$ref": "#/definitions/connection" }] });
        definitions.insert(name.into(), source);
        let values = json!({ "type": "array", "items": reference(name), "minItems": 1 });
        let list = json!({ "anyOf": [values, reference("connection")] });
        definitions.insert(format!("{name}_list"), list);
    }
    definitions.insert("color_of_space".into(), json!({ "anyOf": colors() }));
    definitions.insert("number".into(), number);
    definitions.insert("connection".into(), connection);
    definitions.insert("expression".into(), SECTIONS.schema(&keys::EXPRESSION));
    let bound = ["generic", "boolean", "string", "texture"].map(reference);
    let names = json!({ "type": "object", "propertyNames": reference("name"), "additionalProperties": { "anyOf": bound } });
    definitions.insert("where".into(), names);
}

fn source_name(signature: &Signature, value_type: Type) -> &'static str {
    match value_type {
        Type::Generic if signature.generic.contains(&Type::Boolean) => "computed",
        Type::Generic => "generic",
        other => other.name(),
    }
}

/// A parameter, or a member of a struct; without a default what an array is of.
fn declaration(with_default: bool) -> Value {
    let choices: Vec<Value> =
        keys::declared_types().iter().map(|name| declaration_of(name, with_default)).collect();
    let names = keys::declared_types();
    json!({ "type": "object", "required": ["type"], "properties": { "type": { "enum": names } }, "allOf": choices })
}

/// What holds of a parameter of one type.
fn declaration_of(name: &str, with_default: bool) -> Value {
    let known = keys::of_declaration(Some(name), false).into_iter();
    let known: Vec<&Key> = known.filter(|key| with_default || key.name != "default").collect();
    let is_required = |key: &&&Key| match key.given {
        Given::RequiredBut(types) => !types.contains(&name),
        given => given == Given::Required,
    };
    let required: Vec<&str> = known.iter().filter(is_required).map(|key| key.name).collect();
    let mut properties = SECTIONS.properties(known.iter().copied());
    properties["type"] = json!({ "const": name });
    if let Some(of) = properties.get_mut("of") {
        *of = described("element", "What each of its values is.");
    }
    if let Some(members) = properties.get_mut("members") {
        members["minProperties"] = json!(1);
    }
    if with_default {
        let doc = properties["default"]["description"].take();
        let mut default = match name {
            "array" => json!({ "type": "array", "minItems": 1 }),
            "struct" => object(&["struct"], json!({ "struct": { "type": "object" } })),
            // Of an enumeration it may be a name.
            "integer" => json!({ "anyOf": [reference("integer_literal"), { "type": "string" }] }),
            name => json!({ "allOf": [reference(&format!("{name}_literal"))] }),
        };
        default["description"] = doc;
        properties["default"] = default;
    }
    json!({
        "if": { "properties": { "type": { "const": name } }, "required": ["type"] },
        "then": object(&required, properties),
    })
}

/// A phenomenon, which has roots or outputs.
fn called_for(section: &Section) -> Value {
    let mut phenomenon = SECTIONS.schema(section);
    phenomenon["properties"]["outputs"]["minProperties"] = json!(1);
    phenomenon["properties"]["outputs"]["maxProperties"] = json!(MAX_OUTPUTS);
    phenomenon["anyOf"] = json!([{ "required": ["roots"] }, { "required": ["outputs"] }]);
    phenomenon
}

/// An output, whose value is of its type.
fn output() -> Value {
    let mut output = SECTIONS.schema(&keys::OUTPUT);
    let of_type = |value_type: Type| {
        let name = value_type.name();
        json!({
            "if": { "properties": { "type": { "const": name } }, "required": ["type"] },
            "then": { "properties": { "from": reference(name) } },
        })
    };
    output["properties"]["from"] = json!({
        "description": output["properties"]["from"]["description"],
    });
    output["allOf"] = Value::Array(Type::COMPUTED.map(of_type).into());
    output
}

/// Colours of other spaces, an object for each.
fn colors() -> Vec<Value> {
    let numbers = json!([reference("number"), { "type": "array", "items": reference("number"), "minItems": 3, "maxItems": 4 }]);
    let share = json!({ "type": "number", "minimum": 0, "maximum": 1 });
    let encoded = json!([
        { "type": "string", "pattern": "^#([0-9a-fA-F]{3}|[0-9a-fA-F]{4}|[0-9a-fA-F]{6}|[0-9a-fA-F]{8})$" },
        share,
        { "type": "array", "items": share, "minItems": 3, "maxItems": 4 },
    ]);
    let of_space = |space: ColorSpace| {
        let given = if space.is_encoded() { &encoded } else { &numbers };
        object(&[space.name], json!({ (space.name): { "anyOf": given } }))
    };
    ColorSpace::ALL.map(of_space).into()
}

fn roots() -> Value {
    let mut roots = SECTIONS.schema(&keys::ROOTS);
    roots["minProperties"] = json!(1);
    roots
}

fn root() -> Value {
    json!({ "anyOf": [reference("shaders"), SECTIONS.schema(&keys::ROOT)] })
}

/// A color, or a list of shaders that hand one another their color.
fn shaders() -> Value {
    json!({ "anyOf": [
        reference("color"),
        {
            "type": "array", "items": reference("color"),
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
            .all_inputs()
            .map(|input| (input.name.to_string(), input_schema(signature, input)))
            .collect();
        let required = required_inputs(signature);
        let mut inputs = object(&required, Value::Object(inputs));
        if let Some(list) = &signature.or_list {
            let others = signature.inputs.iter().skip(1);
            let others: Vec<Value> = others.map(|it| json!({ "required": [&*it.name] })).collect();
            inputs["dependencies"] = json!({ &*list.name: { "not": { "anyOf": others } } });
        }
        let mut of_type = json!({ "properties": { "inputs": inputs } });
        if !required.is_empty() {
            of_type["required"] = json!(["inputs"]);
        }
        choices.push(json!({
            "if": { "properties": { "type": { "const": &*signature.name } }, "required": ["type"] },
            "then": of_type,
        }));
    }
    let mut node = SECTIONS.schema(&keys::NODE);
    let properties = &mut node["properties"];
    properties["type"] = json!({
        "anyOf": [
            { "enum": names, "enumDescriptions": docs },
            reference("phenomenon_type"),
            object(&["map"], json!({ "map": reference("phenomenon_type") })),
            object(&["fold"], json!({ "fold": reference("phenomenon_type") })),
        ],
        "description": properties["type"]["description"],
    });
    properties["inputs"] = json!({
        "type": "object", "description": properties["inputs"]["description"],
    });
    choices.extend(Form::ALL.map(of_turns));
    node["allOf"] = Value::Array(choices);
    node
}

/// The inputs of a map or a fold, as far as they are its own: the others are those of its body.
fn of_turns(form: Form) -> Value {
    let (needed, own): (&[&str], &[&str]) = match form {
        Form::Map => (&[OVER], &[ITEM, INDEX]),
        Form::Fold => (&[OVER, INITIAL], &[ITEM, INDEX, ACCUMULATED]),
    };
    let own: Map<String, Value> =
        own.iter().map(|name| ((*name).to_owned(), false.into())).collect();
    let node_type = json!({ "type": "object", "required": [form.name()] });
    json!({
        "if": { "properties": { "type": node_type }, "required": ["type"] },
        "then": {
            "properties": { "inputs": { "type": "object", "required": needed, "properties": own } },
            "required": ["inputs"],
        },
    })
}

fn required_inputs(signature: &Signature) -> Vec<&str> {
    let required =
        signature.inputs.iter().filter(|input| matches!(input.default, DefaultValue::Required));
    required.map(|input| &*input.name).collect()
}

fn input_schema(signature: &Signature, input: &Input) -> Value {
    let default = match &input.default {
        DefaultValue::Required => String::new(),
        DefaultValue::Literal(_) => " Has a default.".into(),
        DefaultValue::State(field) => format!(" By default the state's {}.", field.name()),
        DefaultValue::Node(name) => format!(" By default what `{name}` yields."),
    };
    let unit = match &*input.unit {
        "" => String::new(),
        unit => format!(" In {unit}."),
    };
    let doc = format!("{}{unit}{default}", input.doc);
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
        return described(&format!("{}_list", source_name(signature, input.value_type)), &doc);
    }
    described(source_name(signature, input.value_type), &doc)
}
