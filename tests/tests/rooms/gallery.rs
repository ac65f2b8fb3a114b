//! What `docs/gallery.md` tells of how much the eight materials are made of.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::workspace;

/// How much a graph is made of, with the phenomena within, each as often as it is used.
#[derive(Default)]
struct Size {
    nodes: usize,
    expressions: usize,
    files: BTreeSet<PathBuf>,
}

impl Size {
    fn of(path: &Path) -> Self {
        let mut size = Self::default();
        size.add_file(path);
        size
    }

    fn add_file(&mut self, path: &Path) {
        let file = serde_json::from_str(&text(path)).unwrap();
        self.files.insert(path.to_owned());
        self.add(&file, &file, path);
    }

    /// Adds a phenomenon of a file.
    fn add(&mut self, phenomenon: &Value, file: &Value, path: &Path) {
        for part in ["nodes", "roots", "outputs"] {
            self.expressions += expressions(&phenomenon[part]);
        }
        for (name, node) in phenomenon["nodes"].as_object().unwrap() {
            match &node["type"] {
                Value::String(_) => self.nodes += 1,
                Value::Null => assert!(node["expression"].is_string(), "{name}"),
                within => match (&within["phenomenon"], &within["file"]) {
                    (Value::String(inner), Value::Null) => {
                        self.add(&file["phenomena"][inner], file, path);
                    }
                    (Value::Null, Value::String(other)) => {
                        self.add_file(&path.with_file_name(other))
                    }
                    _ => panic!("{name} is of a type that is not counted: {within}"),
                },
            }
        }
    }

    fn shown(&self) -> String {
        match (self.nodes, self.expressions) {
            (nodes, 0) => nodes.to_string(),
            (nodes, 1) => format!("{nodes} and an expression"),
            (nodes, expressions) => format!("{nodes} and {expressions} expressions"),
        }
    }

    fn lines(&self) -> usize {
        self.files.iter().map(|path| lines(path)).sum()
    }
}

fn expressions(value: &Value) -> usize {
    match value {
        Value::Object(parts) => {
            let own = usize::from(parts.get("expression").is_some_and(Value::is_string));
            own + parts.values().map(expressions).sum::<usize>()
        }
        Value::Array(elements) => elements.iter().map(expressions).sum(),
        _ => 0,
    }
}

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn lines(path: &Path) -> usize {
    text(path).lines().count()
}

/// The numbers of a material: what its nodes are, then its lines as a graph and by hand.
type Numbers = (String, [String; 2]);

/// The name and the numbers of the material a row shows the picture of.
fn material(row: &[&str]) -> Option<(String, Numbers)> {
    let (name, path) = row.get(2)?.trim().strip_prefix('[')?.strip_suffix(')')?.split_once("](")?;
    let size = Size::of(&workspace().join("docs").join(path));
    let by_hand = workspace().join(format!("runtime/src/monoliths/{name}.rs"));
    let of_lines = [size.lines(), lines(&by_hand)].map(|lines| lines.to_string());
    Some((name.to_owned(), (size.shown(), of_lines)))
}

/// The page with these numbers: in the rows of pictures, and in those of lines, which begin with the name.
fn counted(page: &str, materials: &BTreeMap<String, Numbers>) -> String {
    let with = |line: &str| {
        let mut cells: Vec<String> = line.split('|').map(str::to_owned).collect();
        let mut put = |at: usize, number: &str| cells[at] = format!(" {number} ");
        let row: Vec<&str> = line.split('|').collect();
        if let Some((name, _)) = material(&row) {
            put(4, &materials[&name].0);
        } else if let Some((_, [graph, by_hand])) =
            row.get(1).and_then(|name| materials.get(name.split(',').next()?.trim()))
        {
            put(2, graph);
            put(3, by_hand);
        }
        cells.join("|") + "\n"
    };
    page.lines().map(with).collect()
}

/// `PHENOMENON_BLESS=1 cargo test --workspace --test rooms` writes the numbers anew.
#[test]
fn the_gallery_counts_nodes_and_lines_as_they_are() {
    let path = workspace().join("docs/gallery.md");
    let page = text(&path);
    let rows = page.lines().map(|line| line.split('|').collect::<Vec<_>>());
    let materials: BTreeMap<String, Numbers> = rows.filter_map(|row| material(&row)).collect();
    assert_eq!(materials.len(), 8);
    let lines_told = |name: &String| {
        let begins = [format!("| {name} |"), format!("| {name},")];
        page.lines().any(|line| begins.iter().any(|begin| line.starts_with(begin)))
    };
    assert!(materials.keys().all(lines_told), "a material has no row of lines");
    let counted = counted(&page, &materials);
    if std::env::var_os("PHENOMENON_BLESS").is_some() {
        return std::fs::write(&path, counted).unwrap();
    }
    for (told, is) in page.lines().zip(counted.lines()) {
        assert_eq!(told, is, "docs/gallery.md miscounts");
    }
}
