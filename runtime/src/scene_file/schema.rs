//! The JSON Schema of graph and scene files: editors complete node types, inputs, keys and words from it, with
//! their docs.

use phenomenon_compiler::document::Section;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::schema::{Sections, define_graph, object, reference};
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
        definitions.insert(definition(section), SECTIONS.schema(section));
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
                reference("color_of_space"),
                object(&["struct"], json!({ "struct": { "type": "object" } })),
            ] },
        }),
    );
}

const SECTIONS: Sections = Sections { definition };

/// The name of the definition of a section.
fn definition(section: &Section) -> String {
    match section.name {
        "scene" => "scene".into(),
        name => format!("scene_{name}"),
    }
}

#[cfg(test)]
mod tests {
    use phenomenon_compiler::document::Given;

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
                    // No default is a colour of a named space: nothing suits its definition here.
                    let schema = json!({ "allOf": [SECTIONS.of_kind(&key.kind)], "definitions": {
                        "scene_settings": {}, "color_of_space": false } });
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
