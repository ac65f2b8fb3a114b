//! Scenes linked with their graphs, as a program that is no command line does it.

use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::check::{OnDisk, check_graph};
use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::document::{read, read_file};
use phenomenon_compiler::engine::{Engine, Options};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_runtime::link::{
    Changes, LinkError, Linked, Linker, NoSuchUse, NodePath, Note, Remark, Shading, ShowNodeError,
    Subject, TextValue, check_with_graphs,
};
use phenomenon_runtime::monoliths::NotWrittenByHand;
use phenomenon_runtime::render::{Settings, render};
use phenomenon_runtime::scene_file::{Assets, SceneFile, read_scene};

const GRAPH: &str = r#"{ "phenomenon": "tint", "requires": { "shadow": "sort" },
    "interface": { "tint": { "type": "color", "default": [0.5, 0.25, 0] } },
    "nodes": { "twice": { "type": "add", "inputs": { "a": { "interface": "tint" }, "b": { "interface": "tint" } } } },
    "roots": { "material": { "interface": "tint" } } }"#;

/// A ball before the camera that fills its picture, and one behind it that shows the subject.
fn scene(material: &str) -> SceneFile {
    balls(material, r#"{ "subject": true }"#)
}

/// A ball before the camera that fills its picture, and one behind it.
fn balls(material: &str, behind: &str) -> SceneFile {
    let text = format!(
        r#"{{ "scene": "two balls",
        "camera": {{ "position": [0, 0, 2], "look_at": [0, 0, 0] }},
        "objects": [
            {{ "name": "ball", "sphere": {{ "radius": 1.9 }}, "material": {material} }},
            {{ "name": "hidden", "sphere": {{ "center": [0, 0, 9], "radius": 1 }}, "material": {behind} }}
        ] }}"#
    );
    let file = read_scene("scene.json", text.as_bytes(), Path::new(""));
    assert!(file.findings.is_empty(), "{:?}", file.findings);
    file
}

fn subject(library: &NodeLibrary) -> Subject {
    let document = read("tint.json", GRAPH.as_bytes()).unwrap();
    let graph = check_graph(&document, library).graph.expect("a graph");
    Subject { graph, document: Arc::new(document), values: Vec::new() }
}

/// Links a scene; the result, and the notes made on the way.
fn link(
    file: &SceneFile,
    shading: Shading,
    subject: Option<&Subject>,
    changes: &Changes,
) -> (Result<Linked, LinkError>, Vec<Note>) {
    let library = NodeLibrary::standard();
    let linker = Linker { library: &library, shading, subject, changes, built_in: false };
    let mut notes = Vec::new();
    let mut hear = |remark: Remark<'_>| {
        if let Remark::Note(note) = remark {
            notes.push(note);
        }
    };
    let scene = file.scene.as_ref().expect("a scene");
    let linked = linker.link(scene, file.lights.as_ref().expect("lights"), &mut hear);
    (linked, notes)
}

/// The color in the middle of a scene's picture.
fn seen(linked: Linked) -> [f32; 4] {
    let settings = Settings { width: 3, height: 3, samples: 1, threads: 1, ..Settings::default() };
    let film = render(&linked.scene, &settings, &|_, _| ()).expect("a picture").film;
    film.pixel(1, 1)
}

fn by_hand() -> Shading {
    Shading::ByHand(Options { engine: Engine::Walk, ..Options::default() })
}

fn walk() -> Shading {
    Shading::Compiled(Options { engine: Engine::Walk, ..Options::default() })
}

#[test]
fn one_use_of_a_graph_is_changed_and_others_are_not() {
    let library = NodeLibrary::standard();
    let subject = subject(&library);
    let mut file = scene(r#"{ "subject": true }"#);
    let linked = link(&file, walk(), Some(&subject), &Changes::default()).0;
    let linked = linked.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(linked.shaders.len(), 1, "two uses that do not differ share a shader");
    assert_eq!(seen(linked), [0.5, 0.25, 0.0, 1.0]);
    let mut changes = Changes::default();
    let scene = file.scene.as_mut().unwrap();
    let change = changes.of(scene, "ball").unwrap();
    change.set.push(TextValue { name: "tint".into(), value: "0.125,0,1".into() });
    change.node = Some(NodePath::read("twice").unwrap());
    let linked = link(&file, walk(), Some(&subject), &changes).0;
    let linked = linked.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(linked.shaders.len(), 2);
    assert_eq!(seen(linked)[..3], [0.25, 0.0, 2.0]);
}

#[test]
fn what_cannot_be_linked_is_told_apart() {
    let library = NodeLibrary::standard();
    let subject = subject(&library);
    let mut file = scene(r#"{ "subject": true }"#);
    let none = Changes::default();
    let (linked, _) = link(&file, walk(), None, &none);
    assert!(matches!(linked, Err(LinkError::NoSubject { .. })));
    let (linked, _) = link(&file, by_hand(), Some(&subject), &none);
    assert!(matches!(linked, Err(LinkError::ByHand(_))));
    let absent = scene(r#"{ "file": "no/such/graph.json" }"#);
    let (linked, _) = link(&absent, walk(), Some(&subject), &none);
    assert!(matches!(linked, Err(LinkError::Unusable { file }) if file.ends_with("graph.json")));
    let mut changes = Changes::default();
    let described = file.scene.as_mut().unwrap();
    assert!(matches!(changes.of(described, "bell"), Err(NoSuchUse::Unknown { .. })));
    let past = changes.of(described, "objects[2]").map(|_| ());
    assert!(matches!(past, Err(NoSuchUse::PastTheLast { count: 2, .. })));
    let environment = changes.of(described, "environment").map(|_| ());
    assert_eq!(environment, Err(NoSuchUse::EnvironmentIsNoGraph));
    changes.of(described, "objects[0]").unwrap().node = Some(NodePath::read("thrice").unwrap());
    let (linked, _) = link(&file, walk(), Some(&subject), &changes);
    assert!(matches!(linked, Err(LinkError::Node(ShowNodeError::Missing { .. }))));
    let (linked, _) = link(&file, by_hand(), Some(&subject), &changes);
    assert!(matches!(linked, Err(LinkError::Node(ShowNodeError::ByHand))));
}

#[test]
fn what_is_not_written_by_hand_is_compiled_beside_what_is() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("tint.json");
    std::fs::write(&path, GRAPH).unwrap();
    let tint = format!(r#"{{ "file": {:?} }}"#, path.to_str().unwrap());
    let shipped = concat!(env!("CARGO_MANIFEST_DIR"), "/../graphs/constant/constant_simple.json");
    let library = NodeLibrary::standard();
    let document = read_file(Path::new(shipped)).unwrap();
    let graph = check_graph(&document, &library).graph.unwrap();
    let constant = Subject { graph, document: Arc::new(document), values: Vec::new() };
    let none = Changes::default();
    let (alone, _) = link(&balls(&tint, &tint), by_hand(), Some(&constant), &none);
    assert!(matches!(alone, Err(LinkError::ByHand(_))));
    let (linked, notes) = link(&scene(&tint), by_hand(), Some(&constant), &none);
    let linked = linked.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(linked.shaders.len(), 1);
    assert_eq!(seen(linked), [0.5, 0.25, 0.0, 1.0]);
    let why = NotWrittenByHand::Unknown("tint".into());
    assert!(notes.contains(&Note::Compiled { why }), "{notes:?}");
}

#[test]
fn what_no_picture_shows_is_noted_once() {
    let library = NodeLibrary::standard();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("tint.json");
    std::fs::write(&path, GRAPH).unwrap();
    let subject = subject(&library);
    let file = scene(&format!(r#"{{ "file": {:?} }}"#, path.to_str().unwrap()));
    let (linked, notes) = link(&file, walk(), Some(&subject), &Changes::default());
    assert!(linked.is_ok());
    let unmet =
        Note::Unmet { graph: "tint".into(), requirements: vec!["`shadow` to be `sort`".into()] };
    assert_eq!(notes, std::slice::from_ref(&unmet));
    // Those of the subject are for whoever read it.
    assert_eq!(Note::idle(&subject.graph), [unmet]);
    assert_eq!(Note::unseen(&subject.graph), None);
}

#[test]
fn a_scene_is_checked_with_its_graphs_and_each_finding_told_once() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("bad.json"), GRAPH.replace("\"add\"", "\"ad\"")).unwrap();
    let text = r#"{ "scene": "s", "camera": { "position": [0, 0, 2], "look_at": [0, 0, 0] }, "objects": [
        { "sphere": { "radius": 1 }, "material": { "file": "bad.json" } },
        { "sphere": { "radius": 2 }, "material": { "file": "./bad.json" } } ] }"#;
    let document = read("s.json", text.as_bytes()).unwrap();
    let library = NodeLibrary::standard();
    let assets = Assets::default();
    let checked = check_with_graphs(&document, folder.path(), &library, &OnDisk, &assets);
    let codes: Vec<Code> = checked.findings.iter().map(|finding| finding.code).collect();
    assert_eq!(codes, [Code::UNREACHABLE_NODE, Code::UNKNOWN_NODE_TYPE]);
    let related = &checked.findings[1].related;
    assert!(related.iter().any(|related| related.place.file.name == "s.json"), "{related:?}");
}
