//! The noises against MaterialX's, at points of its generated GLSL. `noise-values.json` holds `points`
//! (uv and p) and for each noise, by the name of its definition, the components at each point.

use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::nodes::harness::numbers;
use phenomenon_compiler::values::Literal;
use serde_json::Value;

/// What one noise is here: a node, at a place, of which outputs are taken.
struct Noise<'n> {
    family: &'n str,
    dimensions: i32,
    components: usize,
    style: i32,
}

impl<'n> Noise<'n> {
    /// From a name such as `ND_worleynoise2d_vector3_style1`.
    fn named(name: &'n str) -> Option<Self> {
        let mut parts = name.strip_prefix("ND_")?.split('_');
        let (noise, of, style) = (parts.next()?, parts.next()?, parts.next());
        let (family, dimensions) = match noise.strip_suffix("2d") {
            Some(family) => (family, 2),
            None => (noise.strip_suffix("3d")?, 3),
        };
        let components = match of {
            "float" => 1,
            "vector2" => 2,
            "vector3" | "color3" => 3,
            "vector4" | "color4" => 4,
            _ => return None,
        };
        let style = style.map_or(Some(0), |style| style.strip_prefix("style")?.parse().ok())?;
        Some(Self { family, dimensions, components, style })
    }

    /// An output of a node at a position.
    fn output(&self, library: &NodeLibrary, node: &str, at: [f32; 3], output: &str) -> Vec<f32> {
        let definition = library.definition(library.find(node).expect("a node of ours"));
        let given =
            [("position", Literal::Vector(at)), ("dimensions", Literal::Integer(self.dimensions))];
        numbers(definition, &given, output)
    }

    /// Its components at a position.
    fn at(&self, library: &NodeLibrary, at: [f32; 3]) -> Option<Vec<f32>> {
        let output = |node, at, output| self.output(library, node, at, output);
        let moved = |by: [f32; 3]| std::array::from_fn(|axis| at[axis] + by[axis]);
        let (node, beside) = match (self.family, self.components) {
            ("noise", 4) => ("gradient_noise", moved([19.0, 73.0, 29.0])),
            ("noise", _) => ("gradient_noise", at),
            ("fractal", _) => ("fractal_noise", moved([19.0, 193.0, 17.0])),
            ("cellnoise", 1) => return Some(output("cell_noise", at, "result")),
            ("worleynoise", count) if self.style == 0 => {
                let distances = ["f1", "f2", "f3"].into_iter().take(count);
                return Some(distances.flat_map(|f| output("worley_noise", at, f)).collect());
            }
            ("worleynoise", 1) => return Some(output("worley_noise", at, "id")),
            ("worleynoise", _) => {
                return Some(output("worley_noise", at, "color")[..self.components].to_vec());
            }
            _ => return None,
        };
        Some(match (self.family, self.components) {
            (_, 1) => output(node, at, "result"),
            // The second of a fractal pair is a sum of its own.
            ("fractal", 2) => [output(node, at, "result"), output(node, beside, "result")].concat(),
            (_, 4) => [output(node, at, "vector"), output(node, beside, "result")].concat(),
            (_, count) => output(node, at, "vector")[..count].to_vec(),
        })
    }
}

/// The numbers of a list, rounded to 32 bits as a shader reads them.
fn list(value: &Value) -> Vec<f32> {
    let numbers = value.as_array().expect("a list");
    numbers.iter().map(|number| number.as_f64().expect("a number") as f32).collect()
}

/// Within the bound that `emit/functions/gradient_noise.rs` derives, and much nearer on the whole.
#[test]
fn noises_have_the_values_of_materialx() {
    let values: Value =
        serde_json::from_str(include_str!("noise-values.json")).expect("valid JSON");
    let library = NodeLibrary::standard();
    let points = values["points"].as_array().expect("points");
    let noises = values["values"].as_object().expect("noises");
    let (mut compared, mut off) = (0, Vec::new());
    for (name, expected) in noises {
        let noise = Noise::named(name).unwrap_or_else(|| panic!("no such noise: {name}"));
        let expected = expected.as_array().expect("values by point");
        assert_eq!(expected.len(), points.len(), "{name}");
        for (point, expected) in points.iter().zip(expected) {
            let mut at = list(if noise.dimensions == 2 { &point["uv"] } else { &point["p"] });
            at.resize(3, 0.0);
            let found = noise.at(&library, [at[0], at[1], at[2]]);
            let found = found.unwrap_or_else(|| panic!("no node for {name}"));
            let expected = list(expected);
            assert_eq!(found.len(), expected.len(), "{name}");
            for (found, expected) in found.iter().zip(&expected) {
                compared += 1;
                if (found - expected).abs() > 4e-6 {
                    off.push(format!("{name} at {at:?}: {found} for {expected}"));
                }
            }
        }
    }
    assert!(compared > 1000, "{compared}");
    assert!(off.is_empty(), "{} of {compared}:\n{}", off.len(), off.join("\n"));
}
