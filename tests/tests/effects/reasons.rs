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
    let never = "mix `top` never asks for its `b`: ";
    let so = "so trace_reflection `mirror` is never asked";
    let place = "(graph.json:9:";
    seen(&top(r#"{ "interface": "share" }"#)).is_off(
        Entry::Reflection,
        &[never, "`weight` is the parameter `share`, which is 0", place, so],
    );
    seen(&top("0")).is_off(Entry::Reflection, &[never, "`weight` is given as 0", so]);
    let whole = r#""top": { "type": "mix", "inputs": { "weight": { "node": "less" }, "b": [1, 0, 0],
        "a": { "node": "mirror", "output": "color" } } }"#;
    seen(whole).is_off(
        Entry::Reflection,
        &[
            "mix `top` never asks for its `a`: `weight` is 1, which one_minus `less` makes of the parameter `share`, \
             which is 0",
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
        &["select `top` never asks for its `if_true`: `condition` is the parameter `on`, which is false"],
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
        &["switch `top` never asks for its `case_0`: `index` is the parameter `which`, which is 1"],
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
        &["trace_reflection `mirror` asks for it for refraction rays alone, and none is cast"],
    );
    seen(&of("shadow")).is_off(
        Entry::Reflection,
        &["ray_switch `top` never asks for its `shadow`: the ray is of type eye"],
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
    bright.is_on(Entry::ShadowRays, &[]);
    bright.is_off(Entry::ShadowShaders, &["no material has a shadow root"]);
    bright.is_off(Entry::Environment, &["the scene has no environment"]);
    bright.is_off(
        Entry::Refraction,
        &["no graph of the scene has a node that casts refraction rays"],
    );
    let dark = written(DARK, &graph(lit), &[], options(Asking::Guarded));
    dark.is_off(Entry::LightLoops, &["the scene has no lights: light_loop `top`"]);
    dark.is_off(Entry::ShadowRays, &["the scene has no lights"]);
    let flat = LIT.replace("\"lights\"", r#""options": { "trace_depth": [0, 0, 0] }, "lights""#);
    let top = r#""top": { "type": "mix", "inputs": { "weight": 0.5, "b": { "node": "mirror", "output": "color" } } }"#;
    let flat = written(&flat, &graph(top), &[], options(Asking::Guarded));
    flat.is_off(Entry::Reflection, &["the trace depth of the scene is 0"]);
}

#[test]
fn what_shadow_roots_ask_for_waits_for_shadow_rays() {
    let top = r#""behind": { "type": "trace_probe" },
        "top": { "type": "scale", "inputs": { "input": [1, 0, 0], "factor": { "interface": "share" } } }"#;
    let shadow = r#", "shadow": { "node": "behind", "output": "color" }"#;
    let scene = written(LIT, &graph_with(top, shadow), &[], options(Asking::Guarded));
    scene.is_off(
        Entry::Probe,
        &["only the shadow root of `folds` asks for it", "no shadow ray is cast"],
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
    off.is_off(
        Entry::Coordinates,
        &["mix `top` never asks for its `b`", "so combine_color `turn` is never asked"],
    );
    let on = written(LIT, &graph(top), &[("share", 1.0)], options(Asking::Guarded));
    on.is_on(Entry::Coordinates, &["combine_color `turn`"]);
    let loops = r#""top": { "type": "sample_loop", "inputs": { "count": 7,
        "body": { "node": "mirror", "output": "color" } } }"#;
    seen(loops).is_on(Entry::SampleLoops, &["sample_loop `top` draws samples, 7 a point"]);
}
