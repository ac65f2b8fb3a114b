//! `phenomenon nodes`.

use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::values::Type;
use serde_json::Value;

use crate::program::{printed, refused};

#[test]
fn the_listing_has_every_group_and_node() {
    let listing = printed(&["nodes"]);
    for group in NodeLibrary::standard().groups() {
        let group = group.name;
        assert!(listing.contains(&format!("{group}: ")), "{group}");
    }
    for (_, definition) in NodeLibrary::standard().iter() {
        let name = &*definition.signature.name;
        let lines = listing.lines().filter(|line| line.split_whitespace().next() == Some(name));
        assert_eq!(lines.count(), 1, "{name}");
    }
}

#[test]
fn a_node_is_told_in_full() {
    for (_, definition) in NodeLibrary::standard().iter() {
        let signature = &definition.signature;
        let text = printed(&["nodes", &signature.name]);
        let types = |of: Type| {
            let types = signature.types_of(of).iter().map(|of| of.name());
            types.collect::<Vec<_>>().join(" | ")
        };
        for input in &signature.inputs {
            let of = types(input.value_type);
            assert!(text.contains(&format!("  {}: {of}", input.name)), "{text}");
        }
        for output in &signature.outputs {
            let of = types(output.value_type);
            assert!(text.contains(&format!("  {}: {of}", output.name)), "{text}");
        }
    }
    let mix = printed(&["nodes", "mix"]);
    assert!(mix.starts_with("mix(weight, a, b) -> result (color)\n"), "{mix}");
    assert!(mix.contains("weight: scalar = 0.5, 0 to 1\n"), "{mix}");
}

#[test]
fn json_holds_what_the_library_holds() {
    let all: Value = serde_json::from_str(&printed(&["nodes", "--format", "json"])).unwrap();
    assert_eq!(all["version"], 1);
    let groups = all["groups"].as_array().unwrap();
    let nodes: Vec<&Value> =
        groups.iter().flat_map(|group| group["nodes"].as_array().unwrap()).collect();
    assert_eq!(nodes.len(), NodeLibrary::standard().iter().count());
    let mix: Value = serde_json::from_str(&printed(&["nodes", "mix", "--format", "json"])).unwrap();
    assert!(nodes.contains(&&mix["node"]));
    let weight = &mix["node"]["inputs"][0];
    assert_eq!(weight["name"], "weight");
    assert_eq!(
        (&weight["default"], &weight["min"], &weight["max"]),
        (&0.5.into(), &0.0.into(), &1.0.into())
    );
}

#[test]
fn a_group_is_listed_alone() {
    let listing = printed(&["nodes", "fresnel"]);
    assert!(listing.starts_with("fresnel: "), "{listing}");
    assert!(!listing.contains("arithmetic:"), "{listing}");
}

#[test]
fn an_unknown_name_gets_a_suggestion() {
    refused(&["nodes", "fresnel_reflecton"], &["`fresnel_reflecton`", "`fresnel_reflection`"]);
    refused(&["nodes", "zzzzzzzz"], &["`phenomenon nodes`"]);
    refused(&["nodes", ""], &["no node or group ``"]);
}

#[test]
fn nodes_are_found_by_words_and_by_what_others_call_them() {
    let first = |words: &[&str]| {
        let listing = printed(&[&["nodes", "--search"], words].concat());
        listing.split_whitespace().next().unwrap().to_owned()
    };
    for (words, node) in [
        (&["mix"][..], "mix"),
        (&["lerp"], "mix"),
        (&["max"], "maximum"),
        (&["pow"], "power"),
        (&["trace", "reflection"], "trace_reflection"),
        (&["trace reflection"], "trace_reflection"),
    ] {
        assert_eq!(first(words), node, "{words:?}");
    }
    let found: Value =
        serde_json::from_str(&printed(&["nodes", "--search", "lerp", "--format", "json"])).unwrap();
    assert_eq!((&found["version"], &found["nodes"][0]["name"]), (&1.into(), &"mix".into()));
    assert!(printed(&["nodes", "--search", "weight"]).contains("(input `weight`)"));
    refused(&["nodes", "--search", "zzzzzz"], &["zzzzzz", "`phenomenon nodes`"]);
    refused(&["nodes", "mix", "--search", "lerp"], &["--search"]);
    refused(&["nodes", "--search"], &["--search"]);
}

#[test]
fn a_file_is_told_as_the_node_it_is() {
    let text = printed(&["nodes", "graphs/painted/ripples.json"]);
    assert!(
        text.starts_with("ripples(trough, crest, steepness, ambient) -> color, ok, height, normal")
    );
    assert!(text.contains("  height: scalar\n      of both waves"), "{text}");
    assert!(text.contains("\nPresets\n  calm: steepness = 0.1\n"), "{text}");
    let json = printed(&["nodes", "graphs/painted/ripples.json", "--format", "json"]);
    let told: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(told["node"]["outputs"][2]["name"], "height");
    assert_eq!(told["presets"]["calm"]["steepness"], 0.1);
    refused(&["nodes", "graphs/painted/ripple.json"], &["graphs/painted/ripple.json"]);
}
