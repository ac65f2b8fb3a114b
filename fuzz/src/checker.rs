//! The checker, and what its answers promise.

use std::collections::BTreeMap;
use std::path::Path;

use phenomenon_compiler::check::check_graph_with;
use phenomenon_compiler::diagnostics::{Finding, Severity};
use phenomenon_compiler::document::read;
use phenomenon_runtime::scene_file::{is_scene, read_scene};

use super::files::InMemory;
use super::library::LIBRARY;
use super::reader::hold;
use super::shading;

/// Checks a graph or a scene. Findings hold to their rules, there is a graph unless one of them is
/// an error, fixes leave a file that can be read, and a graph can be drawn and run.
pub fn check_anything(bytes: &[u8]) {
    let files = InMemory::of(bytes);
    let Ok(document) = read("0.json", files.first()) else { return };
    if is_scene(&document) {
        // No such folder: the files a scene names are not looked for all over the disk.
        let scene = read_scene("0.json", files.first(), Path::new("/no/such/folder"));
        let wrong = scene.findings.iter().any(|it| it.severity == Severity::Error);
        assert_eq!(scene.scene.is_none(), wrong, "{:?}", scene.findings);
        scene.findings.iter().for_each(hold);
        mended(&document.file.text, &scene.findings);
        return;
    }
    let checked = check_graph_with(&document, &LIBRARY, &files);
    let wrong = checked.findings.iter().any(|it| it.severity == Severity::Error);
    if checked.omitted == 0 {
        assert_eq!(checked.graph.is_none(), wrong, "{:?}", checked.findings);
    }
    checked.findings.iter().for_each(hold);
    mended(&document.file.text, &checked.findings);
    if let Some(graph) = checked.graph {
        // Both take longer than all else, so each is done for some of the inputs.
        match bytes
            .iter()
            .fold(0_u32, |sum, byte| sum.wrapping_mul(31).wrapping_add(u32::from(*byte)))
            % 8
        {
            0 => shading::draw(&graph),
            1 | 2 => shading::run(graph),
            _ => {}
        }
    }
}

/// Puts the fixes in as `phenomenon check --fix` does: by place, from the end.
fn mended(text: &str, findings: &[Finding]) {
    let fixes: BTreeMap<usize, (&Finding, &String)> = findings
        .iter()
        .filter(|finding| finding.place.file.name == "0.json")
        .filter_map(|finding| Some((finding.place.start, (finding, finding.fix.as_ref()?))))
        .collect();
    if fixes.is_empty() {
        return;
    }
    let mut text = text.to_owned();
    for (finding, fix) in fixes.values().rev() {
        text.replace_range(finding.place.start..finding.place.end, fix);
    }
    if let Err(finding) = read("fixed.json", text.as_bytes()) {
        panic!("{finding}\n{text}");
    }
}
