//! Wrong usage, help, and pipes that close.

use std::fs::File;
use std::process::Stdio;

use crate::program::{printed, program, refused, run};

#[test]
fn help_lists_the_commands_and_exit_codes() {
    let help = printed(&["--help"]);
    for part in ["check", "compare", "eval", "nodes", "Exit codes:"] {
        assert!(help.contains(part), "{help}");
    }
    for command in ["check", "compare", "eval", "nodes"] {
        let help = printed(&[command, "--help"]);
        assert!(help.contains("Examples:"), "{help}");
    }
    assert!(printed(&["--version"]).starts_with("phenomenon "));
}

#[test]
fn wrong_usage_exits_with_2() {
    refused(&[], &["Usage:"]);
    refused(&["rendre"], &["rendre"]);
    refused(&["nodes", "--colour"], &["--colour"]);
    refused(&["nodes", "--format", "xml"], &["--format", "xml", "human", "json"]);
    refused(&["compare", "a.png"], &["<B>"]);
    refused(
        &["compare", "a.png", "b.png", "--tolerance", "NaN"],
        &["--tolerance", "NaN", "finite"],
    );
    refused(
        &["compare", "a.png", "b.png", "--tolerance", "-1"],
        &["--tolerance", "-1", "0 or more"],
    );
    refused(&["compare", "a.png", "b.png", "-o", "d.gif"], &["-o", "d.gif", ".png, .exr or .hdr"]);
    refused(&["eval", "g.json", "--batch", "0"], &["--batch", "'0'", "1 to 65536"]);
    refused(&["eval", "g.json", "--engine", "gpu"], &["--engine", "gpu", "walk"]);
    refused(&["eval", "g.json", "--precision", "reference"], &["--precision", "standard"]);
    refused(&["eval", "g.json", "--set", "ior"], &["--set", "'ior'", "NAME=VALUE"]);
}

#[test]
fn a_closed_pipe_is_quiet() {
    let mut command = program(&["nodes", "--format", "json"]);
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the program starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("the program ends");
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    assert_eq!(output.status.code(), Some(0));
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_is_reported() {
    let mut command = program(&["nodes"]);
    command.stdout(File::create("/dev/full").expect("Linux has /dev/full"));
    let output = command.stderr(Stdio::piped()).output().expect("the program starts");
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(complaint.contains("cannot write to standard output"), "{complaint}");
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn paths_need_not_be_text() {
    use std::os::unix::ffi::OsStrExt;
    let name = std::ffi::OsStr::from_bytes(b"\xff.png");
    let mut command = program(&["compare"]);
    let output = command.arg(name).arg(name).output().expect("the program starts");
    assert_eq!(output.status.code(), Some(2));
    assert!(!String::from_utf8_lossy(&output.stderr).contains("panicked"));
    assert_eq!(run(&["compare", "", ""]).code, Some(2));
}

#[test]
fn a_number_of_the_right_form_and_the_wrong_size_gets_no_advice_on_form() {
    let refusal = run(&["compare", "a.png", "b.png", "--tolerance=-1"]);
    assert_eq!(refusal.code, Some(2));
    assert!(refusal.complaint.contains("0 or more"), "{}", refusal.complaint);
    assert!(!refusal.complaint.contains("write -1"), "{}", refusal.complaint);
    let refusal = run(&["compare", "a.png", "b.png", "--tolerance=.5"]);
    assert!(refusal.complaint.contains("write 0.5"), "{}", refusal.complaint);
}
