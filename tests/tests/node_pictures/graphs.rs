//! A graph for every node: made of its signature, with a few words where that says too little.

use phenomenon_compiler::nodes::{DefaultValue, Input, Output, Signature};
use phenomenon_compiler::state::Field;
use phenomenon_compiler::values::Type;
use serde_json::{Map, Value, json};

use super::stages::{Drawing, Stage};

/// Inputs that show more than their defaults do, by node and input.
const GIVEN: &[(&str, &str, &str)] = &[
    ("gradient_noise", "amplitude", "0.5"),
    ("gradient_noise", "pivot", "0.5"),
    ("fractal_noise", "amplitude", "0.5"),
    ("fractal_noise", "pivot", "0.5"),
    ("fractal_noise", "octaves", "5"),
    ("random_scalar", "input", r#"{ "node": "stripes", "output": "number" }"#),
    ("random_color", "input", r#"{ "node": "stripes", "output": "number" }"#),
    ("flakes", "size", "0.35"),
    ("circle", "center", "[0.5, 0.5, 0]"),
    ("circle", "radius", "0.4"),
    ("cloverleaf", "center", "[0.5, 0.5, 0]"),
    ("cloverleaf", "radius", "0.4"),
    ("hexagon", "center", "[0.5, 0.5, 0]"),
    ("hexagon", "radius", "0.4"),
    ("ramp4", "top_left", "[0.9, 0.2, 0.1]"),
    ("ramp4", "top_right", "[0.9, 0.8, 0.2]"),
    ("ramp4", "bottom_left", "[0.05, 0.1, 0.5]"),
    ("ramp4", "bottom_right", "[0.1, 0.6, 0.4]"),
    ("ramp", "values", "[[0.02, 0.02, 0.1], [0.6, 0.05, 0.15], [0.95, 0.6, 0.1], [1, 1, 0.85]]"),
    ("gradient", "shape", r#""radial""#),
    ("tiled_shapes", "shape", r#""hexagon""#),
    ("tiled_shapes", "staggered", "true"),
    ("tiled_shapes", "size", "0.85"),
    ("hexagon_tiles", "frequency", "5"),
    ("ramp_segment", "input", r#"{ "node": "here", "output": "u" }"#),
    ("texture_lookup", "texture", r#"{ "texture": "tiles.png" }"#),
    ("latlong_projection", "direction", r#"{ "node": "here", "output": "normal" }"#),
    ("place_2d", "scale", "[0.5, 0.5, 1]"),
    ("place_2d", "rotate", "0.4"),
    ("triplanar_blend", "x", "[0.9, 0.15, 0.1]"),
    ("triplanar_blend", "y", "[0.2, 0.75, 0.15]"),
    ("triplanar_blend", "z", "[0.1, 0.25, 0.9]"),
    ("hex_tile_blend", "weights", r#"{ "node": "hexes", "output": "weights" }"#),
    ("hex_tile_blend", "first", "[0.9, 0.15, 0.1]"),
    ("hex_tile_blend", "second", "[0.2, 0.75, 0.15]"),
    ("hex_tile_blend", "third", "[0.1, 0.25, 0.9]"),
    ("slope", "there", r#"{ "node": "here", "output": "u" }"#),
    ("slope", "step", "1"),
    ("bump_normal", "height", r#"{ "node": "bumps" }"#),
    ("bump_normal", "scale", "0.1"),
    ("blackbody", "temperature", r#"{ "node": "kelvin" }"#),
    ("wavelength_to_color", "wavelength", r#"{ "node": "nanometres" }"#),
    ("hsl_to_rgb", "hue", r#"{ "node": "here", "output": "u" }"#),
    ("hsl_to_rgb", "lightness", r#"{ "node": "here", "output": "v" }"#),
    ("hsv_to_rgb", "hue", r#"{ "node": "here", "output": "u" }"#),
    ("hsv_to_rgb", "value", r#"{ "node": "here", "output": "v" }"#),
    ("combine_color", "r", r#"{ "node": "here", "output": "u" }"#),
    ("combine_color", "g", r#"{ "node": "here", "output": "v" }"#),
    ("combine_color", "b", "0.4"),
    ("adjust_hsv", "hue", "0.35"),
    ("color_correct", "hue", "0.5"),
    ("color_correct", "saturation", "0.6"),
    ("color_correct", "contrast", "1.5"),
    ("contrast", "amount", "2.5"),
    ("exposure", "stops", "1.2"),
    ("gamma", "gamma", "2.2"),
    ("saturation", "amount", "0.25"),
    ("overlay", "base", r#"{ "node": "sunset" }"#),
    ("overlay", "layer", r#"{ "node": "spectrum" }"#),
    ("blinn", "ior", "8"),
    ("torrance_sparrow", "ior", "8"),
    ("ggx", "f0", "[0.75, 0.3, 0.12]"),
    ("ggx", "roughness_u", "0.35"),
    ("ggx", "roughness_v", "0.35"),
    ("ashikhmin_shirley", "specular", "[0.4, 0.4, 0.4]"),
    ("ashikhmin_shirley", "diffuse", "[0.75, 0.3, 0.12]"),
];

/// Nodes that change a colour: above is the colour before, and below what they make of it.
const CHANGES: [&str; 9] = [
    "adjust_hsv",
    "color_correct",
    "contrast",
    "decode_color",
    "exposure",
    "gamma",
    "linear_to_srgb",
    "saturation",
    "srgb_to_linear",
];

/// Outputs that show more than the first does.
const SHOWN: &[(&str, &str)] = &[
    ("cell_noise", "color"),
    ("worley_noise", "f1"),
    ("hexagon_tiles", "color"),
    ("flakes", "random"),
    ("hex_tile_places", "weights"),
];

/// The graph that shows a node.
pub fn drawing(signature: &Signature) -> Drawing {
    let stage = stage(signature);
    let mut nodes = surroundings();
    let mut inputs = Map::new();
    let mut values = 0;
    for input in &signature.inputs {
        if let Some(value) = given(signature, input, stage, &mut values) {
            inputs.insert(input.name.to_string(), value);
        }
    }
    let output = shown(signature);
    nodes.insert("node".into(), json!({ "type": &*signature.name, "inputs": inputs }));
    let value = json!({ "node": "node", "output": &*output.name });
    let color = colored(&mut nodes, signature, value, output);
    let graph = json!({
        "phenomenon": "picture", "version": 1, "nodes": nodes, "roots": { "material": color },
    });
    Drawing { graph, stage }
}

/// What shows a node: shading and what lays pictures round things, a sphere.
fn stage(signature: &Signature) -> Stage {
    let round = [Field::Point, Field::Normal, Field::Direction];
    let is_round = |input: &Input| {
        round.iter().any(|field| matches!(input.default, DefaultValue::State(at) if at == *field))
    };
    match signature.group {
        "shading" => Stage::Sphere,
        "textures" if signature.inputs.iter().any(is_round) => Stage::Sphere,
        _ => Stage::Square,
    }
}

/// Nodes that give the node something to work on; those it does not take are never evaluated.
fn surroundings() -> Map<String, Value> {
    let nodes = json!({
        "here": { "type": "state" },
        "scaled": { "type": "scale", "inputs": { "input": { "node": "here", "output": "point" }, "factor": 5 } },
        "place": { "type": "add", "inputs": { "a": { "node": "scaled" }, "b": [40.3, 0.4, 7.2] } },
        "stripes": { "type": "stripes" },
        "hexes": { "type": "hex_tile_places" },
        "across": { "type": "combine_vector", "inputs": { "x": { "node": "here", "output": "u" }, "y": { "node": "here", "output": "v" } } },
        "fine": { "type": "scale", "inputs": { "input": { "node": "across" }, "factor": 12 } },
        "bumps": { "type": "gradient_noise", "inputs": { "position": { "node": "fine" }, "dimensions": 2 } },
        "kelvin": { "type": "mix", "inputs": { "weight": { "node": "here", "output": "u" }, "a": 1700, "b": 12000 } },
        "nanometres": { "type": "mix", "inputs": { "weight": { "node": "here", "output": "u" }, "a": 380, "b": 720 } },
        "spectrum": { "type": "hsv_to_rgb", "inputs": { "hue": { "node": "here", "output": "u" } } },
        "sunset": { "type": "mix", "inputs": { "weight": { "node": "here", "output": "v" },
            "a": [0.05, 0.1, 0.3], "b": [1, 0.75, 0.3] } },
        "muted": { "type": "mix", "inputs": { "weight": 0.6, "a": { "node": "spectrum" }, "b": 0.2 } },
    });
    nodes.as_object().expect("an object").clone()
}

/// What an input is given; none where its default does.
fn given(signature: &Signature, input: &Input, stage: Stage, values: &mut usize) -> Option<Value> {
    let words =
        GIVEN.iter().find(|(node, name, _)| signature.name == **node && input.name == **name);
    if let Some((.., text)) = words {
        return Some(serde_json::from_str(text).expect("JSON"));
    }
    if input.list {
        return Some(match &*input.name {
            "positions" => json!([0.05, 0.35, 0.7, 0.95]),
            _ => json!([0.0, 0.85, 0.3, 1.0]),
        });
    }
    let is_color = matches!(input.value_type, Type::Color | Type::Generic);
    if signature.group == "shading" && input.name == "color" {
        return Some(json!([0.75, 0.3, 0.12]));
    }
    if CHANGES.contains(&&*signature.name) && is_color {
        return Some(json!({ "node": "muted" }));
    }
    if signature.group == "color" && is_color {
        *values += 1;
        return Some(json!({ "node": if *values == 1 { "spectrum" } else { "sunset" } }));
    }
    match (&input.default, input.value_type) {
        (DefaultValue::State(Field::Point), Type::Vector) if matches!(stage, Stage::Square) => {
            Some(json!({ "node": "place" }))
        }
        (DefaultValue::Required, Type::Scalar) => Some(json!({ "node": "here", "output": "u" })),
        _ => None,
    }
}

/// The output that is shown.
fn shown(signature: &Signature) -> &Output {
    let named = SHOWN.iter().find(|(node, _)| signature.name == **node);
    let output = match named {
        Some((_, name)) => signature.outputs.iter().find(|output| output.name == *name),
        None => signature.outputs.first(),
    };
    output.expect("a node has outputs")
}

/// A value as a colour: under the lights for shading, below the colour before it for what changes one, a vector by its components, what is as often below
/// zero as above with zero in the middle.
fn colored(
    nodes: &mut Map<String, Value>,
    signature: &Signature,
    value: Value,
    output: &Output,
) -> Value {
    let mut add = |name: &str, node: Value| {
        nodes.insert(name.into(), node);
        json!({ "node": name })
    };
    if signature.group == "shading" {
        return add("light", json!({ "type": "light_loop", "inputs": { "body": value } }));
    }
    let has = |name: &str| signature.outputs.iter().any(|output| output.name == name);
    if signature.group == "textures" && has("u") && has("v") {
        let part = |name: &str| json!({ "node": "node", "output": name });
        let inputs =
            json!({ "texture": { "texture": "tiles.png" }, "u": part("u"), "v": part("v") });
        return add("picture", json!({ "type": "texture_lookup", "inputs": inputs }));
    }
    if CHANGES.contains(&&*signature.name) {
        let inputs = json!({ "top": { "node": "muted" }, "bottom": value });
        return add("both", json!({ "type": "split_top_bottom", "inputs": inputs }));
    }
    let (low, high) = (*output.range.start(), *output.range.end());
    if output.value_type == Type::Scalar && (-10.0..0.0).contains(&low) && high == -low {
        let inputs = json!({ "input": value, "factor": 0.5 });
        let half = add("half", json!({ "type": "scale", "inputs": inputs }));
        return add("lifted", json!({ "type": "add", "inputs": { "a": half, "b": 0.5 } }));
    }
    if output.value_type != Type::Vector {
        return value;
    }
    add("parts", json!({ "type": "split_vector", "inputs": { "vector": value } }));
    let part = |name: &str| json!({ "node": "parts", "output": name });
    let inputs = json!({ "r": part("x"), "g": part("y"), "b": part("z") });
    add("color", json!({ "type": "combine_color", "inputs": inputs }))
}
