//! Standard input, and files that are looked for relative to it.

use std::process::{Command, Stdio};

use crate::program::{Folder, program, run_in, was_refused};

const INNER: &str = r#"{ "phenomenon": "inner", "version": 1,
  "nodes": { "c": { "type": "constant_color", "inputs": { "value": [0.5, 0.25, 0.125] } } },
  "roots": { "material": { "node": "c" } } }"#;

const OUTER: &str = r#"{ "phenomenon": "outer", "version": 1,
  "nodes": { "inner": { "type": { "file": "folder/inner.json" } } },
  "roots": { "material": { "node": "inner" } } }"#;

fn nested() -> Folder {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("folder")).unwrap();
    folder.file("folder/inner.json", INNER);
    folder.file("outer.json", OUTER);
    folder
}

#[test]
fn paths_in_standard_input_start_at_the_current_folder() {
    let folder = nested();
    let here = folder.path("");
    let from_file = run_in(&here, &["eval", "outer.json"], "");
    let from_input = run_in(&here, &["eval", "-"], OUTER);
    assert_eq!(from_input.code, Some(0), "{from_input:?}");
    assert_eq!(from_input.output, from_file.output);
    assert!(from_input.output.contains("0.5 0.25 0.125"), "{from_input:?}");
    assert_eq!(run_in(&here, &["check", "-"], OUTER).code, Some(0));
    for (file, extension) in
        [("outer.json", "svg"), ("-", "svg"), ("outer.json", "dot"), ("-", "dot")]
    {
        let name = format!("{}.{extension}", file.replace('-', "input"));
        let run = run_in(&here, &["show", file, "-o", &name], OUTER);
        assert_eq!(run.code, Some(0), "{run:?}");
    }
    let read = |name: &str| std::fs::read(folder.path(name)).unwrap();
    assert!(read("input.svg") == read("outer.json.svg"));
    assert!(read("input.dot") == read("outer.json.dot"));
    for (file, name) in [("outer.json", "file.exr"), ("-", "input.exr")] {
        let arguments = ["render", file, "-o", name, "--size", "6x4", "--spp", "1", "--quiet"];
        let run = run_in(&here, &arguments, OUTER);
        assert_eq!(run.code, Some(0), "{run:?}");
    }
    assert!(read("input.exr") == read("file.exr"));
}

#[test]
fn a_scene_comes_from_standard_input_too() {
    let folder = nested();
    let scene = r#"{ "scene": "one", "camera": { "position": [0, 0, 5], "look_at": [0, 0, 0], "field_of_view": 40 },
      "objects": [ { "sphere": { "center": [0, 0, 0], "radius": 1 }, "material": { "file": "outer.json" } } ] }"#;
    let arguments = ["render", "-", "-o", "a.exr", "--size", "6x4", "--spp", "1", "--quiet"];
    let run = run_in(&folder.path(""), &arguments, scene);
    assert_eq!(run.code, Some(0), "{run:?}");
    assert_eq!(run_in(&folder.path(""), &["check", "-"], scene).code, Some(0));
}

#[test]
fn standard_input_has_no_name_for_a_picture() {
    let folder = nested();
    let run = run_in(&folder.path(""), &["render", "-"], OUTER);
    was_refused(&run, &["render", "-"], &["standard input", "-o"]);
    assert_eq!(std::fs::read_dir(folder.path("")).unwrap().count(), 2, "nothing is written");
}

#[test]
fn standard_input_is_refused_like_a_file() {
    let folder = nested();
    for text in ["", "{", "\u{feff}", "[[[", r#"{ "phenomenon": "x" "#] {
        let run = run_in(&folder.path(""), &["eval", "-"], text);
        was_refused(&run, &["eval", "-"], &["-:1:"]);
        assert_eq!(run_in(&folder.path(""), &["check", "-"], text).code, Some(1), "{text}");
        assert_eq!(run_in(&folder.path(""), &["fmt", "-"], text).code, Some(2), "{text}");
    }
    let twice = run_in(&folder.path(""), &["check", "-", "-"], OUTER);
    assert_eq!(twice.code, Some(2), "{twice:?}");
    assert!(twice.output.contains("standard input is read already"), "{twice:?}");
    // What is read several times cannot be standard input.
    let bench = run_in(&folder.path(""), &["bench", "render", "-"], OUTER);
    was_refused(&bench, &["bench", "render", "-"], &["give the path of a file"]);
    // Closed or a folder: an error, no panic.
    let mut command = program(&["check", "-"]);
    command.stdin(Stdio::from(std::fs::File::open(folder.path("")).unwrap()));
    let output = command.output().unwrap();
    assert_eq!(output.status.code(), Some(2), "{output:?}");
}

#[test]
fn standard_input_is_bounded() {
    let folder = Folder::new();
    let mut command = program(&["eval", "-"]);
    command.stdin(Stdio::from(std::fs::File::open("/dev/zero").unwrap()));
    let output = command.current_dir(folder.path("")).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("at most"), "{output:?}");
}

#[test]
fn standard_input_is_formatted_to_standard_output() {
    let folder = nested();
    let here = folder.path("");
    let formatted = run_in(&here, &["fmt", "-"], OUTER);
    assert_eq!(formatted.code, Some(0), "{formatted:?}");
    assert_eq!(run_in(&here, &["fmt", "outer.json"], "").output, "");
    assert_eq!(std::fs::read_to_string(folder.path("outer.json")).unwrap(), formatted.output);
    let again = run_in(&here, &["fmt", "-"], &formatted.output);
    assert_eq!(again.output, formatted.output);
    let run = run_in(&here, &["fmt", "--check", "-"], OUTER);
    assert_eq!((run.code, run.output.as_str()), (Some(1), "-\n"));
    assert_eq!(run_in(&here, &["fmt", "--check", "-"], &formatted.output).code, Some(0));
}

#[test]
fn a_difference_is_shown_and_nothing_written() {
    let folder = nested();
    let here = folder.path("");
    // For programs a difference is exact, whatever a terminal would make of it.
    let deceiving = "{ \"phenomenon\": \"a\u{202e}\" }";
    let run = run_in(&here, &["fmt", "--diff", "-"], deceiving);
    assert!(run.output.contains(&format!("-{deceiving}")), "{run:?}");
    let run = run_in(&here, &["fmt", "--diff", "outer.json"], "");
    assert_eq!(run.code, Some(1), "{run:?}");
    assert!(run.output.starts_with("--- outer.json\n+++ outer.json\n@@ -1,"), "{run:?}");
    assert_eq!(std::fs::read_to_string(folder.path("outer.json")).unwrap(), OUTER);
    // What is shown is what `patch` makes of it, where there is one.
    folder.file("a.diff", &run.output);
    let patched = Command::new("patch").args(["outer.json", "a.diff"]).current_dir(&here).output();
    if patched.is_ok_and(|patched| patched.status.success()) {
        let run = run_in(&here, &["fmt", "--diff", "outer.json"], "");
        assert_eq!((run.code, run.output.as_str()), (Some(0), ""));
    }
}

#[test]
fn folders_are_formatted() {
    let folder = nested();
    let here = folder.path("");
    folder.file("package.json", r#"{"name":"foreign"}"#);
    folder.file("tsconfig.json", "{ // a comment\n}");
    let run = run_in(&here, &["fmt", "--check", "."], "");
    assert_eq!((run.code, run.output.as_str()), (Some(1), "./folder/inner.json\n./outer.json\n"));
    assert_eq!(run_in(&here, &["fmt", "."], "").code, Some(0));
    assert_eq!(run_in(&here, &["fmt", "--check", "."], "").code, Some(0));
    let foreign = std::fs::read_to_string(folder.path("package.json")).unwrap();
    assert_eq!(foreign, r#"{"name":"foreign"}"#);
    std::fs::create_dir(folder.path("empty")).unwrap();
    let run = run_in(&here, &["fmt", "empty"], "");
    was_refused(&run, &["fmt", "empty"], &["nothing to format", "empty"]);
}

#[test]
#[cfg(target_os = "linux")]
fn what_the_program_was_started_with_is_read() {
    let folder = nested();
    let run = run_in(&folder.path(""), &["eval", "/dev/stdin"], INNER);
    assert_eq!(run.code, Some(0), "{run:?}");
    for device in ["/dev/zero", "/dev/null"] {
        let run = run_in(&folder.path(""), &["eval", device], "");
        was_refused(&run, &["eval", device], &["no ordinary file but a device"]);
    }
}
