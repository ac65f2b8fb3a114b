//! Scenes linked with graphs, from texts and from files.

use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document::{Document, read, read_file};
use phenomenon_compiler::engine::{Engine, Options};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::specialise::Asking;
use phenomenon_compiler::values::Literal;
use phenomenon_runtime::link::{Changes, Ledger, Linked, Linker, Row, Shading, Subject};
use phenomenon_runtime::render::{Entry, Rendered, Settings, render};
use phenomenon_runtime::scene_file::{SceneFile, default_scene, is_scene, read_scene};

/// A linked scene with its ledger.
pub struct Scene {
    pub linked: Linked,
    pub rows: Vec<Row>,
}

/// The folder of the workspace.
pub fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// How a scene is linked: batch shades as soon as the jit does and is compiled sooner.
pub fn options(asking: Asking) -> Options {
    Options { engine: Engine::Batch, asking, ..Options::default() }
}

/// A graph or scene file of the workspace; a graph in the default scene.
pub fn shipped(path: &str, values: &[(&str, f32)], options: Options) -> Scene {
    let path = root().join(path);
    let document = read_file(&path).unwrap_or_else(|error| panic!("{error:?}"));
    if is_scene(&document) {
        let text = std::fs::read(&path).expect("a file");
        let file = read_scene(&path.display().to_string(), &text, path.parent().expect("a folder"));
        return linked(&file, None, options, false);
    }
    linked(&default_scene(), Some(subject(document, values)), options, true)
}

/// A graph of a text, in a scene of a text.
pub fn written(scene: &str, graph: &str, values: &[(&str, f32)], options: Options) -> Scene {
    let document = read("graph.json", graph.as_bytes()).unwrap_or_else(|error| panic!("{error:?}"));
    let file = read_scene("scene.json", scene.as_bytes(), Path::new(""));
    assert!(file.findings.is_empty(), "{:?}", file.findings);
    linked(&file, Some(subject(document, values)), options, false)
}

fn subject(document: Document, values: &[(&str, f32)]) -> Subject {
    let checked = check_graph(&document, &NodeLibrary::standard());
    let graph = checked.graph.unwrap_or_else(|| panic!("{:?}", checked.findings));
    let value = |(name, value): &(&str, f32)| ((*name).to_owned(), Literal::Scalar(*value));
    Subject { graph, document: Arc::new(document), values: values.iter().map(value).collect() }
}

fn linked(file: &SceneFile, subject: Option<Subject>, options: Options, built_in: bool) -> Scene {
    let mut scene = file.scene.clone().expect("a scene");
    if let Some(subject) = &subject {
        scene.show(&subject.graph);
    }
    let linker = Linker {
        library: &NodeLibrary::standard(),
        shading: Shading::Compiled(options),
        subject: subject.as_ref(),
        changes: &Changes::default(),
        built_in,
    };
    let lights = file.lights.as_ref().expect("lights");
    let linked = linker.link(&scene, lights, &mut |_| ());
    let linked = linked.unwrap_or_else(|error| panic!("{error}"));
    let ledger = Ledger::of(&linked.scene, &linked.shaders, &linked.uses).expect("a ledger");
    Scene { linked, rows: ledger.rows }
}

impl Scene {
    /// The row of an effect.
    pub fn row(&self, entry: Entry) -> &Row {
        self.rows.iter().find(|row| row.entry == entry).expect("every effect has a row")
    }

    /// Renders a picture of so many pixels to a side.
    pub fn render(&self, side: u32) -> Rendered {
        let size = Settings { width: side, height: side, samples: 1, ..Settings::default() };
        let settings = Settings { threads: 1, ..size };
        render(&self.linked.scene, &settings, &|_, _| ()).expect("a picture")
    }

    /// What a row cost a rendering: how many, and how many bytes.
    pub fn cost(&self, row: &Row, rendered: &Rendered) -> (u64, u64) {
        let (cost, bytes) = Ledger::cost(row, &self.linked.scene, &rendered.costs);
        (cost.count, bytes.0)
    }

    /// Expects an effect to be off for a reason with these parts.
    pub fn is_off(&self, entry: Entry, parts: &[&str]) {
        self.is(entry, false, parts);
    }

    /// Expects an effect to be on for a reason with these parts.
    pub fn is_on(&self, entry: Entry, parts: &[&str]) {
        self.is(entry, true, parts);
    }

    fn is(&self, entry: Entry, on: bool, parts: &[&str]) {
        let row = self.row(entry);
        assert_eq!(row.on, on, "{}: {}", entry.name(), row.reason);
        for part in parts {
            assert!(row.reason.contains(part), "`{}` lacks `{part}`: {}", entry.name(), row.reason);
        }
    }
}
