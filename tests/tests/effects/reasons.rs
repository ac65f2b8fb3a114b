//! A reason is the decision itself: node, input, value, and where the value comes from.

use phenomenon_compiler::specialise::Asking;
use phenomenon_runtime::render::Entry;

use crate::linking::{Scene, options, written};

/// A ball under one lamp, named `key`.
const LIT: &str = r#"{ "scene": "lit",
    "camera": { "position": [0, 0, 3], "look_at": [0, 0, 0] },
    "objects": [{ "sphere": { "radius": 1 }, "material": { "subject": true } }],
    "lights": [{ "name": "key", "point": { "position": [2, 4, 4] }, "color": [1, 1, 1], "intensity": 20 }] }"#;

/// The same ball in the dark.
const DARK: &str = r#"{ "scene": "dark",
    "camera": { "position": [0, 0, 3], "look_at": [0, 0, 0] },
    "objects": [{ "sphere": { "radius": 1 }, "material": { "subject": true } }] }"#;

/// A graph of which `top` is the material; `share` is 0 by default, and `mirror` traces a reflection.
fn graph(top: &str) -> String {
    graph_with(top, "")
}

fn graph_with(top: &str, roots: &str) -> String {
    format!(
        r#"{{ "phenomenon": "folds",
        "interface": {{ "share": {{ "type": "scalar", "default": 0, "min": 0, "max": 1 }},
            "on": {{ "type": "boolean", "default": false }},
            "which": {{ "type": "integer", "default": 1, "min": 0, "max": 3 }} }},
        "nodes": {{
            "mirror": {{ "type": "trace_reflection" }},
            "less": {{ "type": "one_minus", "inputs": {{ "input": {{ "interface": "share" }} }} }},
            "here": {{ "type": "state" }},
            {top} }},
        "roots": {{ "material": {{ "node": "top" }}{roots} }} }}"#
    )
}

fn seen(top: &str) -> Scene {
    written(LIT, &graph(top), &[], options(Asking::Guarded))
}

const MIRRORED: &str = r#"{ "node": "mirror", "output": "color" }"#;

#[test]
fn a_mix_tells_weight_parameter_and_value() {
    let top = |weight: &str| {
        let inputs = format!(r#""weight": {weight}, "a": [1, 0, 0], "b": {MIRRORED}"#);
        format!(r#""top": {{ "type": "mix", "inputs": {{ {inputs} }} }}"#)
    };
    let never = "so mix `top` (graph.json:9:";
    let so = ") never evaluates `b`, which leads to trace_reflection `mirror`";
    seen(&top(r#"{ "interface": "share" }"#))
        .is_off(Entry::Reflection, &["`share` = 0: `weight` is 0, ", never, so]);
    seen(&top("0")).is_off(Entry::Reflection, &["`weight` is given as 0, ", never, so]);
    let whole = r#""top": { "type": "mix", "inputs": { "weight": { "node": "less" }, "b": [1, 0, 0],
        "a": { "node": "mirror", "output": "color" } } }"#;
    seen(whole).is_off(
        Entry::Reflection,
        &[
            "`share` = 0: `weight`, which one_minus `less` computes, is 1, so mix `top` (graph.json:9:",
            ") never evaluates `a`",
        ],
    );
    let some = written(
        LIT,
        &graph(&top(r#"{ "interface": "share" }"#)),
        &[("share", 0.5)],
        options(Asking::Guarded),
    );
    some.is_on(Entry::Reflection, &["trace_reflection `mirror`", "the material root of `folds`"]);
    let place = some.row(Entry::Reflection).asked.as_ref().and_then(|asked| asked.place.clone());
    assert_eq!(place.expect("a place").line_column().0, 6);
}

#[test]
fn a_select_and_a_switch_tell_what_they_choose_by() {
    let select = format!(
        r#""top": {{ "type": "select", "inputs": {{ "condition": {{ "interface": "on" }},
            "if_true": {MIRRORED}, "if_false": [1, 0, 0] }} }}"#
    );
    seen(&select).is_off(
        Entry::Reflection,
        &[
            "`on` = false: `condition` is false, so select `top` (graph.json:",
            "never evaluates `if_true`",
        ],
    );
    let by_default = format!(
        r#""top": {{ "type": "select", "inputs": {{ "condition": true, "if_true": [1, 0, 0], "if_false": {MIRRORED} }} }}"#
    );
    seen(&by_default).is_off(Entry::Reflection, &["`condition` is given as true"]);
    let switch = format!(
        r#""top": {{ "type": "switch", "inputs": {{ "index": {{ "interface": "which" }},
            "case_0": {MIRRORED}, "case_1": [1, 0, 0] }} }}"#
    );
    seen(&switch).is_off(
        Entry::Reflection,
        &["`which` = 1: `index` is 1, so switch `top` (graph.json:", "never evaluates `case_0`"],
    );
}

#[test]
fn a_choice_by_ray_type_is_followed_to_the_rays_there_are() {
    let of = |key: &str| {
        format!(r#""top": {{ "type": "ray_switch", "inputs": {{ "{key}": {MIRRORED} }} }}"#)
    };
    seen(&of("eye")).is_on(Entry::Reflection, &["for rays of type eye"]);
    seen(&of("refraction")).is_off(
        Entry::Reflection,
        &["trace_reflection `mirror` is evaluated for rays of type refraction alone, and none is cast"],
    );
    seen(&of("shadow")).is_off(
        Entry::Reflection,
        &[
            "for rays of type eye, so ray_switch `top` (graph.json:",
            "never evaluates `shadow`",
            "likewise for rays of type reflection, refraction",
        ],
    );
}

#[test]
fn a_product_with_nothing_still_asks() {
    // A colour that comes back along a ray may be infinite, and 0 times that is no 0.
    let scaled = format!(
        r#""top": {{ "type": "scale", "inputs": {{ "input": {MIRRORED}, "factor": {{ "interface": "share" }} }} }}"#
    );
    seen(&scaled).is_on(Entry::Reflection, &["trace_reflection `mirror`"]);
}

#[test]
fn facts_of_the_scene_decide_as_well() {
    let lit = r#""lambert": { "type": "lambert" },
        "top": { "type": "light_loop", "inputs": { "body": { "node": "lambert" } } }"#;
    let bright = seen(lit);
    bright.is_on(Entry::LightLoops, &["light_loop `top` loops over lights"]);
    bright.is_on(Entry::ShadowRays, &["lambert `lambert`, by its default light_color, asks what"]);
    bright.is_off(Entry::ShadowShaders, &["no material has a shadow root"]);
    bright.is_off(Entry::Environment, &["the scene has no environment"]);
    bright.is_off(
        Entry::Refraction,
        &["no graph of the scene has a node that casts refraction rays"],
    );
    let dark = written(DARK, &graph(lit), &[], options(Asking::Guarded));
    dark.is_off(Entry::LightLoops, &["the scene has no lights: light_loop `top`"]);
    dark.is_off(Entry::ShadowRays, &["the scene has no lights"]);
    let top = r#""top": { "type": "mix", "inputs": { "weight": 0.5, "b": { "node": "mirror", "output": "color" } } }"#;
    for depth in ["[0, 0, 0]", "[0, 6, 6]"] {
        let options_of_scene = format!(r#""options": {{ "trace_depth": {depth} }}, "lights""#);
        let flat = LIT.replace("\"lights\"", &options_of_scene);
        let flat = written(&flat, &graph(top), &[], options(Asking::Guarded));
        flat.is_off(Entry::Reflection, &["the trace depth of the scene allows no reflection"]);
    }
}

#[test]
fn what_shadow_roots_ask_for_waits_for_shadow_rays() {
    let top = r#""behind": { "type": "trace_probe" },
        "top": { "type": "scale", "inputs": { "input": [1, 0, 0], "factor": { "interface": "share" } } }"#;
    let shadow = r#", "shadow": { "node": "behind", "output": "color" }"#;
    let scene = written(LIT, &graph_with(top, shadow), &[], options(Asking::Guarded));
    scene.is_off(
        Entry::Probe,
        &[
            "only the shadow root of `folds` evaluates trace_probe `behind`",
            "no shadow ray is cast",
        ],
    );
    scene.is_off(
        Entry::ShadowShaders,
        &["no shadow ray is cast that could meet the shadow root of `folds`"],
    );
}

#[test]
fn fields_and_loops_over_samples_have_rows() {
    let top = r#""turn": { "type": "combine_color", "inputs": { "r": { "node": "here", "output": "u" }, "g": 0, "b": 0 } },
        "top": { "type": "mix", "inputs": { "weight": { "interface": "share" }, "a": [1, 0, 0], "b": { "node": "turn" } } }"#;
    let off = seen(top);
    off.is_off(Entry::Coordinates, &["never evaluates `b`, which leads to combine_color `turn`"]);
    let on = written(LIT, &graph(top), &[("share", 1.0)], options(Asking::Guarded));
    on.is_on(Entry::Coordinates, &["combine_color `turn`"]);
    let loops = r#""top": { "type": "sample_loop", "inputs": { "count": 7,
        "body": { "node": "mirror", "output": "color" } } }"#;
    seen(loops).is_on(Entry::SampleLoops, &["sample_loop `top` draws samples, 7 a point"]);
}

/// A ball and a floor, both of one graph.
const TWICE: &str = r#"{ "scene": "twice",
    "camera": { "position": [0, 0, 3], "look_at": [0, 0, 0] },
    "objects": [{ "sphere": { "radius": 1 }, "material": { "subject": true } },
        { "sphere": { "center": [0, -9, 0], "radius": 8 }, "material": { "subject": true } }] }"#;

#[test]
fn other_nodes_are_counted_once_each() {
    // Two nodes read u, one of them v as well and for two objects; a third reads v alone.
    let channels = |name: &str, r: &str, g: &str| {
        format!(
            r#""{name}": {{ "type": "combine_color", "inputs": {{ "r": {{ "node": "here", "output": "{r}" }},
            "g": {{ "node": "here", "output": "{g}" }}, "b": 0 }} }}"#
        )
    };
    let add = |a: &str, b: &str| {
        format!(
            r#"{{ "type": "add", "inputs": {{ "a": {{ "node": "{a}" }}, "b": {{ "node": "{b}" }} }} }}"#
        )
    };
    let all = [
        channels("one", "u", "v"),
        channels("two", "u", "u"),
        channels("three", "v", "v"),
        format!(r#""first": {}, "top": {}"#, add("one", "two"), add("first", "three")),
    ];
    let scene = written(TWICE, &graph(&all.join(",\n")), &[], options(Asking::Guarded));
    scene.is_on(Entry::Coordinates, &["combine_color `one` reads", "; 2 other nodes do too"]);
    let alone = seen(&channels("top", "u", "v"));
    let reason = &alone.row(Entry::Coordinates).reason;
    assert!(reason.ends_with("in the material root of `folds`"), "{reason}");
}

#[test]
fn a_reader_that_is_left_out_tells_more_than_one_that_is_not_connected() {
    let turn = |name: &str| {
        format!(
            r#""{name}": {{ "type": "combine_color", "inputs": {{ "r": {{ "node": "here", "output": "u" }}, "g": 0, "b": 0 }} }}"#
        )
    };
    let top = format!(
        r#"{}, {}, "top": {{ "type": "mix", "inputs": {{ "weight": 0, "a": [1, 0, 0], "b": {{ "node": "turn" }} }} }}"#,
        turn("alone"),
        turn("turn")
    );
    seen(&top).is_off(Entry::Coordinates, &["`weight` is given as 0", "combine_color `turn`"]);
}

#[test]
fn a_long_chain_of_dead_branches_is_told_of_in_one_pass() {
    let link = |at: usize| {
        let before = match at {
            0 => "[1, 0, 0]".to_owned(),
            at => format!(r#"{{ "node": "m{}" }}"#, at - 1),
        };
        format!(
            r#""m{at}": {{ "type": "mix", "inputs": {{ "weight": 0, "a": {before}, "b": {MIRRORED} }} }}"#
        )
    };
    let count = 30_000;
    let mut nodes: Vec<String> = (0..count).map(link).collect();
    nodes.push(format!(
        r#""top": {{ "type": "mix", "inputs": {{ "weight": 0, "a": {{ "node": "m{}" }}, "b": {MIRRORED} }} }}"#,
        count - 1
    ));
    let scene = written(DARK, &graph(&nodes.join(",\n")), &[], options(Asking::Guarded));
    scene.is_off(
        Entry::Reflection,
        &["mix `m0`", "; these and others lead to trace_reflection `mirror`"],
    );
}

#[test]
fn densities_of_lights_wait_for_an_environment_light() {
    let top = r#""weighed": { "type": "light_density", "inputs": { "direction": [0, 1, 0] } },
        "top": { "type": "scale", "inputs": { "input": [1, 0, 0], "factor": { "node": "weighed" } } }"#;
    let scene = seen(top);
    scene.is_off(Entry::LightDensities, &["no light of the scene is its environment", "`weighed`"]);
    scene.is_off(Entry::LightLoops, &["no graph of the scene has a loop over lights"]);
}
