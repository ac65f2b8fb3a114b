//! The functions people know from GLSL, OSL and SeExpr, as data: which node each means, and in which order it takes its
//! arguments. Nodes have their inputs in the order of demand, which is another.

use crate::nodes::{Input, Kind, Signature};
use crate::values::Type;

/// A function.
#[derive(Debug)]
pub struct Function {
    /// What it is called by.
    pub name: &'static str,
    /// The node it means.
    pub node: &'static str,
    /// The inputs of the node that arguments without a name are given to.
    pub order: &'static [&'static str],
    /// Whether it takes two arguments or more, and is called with each in turn.
    pub folds: bool,
}

const fn function(
    name: &'static str,
    node: &'static str,
    order: &'static [&'static str],
) -> Function {
    Function { name, node, order, folds: false }
}

const ONE: &[&str] = &["input"];
const TWO: &[&str] = &["a", "b"];

/// All of them, by name.
pub static FUNCTIONS: &[Function] = &[
    function("abs", "absolute", ONE),
    function("acos", "arc_cosine", ONE),
    function("asin", "arc_sine", ONE),
    function("atan", "arc_tangent", ONE),
    function("atan2", "arc_tangent2", &["y", "x"]),
    function("cbrt", "cube_root", ONE),
    function("ceil", "ceiling", ONE),
    function("clamp", "clamp", &["input", "low", "high"]),
    function("color", "combine_color", &["r", "g", "b", "a"]),
    function("cos", "cosine", ONE),
    function("cross", "cross", TWO),
    function("degrees", "radians_to_degrees", ONE),
    function("dot", "dot", TWO),
    function("exp", "exponential", ONE),
    function("exp2", "power_of_two", ONE),
    function("faceforward", "face_forward", &["vector", "incident", "reference"]),
    function("floor", "floor", ONE),
    function("fmod", "truncated_modulo", TWO),
    function("fract", "fraction", ONE),
    function("hsv_to_rgb", "hsv_to_rgb", &["hue", "saturation", "value"]),
    function("inversesqrt", "inverse_square_root", ONE),
    function("length", "length", ONE),
    function("lerp", "mix", &["a", "b", "weight"]),
    function("log", "logarithm", ONE),
    function("log10", "logarithm10", ONE),
    function("log2", "logarithm2", ONE),
    function("luminance", "luminance", &["color"]),
    Function { name: "max", node: "maximum", order: TWO, folds: true },
    Function { name: "min", node: "minimum", order: TWO, folds: true },
    function("mix", "mix", &["a", "b", "weight"]),
    function("mod", "modulo", TWO),
    function("normalize", "normalize", ONE),
    function("pow", "power", &["base", "exponent"]),
    function("radians", "degrees_to_radians", ONE),
    function("refract", "refract", &["input", "normal", "eta"]),
    function("remap", "remap", &["input", "in_low", "in_high", "out_low", "out_high"]),
    function("saturate", "clamp", ONE),
    function("sin", "sine", ONE),
    function("smoothstep", "smooth_step", &["low", "high", "input"]),
    function("sqrt", "square_root", ONE),
    function("step", "step", &["edge", "input"]),
    function("tan", "tangent", ONE),
    function("trunc", "truncate", ONE),
    function("vector", "combine_vector", &["x", "y", "z"]),
];

/// Whether a node can be called in an expression: what it is given is evaluated once, where it stands.
pub fn is_function(signature: &Signature) -> bool {
    let is_value = |input: &Input| {
        !input.scoped && !input.list && !matches!(input.value_type, Type::Shader | Type::Lights)
    };
    let plain = matches!(signature.kind, Kind::Plain | Kind::Fields(_) | Kind::Request(_));
    plain && signature.inputs.iter().all(is_value)
}

/// The function of that name.
pub(super) fn find(name: &str) -> Option<&'static Function> {
    FUNCTIONS.iter().find(|function| function.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nodes::NodeLibrary;

    #[test]
    fn functions_are_nodes_with_those_inputs() {
        let library = NodeLibrary::standard();
        assert!(FUNCTIONS.is_sorted_by_key(|function| function.name));
        for function in FUNCTIONS {
            let Some(node) = library.find(function.node) else {
                panic!("`{}` means no node of the library", function.name)
            };
            let signature = library.signature(node);
            for input in function.order {
                assert!(signature.input(input).is_some(), "`{}` of `{}`", input, function.name);
            }
            let required = signature
                .inputs
                .iter()
                .filter(|input| matches!(input.default, crate::nodes::DefaultValue::Required));
            for input in required {
                assert!(function.order.contains(&&*input.name), "{}", function.name);
            }
            // Where both exist, the name means the node of that name.
            if library.find(function.name).is_some() {
                assert_eq!(function.name, function.node);
            }
        }
    }
}
