//! The examples of codes that are scenes: the wrong one has that one mistake, the right one none.

use std::path::Path;

use phenomenon_compiler::diagnostics::{Code, Explanation};
use phenomenon_runtime::scene_file::{SceneFile, read_scene};

fn read(text: &str) -> SceneFile {
    read_scene("example.json", text.as_bytes(), Path::new("."))
}

#[test]
fn examples_that_are_scenes_are_what_they_say() {
    let mut seen = Vec::new();
    for Explanation { code, wrong, right, .. } in Explanation::ALL {
        if !wrong.starts_with('{') || !wrong.contains("\"camera\"") {
            continue;
        }
        let file = read(wrong);
        let codes: Vec<Code> = file.findings.iter().map(|finding| finding.code).collect();
        assert_eq!(codes, [*code], "{wrong}");
        assert!(file.scene.is_none());
        let file = read(right);
        assert!(file.findings.is_empty() && file.scene.is_some(), "{right}: {:?}", file.findings);
        seen.push(*code);
    }
    assert_eq!(seen, [Code::NOT_A_SCENE, Code::UNUSABLE_OBJECT]);
}
