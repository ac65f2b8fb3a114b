//! The files that are shipped.

use std::path::Path;

use crate::program::ROOT;

/// Graphs that are shipped.
pub fn graphs() -> Vec<String> {
    json_files("graphs", &["graphs/broken", "graphs/schema.json"])
}

/// Scenes that are shipped.
pub fn scenes() -> Vec<String> {
    json_files("scenes", &[])
}

/// Files with mistakes, and what they use.
pub fn broken() -> Vec<String> {
    json_files("graphs/broken", &[])
}

/// What a file holds.
pub fn text(file: &str) -> String {
    std::fs::read_to_string(Path::new(ROOT).join(file)).expect("the file can be read")
}

/// The JSON files in a folder and the folders in it, sorted, with `/` between the parts of a name.
fn json_files(folder: &str, but: &[&str]) -> Vec<String> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(Path::new(ROOT).join(folder)).expect("it can be listed") {
        let entry = entry.expect("its entries can be read");
        let name = entry.file_name().into_string().expect("the name is UTF-8");
        let path = format!("{folder}/{name}");
        if but.contains(&path.as_str()) {
            continue;
        }
        if entry.file_type().expect("it has a type").is_dir() {
            found.extend(json_files(&path, but));
        } else if name.ends_with(".json") {
            found.push(path);
        }
    }
    found.sort();
    found
}
