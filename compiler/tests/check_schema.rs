//! The schema that is checked in is the one the list of nodes makes.
//!
//! `PHENOMENON_BLESS=1 cargo test -p phenomenon-compiler --test check_schema` writes it anew.

use std::path::Path;

use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::schema::file_schema;

#[test]
fn the_schema_is_in_sync() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../graphs/schema.json");
    let schema = file_schema(&NodeLibrary::standard());
    if std::env::var_os("PHENOMENON_BLESS").is_some() {
        std::fs::write(&path, &schema).unwrap();
    }
    let checked_in = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(checked_in == schema, "graphs/schema.json differs; write it anew as this file says");
}

#[test]
fn every_node_and_input_is_in_the_schema() {
    let library = NodeLibrary::standard();
    let whole: serde_json::Value = serde_json::from_str(&file_schema(&library)).unwrap();
    let node = &whole["definitions"]["node"];
    let choices = node["allOf"].as_array().unwrap();
    assert_eq!(choices.len(), library.iter().count());
    for (choice, (_, definition)) in choices.iter().zip(library.iter()) {
        let signature = &definition.signature;
        assert_eq!(choice["if"]["properties"]["type"]["const"], signature.name);
        let inputs = choice["then"]["properties"]["inputs"]["properties"].as_object().unwrap();
        let names: Vec<&str> = signature.inputs.iter().map(|input| input.name).collect();
        assert_eq!(inputs.keys().map(String::as_str).collect::<Vec<_>>(), names);
        for (input, schema) in signature.inputs.iter().zip(inputs.values()) {
            assert!(schema["description"].as_str().unwrap().starts_with(&input.doc));
            let reference = schema["allOf"][0]["$ref"].as_str().unwrap();
            let pointer = reference.strip_prefix('#').unwrap();
            assert!(whole.pointer(pointer).is_some(), "{reference}");
        }
    }
}
