//! The ten materials of `docs/materials.md`: each is short, and the page says how short.

use std::path::{Path, PathBuf};

use serde_json::Value;

/// A material has fewer nodes than this, those of phenomena it is made of and its expressions counted with.
const SHORT: usize = 25;
/// All pictures of the page, in bytes.
const PICTURES: u64 = 350_000;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn graph(path: &Path) -> Value {
    let text = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{path:?}: {error}"));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{path:?}: {error}"))
}

/// Nodes and expressions.
type Counts = (usize, usize);

/// What a phenomenon is made of: its nodes, where one is a phenomenon that one's, and all expressions. `round` are
/// the phenomena that stand round it in the file, the nearest last.
fn counts(phenomenon: &Value, folder: &Path, round: &[&Value]) -> Counts {
    let within = [round, &[phenomenon]].concat();
    let mut all = (0, 0);
    for (key, value) in phenomenon.as_object().expect("a phenomenon is an object") {
        // Those that stand in the file count where they are used.
        if key != "phenomena" {
            all.1 += expressions(value);
        }
    }
    for node in phenomenon["nodes"].as_object().into_iter().flat_map(|nodes| nodes.values()) {
        let (nodes, expressions) = of_type(&node["type"], folder, &within);
        all = (all.0 + nodes, all.1 + expressions);
    }
    all
}

fn of_type(name: &Value, folder: &Path, round: &[&Value]) -> Counts {
    let mut bodies = ["map", "fold"].into_iter().filter_map(|kind| name.get(kind));
    if let Some(body) = bodies.next() {
        return of_type(body, folder, round);
    }
    if let Some(file) = name.get("file").and_then(Value::as_str) {
        let path = folder.join(file);
        return counts(&graph(&path), path.parent().expect("a file is in a folder"), &[]);
    }
    let Some(inner) = name.get("phenomenon").and_then(Value::as_str) else {
        assert!(name.is_string(), "{name}");
        return (1, 0);
    };
    let places = round.iter().enumerate().rev();
    let mut found =
        places.filter_map(|(depth, place)| Some((depth, place["phenomena"].get(inner)?)));
    let (depth, found) = found.next().unwrap_or_else(|| panic!("no `{inner}`"));
    counts(found, folder, &round[..=depth])
}

fn expressions(value: &Value) -> usize {
    match value {
        Value::Object(object) => {
            usize::from(object.contains_key("expression"))
                + object.values().map(expressions).sum::<usize>()
        }
        Value::Array(list) => list.iter().map(expressions).sum(),
        _ => 0,
    }
}

#[test]
fn nodes_of_phenomena_within_are_counted() {
    let graph: Value = serde_json::from_str(
        r#"{ "phenomena": {
            "outer": {
                "phenomena": { "inner": { "nodes": { "a": { "type": "state" }, "b": { "type": "state" } } } },
                "nodes": { "x": { "type": { "phenomenon": "inner" } }, "y": { "type": { "map": { "phenomenon": "inner" } } },
                    "z": { "type": "add", "inputs": { "a": { "expression": "1", "where": { "c": { "expression": "2" } } } } } }
            } },
            "nodes": { "twice": { "type": { "phenomenon": "outer" } }, "thrice": { "type": { "phenomenon": "outer" } },
                "here": { "type": "state" } },
            "outputs": { "o": { "from": [{ "expression": "3" }] } } }"#,
    )
    .unwrap();
    assert_eq!(counts(&graph, Path::new("."), &[]), (11, 5));
}

#[test]
fn ten_materials_are_short_and_the_page_says_how_short() {
    let docs = root().join("docs");
    let page = std::fs::read_to_string(docs.join("materials.md")).unwrap();
    let mut pictures = 0;
    let mut rows = 0;
    for row in page.lines().filter(|line| line.starts_with("| ![")) {
        let linked = |of: &str| {
            let links = row.split("](").skip(1).filter_map(|link| link.split_once(')'));
            links.map(|link| link.0).find(|link| link.starts_with(of)).expect(row)
        };
        let file = linked("../graphs/");
        let path = docs.join(file);
        let (nodes, expressions) = counts(&graph(&path), path.parent().unwrap(), &[]);
        assert!(nodes + expressions < SHORT, "{file}: {nodes} nodes, {expressions} expressions");
        assert!(
            row.contains(&format!("| {nodes} + {expressions} |")),
            "{nodes} + {expressions}: {row}"
        );
        let picture = linked("pictures/materials/");
        pictures += std::fs::metadata(docs.join(picture)).expect(picture).len();
        // The command makes this picture of this graph.
        assert!(row.contains(&format!("`phenomenon render {} ", &file["../".len()..])), "{row}");
        assert!(row.contains(&format!("-o docs/{picture}`")), "{row}");
        rows += 1;
    }
    assert_eq!(rows, 10);
    assert!(pictures <= PICTURES, "{pictures} bytes");
}
