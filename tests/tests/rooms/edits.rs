//! The edits that `flexibility/run.sh` measures still fit what they edit.

use super::workspace;

/// Of each place that a patch changes: the file, and the lines it must have there.
fn places(patch: &str) -> Vec<(String, String)> {
    let mut places: Vec<(String, String)> = Vec::new();
    let mut file = "";
    for line in patch.lines() {
        if let Some(name) = line.strip_prefix("+++ b/") {
            file = name;
        } else if line.starts_with("@@ ") {
            places.push((file.to_owned(), String::new()));
        } else if let Some((_, before)) = places.last_mut()
            && let Some(kept) = line.strip_prefix([' ', '-'])
            && !line.starts_with("--- a/")
        {
            before.push_str(kept);
            before.push('\n');
        }
    }
    places
}

#[test]
fn every_edit_fits_its_files() {
    let folder = workspace().join("tests/flexibility");
    for edit in ["oren_nayar", "texture", "rainbow"] {
        for kind in ["graph", "hand"] {
            let name = format!("{edit}.{kind}.patch");
            let patch = std::fs::read_to_string(folder.join(&name)).unwrap();
            let places = places(&patch);
            assert!(!places.is_empty(), "{name} changes nothing");
            for (file, before) in places {
                let text = std::fs::read_to_string(workspace().join(&file)).unwrap();
                assert!(
                    text.contains(&before),
                    "{name} does not fit {file}, which lacks\n{before}"
                );
            }
        }
    }
}
