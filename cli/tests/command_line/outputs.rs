//! Nothing that exists is ever lost: outputs replace no input and no other output, and a file is
//! written whole or not at all.

#![cfg(unix)]

use std::fs;
use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::process::{Command, Stdio};

use phenomenon_runtime::film::{Film, write};

use crate::program::{Folder, Run, printed, refused, run, run_in, was_refused};

const WOOD: &str = r#"{ "phenomenon": "wood", "version": 1,
  "interface": { "grain": { "type": "texture", "default": { "texture": "wood.png" } } },
  "nodes": { "look": { "type": "texture_lookup", "inputs": { "texture": { "interface": "grain" } } } },
  "roots": { "material": { "node": "look", "output": "color" } } }"#;

const OUTER: &str = r#"{ "phenomenon": "outer", "version": 1,
  "nodes": { "inner": { "type": { "file": "wood.json" } } },
  "roots": { "material": { "node": "inner" } } }"#;

const SCENE: &str = r#"{ "scene": "all", "camera": { "position": [0, 0, 5], "look_at": [0, 0, 0], "field_of_view": 40 },
  "environment": { "image": "sky.exr" },
  "objects": [ { "mesh": "face.obj", "material": { "file": "outer.json" } } ] }"#;

const SMALL: [&str; 5] = ["--size", "4x4", "--spp", "1", "--quiet"];

/// A folder with a scene and all it uses.
fn used() -> Folder {
    let folder = Folder::new();
    let mut film = Film::new(2, 2).unwrap();
    film.set(0, 0, [0.5, 0.25, 0.125, 1.0]);
    for name in ["wood.png", "other.png", "sky.exr"] {
        write(&film, folder.path(name).as_ref(), 1.0).unwrap();
    }
    folder.file("wood.json", WOOD);
    folder.file("outer.json", OUTER);
    folder.file("scene.json", SCENE);
    folder.file("face.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder
}

/// Every file of a folder, by name.
fn contents(folder: &Folder) -> Vec<(String, Vec<u8>)> {
    let entries = fs::read_dir(folder.path("")).unwrap().map(|entry| entry.unwrap());
    let files = entries.filter(|entry| fs::metadata(entry.path()).is_ok_and(|it| it.is_file()));
    let mut contents: Vec<(String, Vec<u8>)> = files
        .map(|entry| (entry.file_name().into_string().unwrap(), fs::read(entry.path()).unwrap()))
        .collect();
    contents.sort();
    contents
}

/// Runs it in `folder`, and expects that it is refused and changes nothing.
fn kept(folder: &Folder, arguments: &[&str], parts: &[&str]) {
    let before = contents(folder);
    let run = run_in(&folder.path(""), arguments, "");
    was_refused(&run, arguments, parts);
    assert!(before == contents(folder), "{arguments:?} changed a file");
}

#[test]
fn a_rendering_replaces_nothing_it_reads() {
    let folder = used();
    symlink("wood.png", folder.path("soft.png")).unwrap();
    symlink(".", folder.path("here")).unwrap();
    fs::hard_link(folder.path("wood.png"), folder.path("hard.png")).unwrap();
    fs::hard_link(folder.path("face.obj"), folder.path("face.json")).unwrap();
    let render = |arguments: &[&str], parts: &[&str]| {
        kept(&folder, &[&["render"], arguments, &SMALL[..]].concat(), parts);
    };
    render(
        &["wood.json"],
        &["-o wood.png", "wood.png, which was read", "name another file with -o"],
    );
    for output in ["wood.png", "./wood.png", "here/wood.png", "soft.png", "hard.png"] {
        render(&["wood.json", "-o", output], &["-o", output, "wood.png, which was read"]);
        render(&["outer.json", "-o", output], &["-o", output, "wood.png, which was read"]);
        render(&["scene.json", "-o", output], &["-o", output, "wood.png, which was read"]);
    }
    for stats in ["wood.json", "outer.json", "./here/wood.json", "wood.png"] {
        render(&["outer.json", "-o", "a.png", "--stats", stats], &["--stats", stats, "was read"]);
    }
    for stats in ["scene.json", "outer.json", "wood.json", "face.obj", "face.json", "sky.exr"] {
        render(&["scene.json", "-o", "a.png", "--stats", stats], &["--stats", stats, "was read"]);
    }
    render(&["scene.json", "-o", "sky.exr"], &["-o sky.exr", "which was read"]);
}

#[test]
fn a_name_that_was_not_chosen_costs_no_file() {
    let folder = used();
    let render = |arguments: &[&str]| {
        run_in(&folder.path(""), &[&["render"], arguments, &SMALL[..]].concat(), "")
    };
    // Nothing reads it, but it is there.
    for photograph in [&b"a photograph"[..], &fs::read(folder.path("other.png")).unwrap()] {
        folder.file("outer.png", photograph);
        let parts = ["outer.png exists", "-o outer.png"];
        kept(&folder, &[&["render", "outer.json"], &SMALL[..]].concat(), &parts);
    }
    // Where the name is chosen it is replaced; by such a picture it is not replaced unasked.
    assert_eq!(render(&["outer.json", "-o", "outer.png"]).code, Some(0));
    assert_eq!(render(&["outer.json"]).code, Some(2));
    fs::remove_file(folder.path("outer.png")).unwrap();
    // The next picture of the same name takes the place of the one before.
    assert_eq!(render(&["outer.json"]).code, Some(0));
    let first = fs::read(folder.path("outer.png")).unwrap();
    assert_eq!(render(&["outer.json", "--seed", "1"]).code, Some(0));
    assert_eq!(render(&["outer.json"]).code, Some(0));
    assert!(first == fs::read(folder.path("outer.png")).unwrap());
    let (named, chosen) = (folder.path("outer.png"), folder.path("chosen.png"));
    assert_eq!(render(&["outer.json", "-o", "chosen.png"]).code, Some(0));
    printed(&["compare", &named, &chosen, "--tolerance", "0"]);
}

#[test]
fn no_output_replaces_another() {
    let folder = used();
    symlink(".", folder.path("here")).unwrap();
    symlink("a.png", folder.path("dangling")).unwrap();
    for stats in ["a.png", "./a.png", "here/a.png", "dangling"] {
        let arguments = ["render", "wood.json", "-o", "a.png", "--stats", stats];
        kept(&folder, &[&arguments, &SMALL[..]].concat(), &["-o a.png", stats, "the same file"]);
    }
    let run = run_in(
        &folder.path(""),
        &[&["render", "wood.json", "-o", "a.png", "--stats", "a.json"], &SMALL[..]].concat(),
        "",
    );
    assert_eq!(run.code, Some(0), "{run:?}");
    // What holds nothing cannot be lost.
    let both = ["render", "wood.json", "-o", "a.png", "--stats", "/dev/null"];
    assert_eq!(run_in(&folder.path(""), &[&both, &SMALL[..]].concat(), "").code, Some(0));
}

#[test]
fn other_commands_replace_nothing_they_read() {
    let folder = used();
    for (file, name) in [("wood.json", "wood.svg"), ("wood.json", "inner.dot")] {
        fs::hard_link(folder.path(file), folder.path(name)).unwrap();
    }
    kept(&folder, &["show", "wood.json", "-o", "wood.svg"], &["-o wood.svg", "wood.json"]);
    kept(&folder, &["show", "outer.json", "-o", "inner.dot"], &["-o inner.dot", "wood.json"]);
    for output in ["wood.png", "./other.png"] {
        let arguments = ["compare", "wood.png", "other.png", "-o", output];
        kept(&folder, &arguments, &["-o", output, "which was read"]);
    }
    fs::hard_link(folder.path("wood.json"), folder.path("render.json")).unwrap();
    let arguments = ["bench", "render", "wood.json", "-o", ".", "--runs", "1"];
    kept(&folder, &arguments, &["render.json", "no result"]);
    // Only a result takes the place of a result.
    let bench = |output: &str| {
        let arguments = ["bench", "render", "wood.json", "-o", output, "--runs", "1"];
        run_in(&folder.path(""), &[&arguments, &SMALL[..4]].concat(), "").code
    };
    assert_eq!([bench("new"), bench("new"), bench(".")], [Some(0), Some(0), Some(2)]);
    folder.file("new/render.json", r#"{ "version": 1, "rows": [], "phenomenon": "a" }"#);
    assert_eq!(bench("new"), Some(2));
}

/// Runs it under a limit of the size of files, with the signal left as it is or ignored.
fn limited(folder: &Folder, ignored: bool, arguments: &[&str]) -> Run {
    let trap = if ignored { "trap '' XFSZ; " } else { "" };
    let mut command = Command::new("sh");
    command.arg("-c").arg(format!("{trap}ulimit -f 2; exec \"$0\" \"$@\""));
    command.arg(env!("CARGO_BIN_EXE_phenomenon")).args(arguments);
    command.current_dir(folder.path("")).stdin(Stdio::null());
    let output = command.output().unwrap();
    Run {
        code: output.status.code(),
        output: String::from_utf8(output.stdout).unwrap(),
        complaint: String::from_utf8(output.stderr).unwrap(),
    }
}

#[test]
fn a_file_that_does_not_fit_leaves_the_old_one() {
    let folder = used();
    let nodes: Vec<String> = (0..200)
        .map(|at| format!(r#""n{at}": {{ "type": "add", "inputs": {{"a": 1, "b": 2}} }}"#))
        .collect();
    let big = format!(
        r#"{{ "phenomenon": "big", "version": 1, "nodes": {{ {} }}, "roots": {{ "material": {{ "node": "n0" }} }} }}"#,
        nodes.join(",")
    );
    folder.file("big.json", &big);
    let doc = "long ".repeat(1_000);
    let misspelt = format!(
        r#"{{ "phenomenon": "a", "version": 1, "doc": "{doc}",
             "nodes": {{ "n": {{ "type": "mxi" }} }}, "roots": {{ "material": {{ "node": "n" }} }} }}"#
    );
    folder.file("misspelt.json", misspelt);
    folder.file("a.exr", "old");
    folder.file("a.svg", "old");
    folder.file("a.dot", "old");
    let before = contents(&folder);
    let render = ["render", "wood.json", "-o", "a.exr", "--size", "64x64", "--spp", "1", "--quiet"];
    for arguments in [
        &["fmt", "big.json"][..],
        &["check", "--fix", "misspelt.json"],
        &render,
        &["show", "big.json", "-o", "a.svg"],
        &["show", "big.json", "-o", "a.dot"],
    ] {
        for ignored in [false, true] {
            let run = limited(&folder, ignored, arguments);
            was_refused(&run, arguments, &["file size limit", "ulimit -f"]);
            assert!(before == contents(&folder), "{arguments:?} changed a file");
        }
    }
    // A small file fits, and is formatted whatever happens to the others.
    let run = limited(&folder, false, &["fmt", "big.json", "outer.json"]);
    assert_eq!(run.code, Some(2), "{run:?}");
    assert_eq!(fs::read_to_string(folder.path("big.json")).unwrap(), big);
    assert_eq!(limited(&folder, false, &["fmt", "--check", "outer.json"]).code, Some(0));
}

#[test]
fn links_and_permissions_stay() {
    let folder = Folder::new();
    fs::create_dir(folder.path("inner")).unwrap();
    let target = folder.file("inner/a.json", OUTER);
    fs::set_permissions(&target, fs::Permissions::from_mode(0o640)).unwrap();
    let link = folder.path("link.json");
    symlink("inner/a.json", &link).unwrap();
    printed(&["fmt", &link]);
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert_ne!(fs::read_to_string(&target).unwrap(), OUTER);
    assert_eq!(fs::metadata(&target).unwrap().permissions().mode() & 0o777, 0o640);
    assert_eq!(fs::read_dir(folder.path("inner")).unwrap().count(), 1);
}

#[test]
fn a_file_named_twice_is_formatted_once() {
    let folder = Folder::new();
    folder.file("a.json", OUTER);
    symlink("a.json", folder.path("link.json")).unwrap();
    let arguments = ["fmt", "--check", "a.json", "./a.json", "link.json", "."];
    let run = run_in(&folder.path(""), &arguments, "");
    assert_eq!((run.code, run.output.as_str()), (Some(1), "a.json\n"));
}

fn pipe(folder: &Folder, name: &str) -> String {
    let path = folder.path(name);
    assert!(Command::new("mkfifo").arg(&path).status().unwrap().success());
    path
}

/// None of these returns where a pipe is opened.
#[test]
fn a_pipe_is_never_waited_for() {
    let folder = used();
    let json = pipe(&folder, "pipe.json");
    let (png, exr) = (pipe(&folder, "pipe.png"), pipe(&folder, "pipe.exr"));
    let svg = pipe(&folder, "pipe.svg");
    for arguments in [
        &["fmt", &json][..],
        &["eval", &json],
        &["show", &json, "-o", "/dev/null"],
        &["render", &json, "-o", "/tmp/a.png"],
        &["bench", "render", &json],
    ] {
        let run = run(arguments);
        assert_eq!(run.code, Some(2), "{run:?}");
    }
    let check = run(&["check", &json]);
    assert_eq!(check.code, Some(2), "{check:?}");
    assert!(check.output.contains("no ordinary file but a pipe"), "{check:?}");
    let wood = folder.path("wood.json");
    let picture = folder.path("wood.png");
    refused(&["compare", &png, &picture], &["pipe.png", "but a pipe"]);
    refused(&["compare", &picture, &exr], &["pipe.exr", "but a pipe"]);
    refused(&["compare", &picture, &picture, "-o", &png], &["-o", "pipe.png", "but a pipe"]);
    refused(&["show", &wood, "-o", &svg], &["-o", "pipe.svg", "but a pipe"]);
    refused(&["render", &wood, "-o", &png], &["-o", "pipe.png", "but a pipe"]);
    refused(&["render", &wood, "--stats", &json, "-o", "a.png"], &["--stats", "but a pipe"]);
    for (from, to) in
        [("face.obj", "pipe.obj"), ("sky.exr", "pipe.exr"), ("outer.json", "pipe.json")]
    {
        if to == "pipe.obj" {
            pipe(&folder, to);
        }
        let scene = folder.file("piped.json", SCENE.replace(from, to));
        refused(&["render", &scene, "-o", &folder.path("a.png")], &[to, "no ordinary file"]);
    }
    let textured = folder.file("textured.json", WOOD.replace("wood.png", "pipe.png"));
    refused(&["render", &textured, "-o", &folder.path("a.png")], &["pipe.png"]);
    // Met in a folder they are passed over.
    fs::remove_file(folder.path("piped.json")).unwrap();
    fs::remove_file(folder.path("textured.json")).unwrap();
    printed(&["check", &folder.path("")]);
    printed(&["fmt", &folder.path("")]);
    assert!(fs::metadata(&json).unwrap().file_type().is_fifo());
}
