//! The scene a graph is shown in, built into the program.

use std::path::Path;

use super::file::{SceneFile, read_scene};

const SCENE: &str = include_str!("../../../scenes/default.json");
/// The files it names, as it names them from the folder above.
const FILES: [(&str, &str); 2] = [
    (
        "scenes/../graphs/floor/checker_floor.json",
        include_str!("../../../graphs/floor/checker_floor.json"),
    ),
    (
        "scenes/../graphs/sky/gradient_sky.json",
        include_str!("../../../graphs/sky/gradient_sky.json"),
    ),
];

/// The scene a graph is shown in: the graph's material on a sphere, balls beside it, on a chequered floor.
pub fn default_scene() -> SceneFile {
    read_scene("scenes/default.json", SCENE.as_bytes(), Path::new("scenes"))
}

/// The text of a graph file that [`default_scene`] names; none for other files.
pub fn embedded_file(path: &Path) -> Option<&'static str> {
    FILES.iter().find(|(name, _)| path == Path::new(name)).map(|(_, text)| *text)
}
