//! `phenomenon effects`, and `render --all-effects`.

use serde_json::Value;

use crate::program::{Folder, printed, refused, run, run_in};

const GLASS: &str = "graphs/glass/advanced_glass.json";
const SMALL: [&str; 5] = ["--size", "8x8", "--spp", "1", "--no-savings"];

fn small(arguments: &[&str]) -> String {
    let all: Vec<&str> = ["effects"].iter().chain(arguments).chain(&SMALL).copied().collect();
    printed(&all)
}

/// A ledger without what it costs: `on  reflection`, and the lines below.
fn without_costs(ledger: &str) -> Vec<&str> {
    ledger
        .lines()
        .skip(1)
        .map(|line| match line.get(..5) {
            Some("on   " | "off  ") => {
                let name = line[5..].split("  ").next().unwrap_or_default();
                &line[..5 + name.len()]
            }
            _ => line,
        })
        .collect()
}

#[test]
fn a_row_names_the_node_that_asks_or_the_parameter_that_decides() {
    let ledger = small(&[GLASS]);
    assert!(ledger.contains("\non   refraction"), "{ledger}");
    assert!(ledger.contains("trace_refraction `through` casts refraction rays"), "{ledger}");
    let opaque = small(&[GLASS, "--set", "opacity=1"]);
    assert!(opaque.contains("\noff  refraction"), "{opaque}");
    let reason = "`opacity` = 1: `opacity < 1` is false, so select `let_through` (graphs/glass/advanced_glass.json:69:5) \
                  never evaluates `if_true`, which leads to trace_refraction `through`\n";
    assert!(opaque.contains(reason), "{opaque}");
}

#[test]
fn json_has_the_keys_that_are_documented() {
    let arguments =
        ["effects", GLASS, "--size", "8x8", "--spp", "1", "--format", "json", "--set", "opacity=1"];
    let ledger: Value = serde_json::from_str(&printed(&arguments)).unwrap();
    assert_eq!((&ledger["version"], &ledger["samples"]), (&1.into(), &1.into()));
    let page = include_str!("../../../docs/effects.md");
    let rows = ledger["rows"].as_array().unwrap();
    for key in rows[0].as_object().unwrap().keys() {
        assert!(page.contains(&format!("`{key}`")), "docs/effects.md lacks `{key}`");
    }
    let row = |effect: &str| rows.iter().find(|row| row["effect"] == effect).unwrap();
    let (mirror, bent) = (row("reflection"), row("refraction"));
    assert_eq!((&mirror["on"], &bent["on"]), (&true.into(), &false.into()));
    assert!(mirror["rays"].as_u64().unwrap() > 0);
    assert_eq!(bent["rays"], 0);
    assert!(bent["saved"]["count"].as_u64().unwrap() > 0, "{bent}");
    assert!(bent["all_effects"]["count"].as_u64().unwrap() > 0, "{bent}");
    assert_eq!(mirror["node"], "mirror");
    assert_eq!(mirror["place"]["file"], GLASS);
    assert_eq!(row("surface_derivatives")["rays"], Value::Null);
    assert!(ledger["all_effects"]["rays"].as_u64() > ledger["whole"]["rays"].as_u64());
}

#[test]
fn the_page_shows_what_the_command_prints() {
    let page = include_str!("../../../docs/effects.md");
    let mut shown = 0;
    for (before, rest) in
        page.match_indices("\n\n```text\n").map(|(at, fence)| page.split_at(at + fence.len()))
    {
        let command =
            before.rsplit("    phenomenon effects ").next().unwrap().lines().next().unwrap();
        let block = rest.split("```").next().unwrap();
        let arguments: Vec<&str> = command.split(' ').collect();
        assert_eq!(without_costs(block), without_costs(&small(&arguments)), "{command}");
        shown += 1;
    }
    assert_eq!(shown, 3);
}

#[test]
fn a_graph_from_standard_input_is_measured_once() {
    let folder = Folder::new();
    let graph = r#"{ "phenomenon": "red", "nodes": { "red": { "type": "constant_color" } },
        "roots": { "material": { "node": "red" } } }"#;
    let ran = run_in(
        &folder.path(""),
        &["effects", "-", "--no-savings", "--size", "4x4", "--spp", "1"],
        graph,
    );
    assert_eq!(ran.code, Some(0), "{ran:?}");
    assert!(ran.output.contains("off  reflection"), "{ran:?}");
    refused(&["effects", "-"], &["standard input can be read once", "--no-savings"]);
}

#[test]
fn what_cannot_be_measured_is_refused() {
    refused(&["effects", "no_such.json"], &["no_such.json"]);
    refused(
        &["effects", GLASS, "--set", "opactiy=1"],
        &["--set opactiy=1", "did you mean `opacity`?"],
    );
    refused(&["effects", "graphs/broken/unknown_node.json"], &["cannot be used"]);
    refused(
        &["effects", GLASS, "--engine", "monolith"],
        &["effects with --engine monolith", "walk, batch or jit"],
    );
    let all = ["render", GLASS, "--engine", "monolith", "--all-effects", "-o", "never.png"];
    refused(&all, &["--all-effects with --engine monolith"]);
}

#[test]
fn all_effects_need_every_picture() {
    let folder = Folder::new();
    let graph = folder.file(
        "unread.json",
        r#"{ "phenomenon": "unread",
        "nodes": { "read": { "type": "texture_lookup", "inputs": { "texture": { "texture": "a.png" } } },
            "top": { "type": "mix", "inputs": { "weight": 0, "a": [1, 0, 0], "b": { "node": "read" } } } },
        "roots": { "material": { "node": "top" } } }"#,
    );
    folder.file("a.png", "no picture");
    let picture = folder.path("b.png");
    let render = ["render", &graph, "--size", "8x8", "--spp", "1", "-o", &picture];
    assert_eq!(run(&render).code, Some(0), "an unread picture is not opened");
    let all: Vec<&str> = render.iter().copied().chain(["--all-effects"]).collect();
    refused(&all, &["a.png", "unread.json:2"]);
    refused(&["effects", &graph], &["with all effects on", "--no-savings"]);
    let ledger = small(&[&graph]);
    assert!(ledger.contains("`weight` is given as 0"), "{ledger}");
}

#[test]
fn a_picture_that_takes_too_many_rays_with_all_effects_on_is_given_up() {
    let few = ["effects", GLASS, "--size", "8x8", "--spp", "1", "--most-rays", "500"];
    let ledger = printed(&few);
    assert!(
        ledger.contains("not measured: with all effects on it takes more than 500 rays"),
        "{ledger}"
    );
    assert!(!ledger.contains("saves"), "{ledger}");
    let json: Vec<&str> = few.iter().copied().chain(["--format", "json"]).collect();
    let ledger: Value = serde_json::from_str(&printed(&json)).unwrap();
    assert_eq!(
        (&ledger["given_up_after_rays"], &ledger["all_effects"]),
        (&500.into(), &Value::Null)
    );
    assert_eq!(ledger["rows"][0]["saved"], Value::Null);
    assert!(ledger["whole"]["rays"].as_u64().unwrap() > 0);
}
