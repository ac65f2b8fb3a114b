//! `phenomenon check`, `explain`, `schema` and `fmt` as users run them.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use serde_json::Value;

fn phenomenon(arguments: &[&str], input: Option<&str>) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_phenomenon"))
        .args(arguments)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut pipe = child.stdin.take().unwrap();
    // A program that ends without reading closes the pipe; that is no failure.
    let _ = pipe.write_all(input.unwrap_or_default().as_bytes());
    drop(pipe);
    child.wait_with_output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[track_caller]
fn run(arguments: &[&str], input: Option<&str>, code: i32) -> String {
    let output = phenomenon(arguments, input);
    let (out, error) = (text(&output.stdout), text(&output.stderr));
    assert_eq!(output.status.code(), Some(code), "{arguments:?}\n{out}\n{error}");
    out
}

const FINE: &str = r#"{ "phenomenon": "a", "roots": { "material": [1, 0, 0] } }"#;
const WARNED: &str = r#"{ "phenomenon": "a", "interface": { "p": { "type": "scalar", "default": 1 } }, "roots": { "material": 1 } }"#;
const WRONG: &str = "{\n  \"phenomenon\": \"a\",\n  \"roots\": { \"matrial\": 1 }\n}\n";

#[test]
fn exit_codes_are_those_documented() {
    assert_eq!(run(&["check", "-"], Some(FINE), 0), "");
    run(&["check", "-"], Some(WARNED), 0);
    run(&["check", "-", "--deny", "warnings"], Some(WARNED), 1);
    run(&["check", "-", "--deny", "warnings", "--allow", "unused-parameter"], Some(WARNED), 0);
    run(&["check", "-"], Some(WRONG), 1);
    run(&["check", "-", "--allow", "unknown-root"], Some(WRONG), 2);
    run(&["check", "no/such/file.json"], None, 2);
    run(&["check"], None, 2);
    run(&["check", "-", "--allow", "no-such-code"], Some(FINE), 2);
    run(&["check", "-", "--format", "xml"], Some(FINE), 2);
    run(&["check", "graphs/mirror"], None, 0);
    run(&["check", "graphs"], None, 1);
}

#[test]
fn human_reports_show_the_place_in_the_file() {
    let report = run(&["check", "-"], Some(WRONG), 1);
    for part in [
        "error[unknown-root]",
        "there is no shader type `matrial`",
        "-:3:14",
        "did you mean `material`?",
        "1 error",
    ] {
        assert!(report.contains(part), "{part}\n{report}");
    }
    assert!(!report.contains('\u{1b}'), "no colours in a pipe");
    // Of lines too long to be read the part round the place is shown.
    let long =
        format!("{{ \"phenomenon\": \"a\", \"doc\": \"{}\", \"rots\": {{}} }}", "x".repeat(5000));
    let report = run(&["check", "-"], Some(&long), 1);
    assert!(report.contains("[-:1:5033]") && report.contains("\"rots\": {}"), "{report}");
    assert!(report.len() < 2000, "{report}");
}

#[test]
fn json_reports_have_their_keys() {
    let report = run(&["check", "--format", "json", "-"], Some(WRONG), 1);
    let report: Value = serde_json::from_str(&report).unwrap();
    assert_eq!(report["version"], 1);
    let finding = &report["findings"][0];
    assert_eq!(finding["code"], "unknown-root");
    assert_eq!(finding["severity"], "error");
    assert_eq!(finding["file"], "-");
    assert_eq!((finding["line"].as_u64(), finding["column"].as_u64()), (Some(3), Some(14)));
    assert_eq!(finding["length"], 9);
    assert_eq!(finding["path"], "roots.matrial");
    assert!(finding["message"].is_string() && finding["help"].is_string());
    assert!(finding["related"].as_array().unwrap().is_empty());
    let fine = run(&["check", "--format", "json", "-"], Some(FINE), 0);
    let fine: Value = serde_json::from_str(&fine).unwrap();
    assert_eq!(fine["findings"].as_array().unwrap().len(), 0);
}

#[test]
fn github_reports_are_workflow_commands() {
    let report = run(&["check", "--format", "github", "-"], Some(WRONG), 1);
    assert_eq!(
        report,
        "::error file=-,line=3,endLine=3,col=14,endColumn=23,title=unknown-root::there is no shader type `matrial`%0Ahelp: did you mean `material`?\n"
    );
}

#[test]
fn sarif_reports_refer_to_their_rules() {
    let report = run(&["check", "--format", "sarif", "graphs/broken"], None, 1);
    let report: Value = serde_json::from_str(&report).unwrap();
    assert_eq!(report["version"], "2.1.0");
    let run = &report["runs"][0];
    let rules = run["tool"]["driver"]["rules"].as_array().unwrap();
    let results = run["results"].as_array().unwrap();
    assert!(results.len() > 60);
    for result in results {
        let rule = &rules[result["ruleIndex"].as_u64().unwrap() as usize];
        assert_eq!(rule["id"], result["ruleId"]);
        let location = &result["locations"][0]["physicalLocation"];
        assert!(
            location["artifactLocation"]["uri"].as_str().unwrap().starts_with("graphs/broken/")
        );
        assert!(location["region"]["startLine"].as_u64().unwrap() >= 1);
        assert!(["error", "warning", "note"].contains(&result["level"].as_str().unwrap()));
    }
}

#[test]
fn at_most_a_thousand_findings_are_shown() {
    let nodes: Vec<String> =
        (0..1500).map(|at| format!("\"n{at}\": {{ \"type\": \"ad\" }}")).collect();
    let graph = format!(
        "{{ \"phenomenon\": \"a\", \"nodes\": {{ {} }}, \"roots\": {{ \"material\": 1 }} }}",
        nodes.join(",\n")
    );
    let report = run(&["check", "--format", "json", "-"], Some(&graph), 1);
    let report: Value = serde_json::from_str(&report).unwrap();
    assert_eq!(report["findings"].as_array().unwrap().len(), 1000);
    let omitted = report["omitted"].as_u64().unwrap();
    assert!(omitted >= 500);
    let report = run(&["check", "-"], Some(&graph), 1);
    assert!(report.contains(&format!("{omitted} more not shown")));
}

#[test]
fn fix_puts_sure_suggestions_in() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.json");
    let broken = "{\n  \"phenomenon\": \"a\",\n  \"nodes\": { \"é\": { \"type\": \"mxi\", \"inputs\": { \"wieght\": 0.5 } } },\n  \"roots\": { \"matrial\": { \"node\": \"é\", \"output\": \"reslut\" } }\n}\n";
    std::fs::write(&path, broken).unwrap();
    let name = path.to_str().unwrap();
    run(&["check", name], None, 1);
    assert_eq!(std::fs::read_to_string(&path).unwrap(), broken, "check alone changes nothing");
    run(&["check", "--fix", name], None, 0);
    let mended = broken
        .replace("mxi", "mix")
        .replace("wieght", "weight")
        .replace("matrial", "material")
        .replace("reslut", "result");
    assert_eq!(std::fs::read_to_string(&path).unwrap(), mended);
    run(&["check", "--fix", "-"], Some(WRONG), 2);
}

/// A fix is told, may be looked at first, and never makes a name into another that means something else.
#[test]
fn fixes_are_told_and_change_no_meaning() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.json");
    let name = path.to_str().unwrap();
    let graph = |node: &str| {
        format!(
            "{{ \"phenomenon\": \"a\",\n  \"nodes\": {{ \"here\": {{ \"type\": \"state\" }},\n    \"m\": {node} }},\n  \"roots\": {{ \"material\": {{ \"node\": \"m\" }} }} }}\n"
        )
    };
    for kept in [
        r#"{ "type": "scalar", "inputs": { "input": 2 } }"#,
        r#"{ "type": "max", "inputs": { "a": 1, "weight": 0.5 } }"#,
        r#"{ "type": "add", "inputs": { "a": { "node": "hers", "output": "point" } } }"#,
    ] {
        let broken = graph(kept);
        std::fs::write(&path, &broken).unwrap();
        let output = phenomenon(&["check", "--fix", name], None);
        assert_eq!(std::fs::read_to_string(&path).unwrap(), broken, "{}", text(&output.stderr));
        assert_eq!(output.status.code(), Some(1));
    }
    let broken = graph(r#"{ "type": "max", "inputs": { "a": 1, "in2": .5 } }"#);
    let mended = graph(r#"{ "type": "maximum", "inputs": { "a": 1, "b": 0.5 } }"#);
    std::fs::write(&path, &broken).unwrap();
    let shown = run(&["check", "--fix", "--diff", name], None, 1);
    assert!(
        shown.contains("-    \"m\": { \"type\": \"max\"") && shown.contains("\"maximum\""),
        "{shown}"
    );
    assert_eq!(std::fs::read_to_string(&path).unwrap(), broken, "shown, not written");
    run(&["check", "--diff", name], None, 2);
    let output = phenomenon(&["check", "--fix", name], None);
    let told = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{told}");
    assert_eq!(std::fs::read_to_string(&path).unwrap(), mended);
    for line in [":3:54: .5 → 0.5", ":3:20: \"max\" → \"maximum\"", ":3:51: \"in2\" → \"b\""]
    {
        assert!(told.contains(line), "{line} in\n{told}");
    }
}

#[test]
fn explain_tells_every_code() {
    let list = run(&["explain"], None, 0);
    for line in list.lines() {
        let code = line.split_whitespace().next().unwrap();
        assert!(run(&["explain", code], None, 0).starts_with(code));
    }
    assert!(list.lines().count() > 30);
    assert_eq!(phenomenon(&["explain", "cylce"], None).status.code(), Some(2));
    assert!(
        text(&phenomenon(&["explain", "cylce"], None).stderr).contains("did you mean `cycle`?")
    );
}

#[test]
fn the_schema_is_the_one_checked_in() {
    let checked_in = std::fs::read_to_string(
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../graphs/schema.json"),
    )
    .unwrap();
    assert!(run(&["schema"], None, 0) == checked_in);
}

#[test]
fn fmt_writes_the_canonical_form_once() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.json");
    let name = path.to_str().unwrap();
    std::fs::write(&path, FINE).unwrap();
    assert_eq!(run(&["fmt", "--check", name], None, 1).trim(), name);
    run(&["fmt", name], None, 0);
    assert_eq!(
        std::fs::read_to_string(&path).unwrap(),
        "{\n  \"phenomenon\": \"a\",\n  \"roots\": { \"material\": [1, 0, 0] }\n}\n"
    );
    run(&["fmt", "--check", name], None, 0);
    std::fs::write(&path, "{").unwrap();
    run(&["fmt", name], None, 2);
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "{", "what cannot be read is not written");
}

#[test]
fn scenes_are_checked_with_their_graphs() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.json");
    let graphs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../graphs").canonicalize().unwrap();
    let scene = |mirror: &str, set: &str, sky: &str| {
        let text = format!(
            r#"{{ "scene": "s", "camera": {{ "position": [0, 1, 5], "look_at": [0, 0, 0] }},
  "objects": [{{ "sphere": {{ "radius": 1 }}, "material": {{ "file": {mirror:?}, "set": {{ {set} }} }} }}],
  "environment": {{ "file": {sky:?} }} }}"#
        );
        std::fs::write(&path, text).unwrap();
    };
    let name = path.to_str().unwrap();
    let file = |name: &str| graphs.join(name).to_str().unwrap().to_owned();
    let (mirror, sky) = (file("mirror/tinted_mirror.json"), file("sky/gradient_sky.json"));
    let codes = |exit: i32| -> Vec<String> {
        let report = run(&["check", "--format", "json", name], None, exit);
        let report: Value = serde_json::from_str(&report).unwrap();
        let findings = report["findings"].as_array().unwrap();
        findings.iter().map(|finding| finding["code"].as_str().unwrap().to_owned()).collect()
    };
    scene(&mirror, "", &sky);
    assert!(codes(0).is_empty());
    scene(&mirror, "\"ior\": 99", &sky);
    assert_eq!(codes(1), ["number-out-of-range"]);
    scene(&mirror, "\"tnit\": 1", &sky);
    assert_eq!(codes(1), ["unknown-parameter"]);
    scene(&mirror, "\"ior\": [1, 2]", &sky);
    assert_eq!(codes(1), ["type-mismatch"]);
    scene(&sky, "", &mirror);
    assert_eq!(codes(1), ["missing-root", "missing-root"]);
    scene(&file("broken/cycle_of_two.json"), "", &sky);
    assert_eq!(codes(1), ["cycle"]);
    scene("nowhere.json", "", &sky);
    let report = run(&["check", name], None, 1);
    assert!(report.contains("nowhere.json"), "{report}");
    // What may surely be put in is put into the scene, and never into the graphs it uses.
    let graph = folder.path().join("lamps.json");
    let lamps = r#"{ "phenomenon": "lamps", "interface": { "lamps": { "type": "lights", "default": [{ "light": "kye" }] } },
  "nodes": { "d": { "type": "lambert" }, "l": { "type": "light_loop", "inputs": { "lights": { "interface": "lamps" }, "body": { "node": "d" } } } },
  "roots": { "material": { "node": "l" } } }"#;
    std::fs::write(&graph, lamps).unwrap();
    let scene = |set: &str| {
        format!(
            r#"{{ "scene": "s", "camera": {{ "position": [0, 1, 5], "look_at": [0, 0, 0] }}, "lights": [{{ "name": "key", "point": {{ "position": [0, 9, 0] }} }}],
  "objects": [{{ "sphere": {{ "radius": 1 }}, "material": {{ "file": "lamps.json"{set} }} }}] }}"#
        )
    };
    let broken = scene(r#", "set": { "lmaps": [{ "light": "key" }, { "light": "sun" }] }"#);
    std::fs::write(&path, &broken).unwrap();
    assert_eq!(codes(1), ["unknown-parameter"], "the default light may not have been meant");
    run(&["check", "--fix", name], None, 1);
    let mended = std::fs::read_to_string(&path).unwrap();
    assert_eq!(mended, broken.replace("lmaps", "lamps"), "the light is no matter of the name");
    let broken = scene(r#", "set": { "lamps": [{ "light": "key" }, { "light": "kye" }] }"#);
    std::fs::write(&path, &broken).unwrap();
    assert_eq!(codes(1), ["unknown-light"]);
    run(&["check", "--fix", name], None, 0);
    assert_eq!(std::fs::read_to_string(&path).unwrap(), broken.replace("kye", "key"));
    std::fs::write(&path, scene("")).unwrap();
    assert_eq!(codes(1), ["unknown-light"]);
    run(&["check", "--fix", name], None, 1);
    assert_eq!(std::fs::read_to_string(&graph).unwrap(), lamps, "another scene may have the light");
}

/// Other tools have keys `scene` and `roots` too.
#[test]
fn folders_may_hold_files_of_other_tools() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("ours.json", FINE);
    write("package.json", r#"{ "name": "phenomenon", "dependencies": { "scene": "1" } }"#);
    write("model.json", r#"{ "scene": 0, "scenes": [{ "nodes": [0] }], "nodes": [{}] }"#);
    write("jest.config.json", r#"{ "roots": ["<rootDir>/src"] }"#);
    let path = folder.path().display().to_string();
    assert_eq!(run(&["check", &path], None, 0), "");
    write("nameless.json", r#"{ "nodes": {}, "roots": { "material": 1 } }"#);
    assert!(run(&["check", &path], None, 1).contains("not-a-graph"));
}
