//! Graphs of any size: layers like those of the workloads `light` and `mixed`, each with numbers of its own.

use phenomenon_runtime::sampling::mixed;

/// What a layer is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layers {
    /// Ten light nodes: products, sums, a blend.
    Light,
    /// Eight nodes, half of them heavy: a direction, a sine, an exponential, a power, a hue.
    Mixed,
}

/// What comes before the layers.
const START: &str = r#"{ "phenomenon": "layers", "version": 1, "nodes": {
    "here": { "type": "state" },
    "toward_start": { "type": "normalize", "inputs": { "input": { "node": "here", "output": "normal" } } },
    "shade_start": { "type": "combine_color", "inputs": { "r": { "node": "here", "output": "time" }, "g": 0.4, "b": 0.3 } }"#;

/// Nodes of [`START`].
const START_NODES: usize = 3;

/// In a layer `@` is its number, `<` that of the layer before, and `?` a number of its own.
const LIGHT: &str = r#",
    "tinted_@": { "type": "multiply", "inputs": { "a": { "node": "shade_<" }, "b": [?, ?, ?] } },
    "lit_@": { "type": "add", "inputs": { "a": { "node": "tinted_@" }, "b": [?, ?, ?] } },
    "turned_@": { "type": "multiply", "inputs": { "a": { "node": "here", "output": "v" }, "b": ? } },
    "place_@": { "type": "add", "inputs": { "a": { "node": "turned_@" }, "b": { "node": "here", "output": "u" } } },
    "share_@": { "type": "fraction", "inputs": { "input": { "node": "place_@" } } },
    "rest_@": { "type": "one_minus", "inputs": { "input": { "node": "share_@" } } },
    "layered_@": { "type": "mix",
      "inputs": { "weight": { "node": "share_@" }, "a": { "node": "lit_@" }, "b": [?, ?, ?] } },
    "dimmed_@": { "type": "scale", "inputs": { "input": { "node": "layered_@" }, "factor": { "node": "rest_@" } } },
    "clear_@": { "type": "subtract", "inputs": { "a": { "node": "dimmed_@" }, "b": [?, ?, ?] } },
    "shade_@": { "type": "maximum", "inputs": { "a": { "node": "clear_@" }, "b": [?, ?, ?] } }"#;

const MIXED: &str = r#",
    "swirl_@": { "type": "add", "inputs": { "a": { "node": "toward_<" }, "b": [?, ?, ?] } },
    "toward_@": { "type": "normalize", "inputs": { "input": { "node": "swirl_@" } } },
    "angle_@": { "type": "dot", "inputs": { "a": { "node": "toward_@" }, "b": [?, ?, ?] } },
    "wave_@": { "type": "sine", "inputs": { "input": { "node": "angle_@" } } },
    "growth_@": { "type": "exponential", "inputs": { "input": { "node": "wave_@" } } },
    "tone_@": { "type": "power", "inputs": { "base": { "node": "growth_@" }, "exponent": ? } },
    "hue_@": { "type": "hsv_to_rgb",
      "inputs": { "hue": { "node": "wave_@" }, "saturation": ?, "value": { "node": "tone_@" } } },
    "shade_@": { "type": "mix", "inputs": { "weight": ?, "a": { "node": "shade_<" }, "b": { "node": "hue_@" } } }"#;

impl Layers {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Light, Self::Mixed];

    /// Name in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Light => "light",
            Self::Mixed => "mixed",
        }
    }

    /// A graph file of that many nodes, or of as many less as a layer has: layers are whole, and one at
    /// least.
    pub fn text(self, nodes: usize) -> String {
        let (layer, each) = match self {
            Self::Light => (LIGHT, 10),
            Self::Mixed => (MIXED, 8),
        };
        let layers = (nodes.saturating_sub(START_NODES) / each).max(1);
        let mut text = START.to_owned();
        for number in 0..layers {
            let before = number.checked_sub(1).map_or("start".to_owned(), |it| it.to_string());
            let named = layer.replace('@', &number.to_string()).replace('<', &before);
            let mut parts = named.split('?');
            text.extend(parts.next());
            for (place, part) in parts.enumerate() {
                text += &drawn(number, place).to_string();
                text += part;
            }
        }
        let last = layers - 1;
        text + &format!(
            " }},\n  \"roots\": {{ \"material\": {{ \"node\": \"shade_{last}\" }} }} }}\n"
        )
    }
}

/// A number between 0 and 1 of three digits: another for each layer and each place in it.
fn drawn(layer: usize, place: usize) -> f64 {
    (mixed((layer * 64 + place + 1) as u64) % 999 + 1) as f64 / 1000.0
}
