//! Nodes as JSON, version 1.

use phenomenon_compiler::check::as_node;
use phenomenon_compiler::diagnostics::peers::Entry;
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::nodes::{DefaultValue, Input, Kind, Output, Signature};
use phenomenon_compiler::values::{Literal, Type};
use serde_json::{Map, Value, json};

use super::groups::Group;
use super::search::Found;
use crate::numbers::number;

/// `{"version":1,"groups":[{"name","doc","nodes":[…]}]}`
pub fn groups(groups: &[Group<'_>]) -> String {
    let groups: Vec<Value> = groups
        .iter()
        .map(|group| {
            let nodes: Vec<Value> = group.nodes.iter().map(|node| described(node)).collect();
            json!({ "name": group.name, "doc": group.doc, "nodes": nodes })
        })
        .collect();
    format!("{:#}\n", json!({ "version": 1, "groups": groups }))
}

/// `{"version":1,"nodes":[…]}`, the best first, with the `advice` there is, and in `peers` what there is for nodes of
/// others that are called so.
pub fn found(found: &Found<'_>) -> String {
    let nodes: Vec<Value> = found.hits.iter().map(|hit| described(hit.node)).collect();
    let mut object = json!({ "version": 1, "nodes": nodes });
    if !found.advice.is_empty() {
        object["advice"] = found.advice.into();
    }
    if !found.peers.is_empty() {
        object["peers"] = found.peers.iter().map(Entry::answer).collect();
    }
    format!("{object:#}\n")
}

/// `{"version":1,"node":{…}}`
pub fn node(node: &Signature) -> String {
    format!("{:#}\n", json!({ "version": 1, "node": described(node) }))
}

/// `{"version":1,"node":{…},"presets":{"name":{"parameter":value}}}`
pub fn phenomenon(graph: &Graph) -> String {
    let presets: Map<String, Value> = graph
        .presets
        .iter()
        .map(|preset| {
            let values = preset.values.iter();
            let values = values.map(|(name, literal)| (name.clone(), value(literal)));
            (preset.name.clone(), Value::Object(values.collect()))
        })
        .collect();
    let node = described(&as_node(graph, &graph.name));
    format!("{:#}\n", json!({ "version": 1, "node": node, "presets": presets }))
}

fn described(node: &Signature) -> Value {
    let mut object = Map::new();
    object.insert("name".into(), (*node.name).into());
    object.insert("group".into(), node.group.into());
    object.insert("doc".into(), node.doc.as_str().into());
    object.insert("source".into(), node.source.into());
    match &node.kind {
        Kind::Request(effect) => {
            object.insert("effect".into(), effect.name().into());
        }
        Kind::Scope(fields) => {
            let names: Vec<&str> = fields.iter().map(|field| field.name()).collect();
            object.insert("changes".into(), names.into());
        }
        Kind::Plain | Kind::Fields(_) | Kind::Loop(..) | Kind::List(_) => {}
    }
    object.insert("inputs".into(), node.inputs.iter().map(|of| input(node, of)).collect());
    if let Some(list) = &node.or_list {
        object.insert("or_list".into(), input(node, list));
    }
    object.insert("outputs".into(), node.outputs.iter().map(|of| output(node, of)).collect());
    Value::Object(object)
}

fn input(node: &Signature, input: &Input) -> Value {
    let mut object = socket(&input.name, &input.doc, node.types_of(input.value_type));
    let default = match &input.default {
        DefaultValue::Required => None,
        DefaultValue::Literal(literal) => Some(value(literal)),
        DefaultValue::State(field) => Some(json!({ "state": field.name() })),
        DefaultValue::Node(name) => Some(json!({ "node": name })),
    };
    object.insert("required".into(), default.is_none().into());
    if let Some(default) = default {
        object.insert("default".into(), default);
    }
    insert_range(&mut object, input.value_type, *input.range.start(), *input.range.end());
    // Left out where it says nothing, as limits are.
    if let Some(soft) = input.narrower() {
        object.insert("soft_min".into(), (*soft.start()).into());
        object.insert("soft_max".into(), (*soft.end()).into());
    }
    if !input.unit.is_empty() {
        object.insert("unit".into(), (*input.unit).into());
    }
    if input.fixed {
        object.insert("fixed".into(), true.into());
    }
    if !input.choices.is_empty() {
        object.insert("choices".into(), input.choices.into());
    }
    object.insert("guarded".into(), input.guarded.into());
    object.insert("scoped".into(), input.scoped.into());
    Value::Object(object)
}

fn output(node: &Signature, output: &Output) -> Value {
    let mut object = socket(&output.name, &output.doc, node.types_of(output.value_type));
    insert_range(&mut object, output.value_type, *output.range.start(), *output.range.end());
    Value::Object(object)
}

fn socket(name: &str, doc: &str, types: &[Type]) -> Map<String, Value> {
    let types: Value = types.iter().map(|of| of.name()).collect();
    let mut object = Map::new();
    object.insert("name".into(), name.into());
    object.insert("types".into(), types);
    object.insert("doc".into(), doc.into());
    object
}

/// A limit that excludes no finite number is left out.
fn insert_range(object: &mut Map<String, Value>, value_type: Type, low: f64, high: f64) {
    if !value_type.is_numeric() {
        return;
    }
    if low > -f64::from(f32::MAX) {
        object.insert("min".into(), low.into());
    }
    let most = if value_type == Type::Integer { i32::MAX.into() } else { f64::from(f32::MAX) };
    if high < most {
        object.insert("max".into(), high.into());
    }
}

fn value(literal: &Literal) -> Value {
    match literal {
        Literal::Boolean(value) => (*value).into(),
        Literal::Integer(value) => (*value).into(),
        Literal::Scalar(value) => number(*value),
        Literal::Color(value) => value.iter().copied().map(number).collect(),
        Literal::Vector(value) => value.iter().copied().map(number).collect(),
        Literal::Transform(value) => value.iter().copied().map(number).collect(),
        Literal::String(text) => text.as_str().into(),
        Literal::Texture(None) | Literal::NoShader => Value::Null,
        Literal::Texture(Some(texture)) => texture.file.as_str().into(),
        Literal::Light(name) => name.as_str().into(),
        Literal::Lights(names) => names.as_slice().into(),
    }
}
