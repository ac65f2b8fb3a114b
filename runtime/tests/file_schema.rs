//! The schema that is checked in is the one the list of nodes makes, and the reference pages have the tables that
//! the keys of graphs and scenes make.
//!
//! `PHENOMENON_BLESS=1 cargo test --workspace --test file_schema` writes all of them anew.

use std::path::{Path, PathBuf};

use phenomenon_compiler::check::{check_graph, keys};
use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::document::{Section, read};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::schema::with_tables;
use phenomenon_runtime::scene_file::{SCENE, file_schema};

fn schema() -> serde_json::Value {
    serde_json::from_str(&file_schema(&NodeLibrary::standard())).unwrap()
}

/// The validator an editor would be; its schema must itself suit the schema of schemas.
fn validator() -> jsonschema::Validator {
    jsonschema::draft7::meta::validate(&schema()).unwrap();
    jsonschema::draft7::new(&schema()).unwrap()
}

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

/// A page of `docs` has the tables of these sections, and a heading for each that the tables refer to.
fn shows(page: &str, sections: &[&Section]) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs").join(page);
    let mut text = std::fs::read_to_string(&path).unwrap();
    let made = with_tables(&text, sections).unwrap();
    if std::env::var_os("PHENOMENON_BLESS").is_some() {
        std::fs::write(&path, &made).unwrap();
        text.clone_from(&made);
    }
    assert!(text == made, "docs/{page} differs; write it anew as this file says");
    for section in sections {
        let is_referred_to = text.contains(&format!("](#{})", section.name));
        assert!(
            !is_referred_to || text.contains(&format!("# {}\n", section.name)),
            "{}",
            section.name
        );
    }
    text
}

#[test]
fn the_pages_show_the_keys_as_they_are() {
    let scenes = shows("scene-format.md", &SCENE.all());
    assert!(scenes.contains("# set\n") && scenes.contains("](#camera)"));
    let graphs = shows("graph-format.md", &keys::sections());
    assert!(graphs.contains("](#parameter)") && graphs.contains("| `soft_min` | `scalar`"));
}

#[test]
fn every_node_and_input_is_in_the_schema() {
    let library = NodeLibrary::standard();
    let whole = schema();
    let node = &whole["definitions"]["node"];
    let choices = node["allOf"].as_array().unwrap();
    // And one for maps, one for folds.
    assert_eq!(choices.len(), library.iter().count() + 2);
    for (choice, (_, definition)) in choices.iter().zip(library.iter()) {
        let signature = &definition.signature;
        assert_eq!(choice["if"]["properties"]["type"]["const"], *signature.name);
        let inputs = choice["then"]["properties"]["inputs"]["properties"].as_object().unwrap();
        let names: Vec<&str> = signature.all_inputs().map(|input| &*input.name).collect();
        assert_eq!(inputs.keys().map(String::as_str).collect::<Vec<_>>(), names);
        for (input, schema) in signature.all_inputs().zip(inputs.values()) {
            assert!(schema["description"].as_str().unwrap().starts_with(&input.doc));
            if input.fixed {
                let given = schema["anyOf"].as_array().unwrap();
                let number = given.iter().find(|it| it["type"] == "integer").unwrap();
                assert_eq!(number["maximum"].as_f64(), Some(*input.range.end()));
                let names = given.iter().find_map(|it| it["enum"].as_array());
                assert_eq!(names.map_or(0, Vec::len), input.choices.len());
                continue;
            }
            let reference = schema["allOf"][0]["$ref"].as_str().unwrap();
            let pointer = reference.strip_prefix('#').unwrap();
            assert!(whole.pointer(pointer).is_some(), "{reference}");
        }
    }
}

fn json_files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut pending = vec![folder.to_owned()];
    while let Some(folder) = pending.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                pending.push(path);
            } else if path.extension().is_some_and(|it| it == "json")
                && !path.ends_with("schema.json")
            {
                found.push(path);
            }
        }
    }
    found
}

#[test]
fn shipped_files_suit_the_schema() {
    let validator = validator();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut files = json_files(&root.join("scenes"));
    files.extend(
        json_files(&root.join("graphs"))
            .into_iter()
            .filter(|path| !path.to_string_lossy().contains("broken")),
    );
    assert!(files.len() >= 7, "{files:?}");
    for path in files {
        let file = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
        let mistakes: Vec<String> = validator
            .iter_errors(&file)
            .map(|mistake| format!("{}: {mistake}", mistake.instance_path()))
            .collect();
        assert!(mistakes.is_empty(), "{}: {}", path.display(), mistakes.join("\n"));
    }
}

/// What a schema can say: kinds, keys and words, not what names refer to.
const STRUCTURAL: [Code; 9] = [
    Code::NOT_A_GRAPH,
    Code::WRONG_KIND,
    Code::UNKNOWN_KEY,
    Code::MISSING_KEY,
    Code::UNKNOWN_NODE_TYPE,
    Code::UNKNOWN_INPUT,
    Code::MISSING_INPUT,
    Code::UNKNOWN_ROOT,
    Code::MISSING_ROOT,
];

#[test]
fn structural_mistakes_do_not_suit_the_schema() {
    let validator = validator();
    let library = NodeLibrary::standard();
    let mut structural = 0;
    let broken = Path::new(env!("CARGO_MANIFEST_DIR")).join("../graphs/broken");
    for path in json_files(&broken) {
        // Scenes are checked by the command line, whose tests look at those.
        if path.starts_with(broken.join("scenes")) {
            continue;
        }
        let text = std::fs::read_to_string(&path).unwrap();
        let Ok(document) = read("a", text.as_bytes()) else { continue };
        let checked = check_graph(&document, &library);
        if checked.findings.iter().any(|finding| STRUCTURAL.contains(&finding.code)) {
            structural += 1;
            let file = serde_json::from_str(&text).unwrap();
            assert!(!validator.is_valid(&file), "{}", path.display());
        }
    }
    assert!(structural >= 25, "{structural}");
}

#[test]
fn lists_of_requirements_are_read_as_the_schema_says() {
    let validator = validator();
    let library = NodeLibrary::standard();
    let fine: &[Code] = &[];
    for (requires, expected) in [
        (r#""derivative": [1]"#, fine),
        (r#""derivative": [2, 1]"#, fine),
        (r#""derivative": []"#, &[Code::WRONG_LENGTH]),
        (r#""derivative": [1, 2, 1]"#, &[Code::DUPLICATE_KEY]),
        (r#""derivative": [1, 1.0]"#, &[Code::DUPLICATE_KEY]),
        (r#""derivative": [3]"#, &[Code::NUMBER_OUT_OF_RANGE]),
        (r#""derivative": 1"#, &[Code::WRONG_KIND]),
        (r#""apply": ["material"]"#, fine),
        (r#""apply": ["shadow", "material"]"#, fine),
        (r#""apply": []"#, &[Code::WRONG_LENGTH]),
        (r#""apply": ["material", "material"]"#, &[Code::DUPLICATE_KEY]),
        (r#""apply": ["materiel"]"#, &[Code::UNKNOWN_CHOICE]),
        (r#""apply": "material""#, &[Code::WRONG_KIND]),
    ] {
        let text = format!(
            r#"{{ "phenomenon": "a", "requires": {{ {requires} }}, "roots": {{ "material": [1, 0, 0] }} }}"#
        );
        let checked = check_graph(&read("a.json", text.as_bytes()).unwrap(), &library);
        let codes: Vec<Code> = checked.findings.iter().map(|finding| finding.code).collect();
        assert_eq!(codes, expected, "{requires}");
        let file = serde_json::from_str(&text).unwrap();
        assert_eq!(validator.is_valid(&file), expected.is_empty(), "{requires}");
    }
}
