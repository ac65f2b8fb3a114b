//! A graph of nodes for each model.
//!
//! Inputs of a case arrive as fields of the state, which differ from point to point, so that nothing is folded
//! before shading. The frame is that of the file: normal z, tangent x, `wi` to the light, `wo` to the viewer.

use std::collections::BTreeMap;

use phenomenon_compiler::graph::Binding;
use phenomenon_compiler::state::Field;
use phenomenon_compiler::testing::build::{Build, Built, Made, color, scalar, vector};
use phenomenon_compiler::values::{Literal, Type};

use crate::double::Fields;
use crate::file::Case;

/// A model as a graph.
pub struct Model {
    /// The graph.
    pub built: Built,
    /// The state at a case.
    pub fields: Box<dyn Fn(&Case) -> Fields>,
    /// Numbers of a result.
    pub width: usize,
    /// Units of relative rounding by which inputs are moved: see the test.
    pub roundings: f64,
}

/// The fields that numbers arrive in.
const NUMBERS: [Field; 6] =
    [Field::U, Field::V, Field::Dist, Field::Ior, Field::IorIn, Field::RasterX];

/// What an input is made into before it is rounded.
type Conversion = fn(f64) -> f64;

fn same(value: f64) -> f64 {
    value
}

/// The roughness of Blinn's power.
fn of_exponent(n: f64) -> f64 {
    (2.0 / (n + 2.0)).sqrt()
}

fn reciprocal(value: f64) -> f64 {
    1.0 / value
}

/// A graph in the making.
struct Sheet {
    build: Build,
    state: Made,
    numbers: Vec<(&'static str, Conversion)>,
    vectors: BTreeMap<&'static str, (Field, f64)>,
}

impl Sheet {
    /// With these numbers as inputs.
    fn of(numbers: &[(&'static str, Conversion)]) -> Self {
        assert!(numbers.len() <= NUMBERS.len());
        let mut build = Build::new();
        let state = build.node("state", &[]);
        Self { build, state, numbers: numbers.to_vec(), vectors: BTreeMap::new() }
    }

    /// A number.
    fn number(&self, name: &str) -> Binding {
        let at = self.numbers.iter().position(|(known, _)| *known == name).expect("a number");
        self.state.output(NUMBERS[at].name())
    }

    /// A vector, times a factor of 1 or -1.
    fn vector(&mut self, name: &'static str, field: Field, factor: f64) -> Binding {
        self.vectors.insert(name, (field, factor));
        self.state.output(field.name())
    }

    /// A node of two directions, in the form for colours where it is generic.
    fn reflectance(&mut self, node: &str, more: &[(&str, Binding)]) -> Made {
        let direction = self.vector("wi", Field::Point, 1.0);
        let ray = self.vector("wo", Field::Direction, -1.0);
        let mut inputs =
            vec![("direction", direction), ("ray", ray), ("normal", vector([0.0, 0.0, 1.0]))];
        inputs.extend(more.iter().cloned());
        self.build.node(node, &inputs)
    }

    /// A node of one number.
    fn of_numbers(&mut self, node: &str, inputs: &[(&str, Binding)]) -> Binding {
        self.build.node_of(node, Type::Scalar, inputs).first()
    }

    /// The model whose result this is, and where it is one.
    fn yields(self, result: Binding, ok: Binding, width: usize, roundings: f64) -> Model {
        let (numbers, vectors) = (self.numbers, self.vectors);
        let fields = move |case: &Case| {
            let mut fields = Fields::new();
            for (&(name, convert), field) in numbers.iter().zip(NUMBERS) {
                fields.insert(field, vec![convert(case.input(name, 1)[0])]);
            }
            for (name, &(field, factor)) in &vectors {
                let vector = case.input(name, 3).iter().map(|component| component * factor);
                fields.insert(field, vector.collect());
            }
            fields
        };
        let built = self.build.material_where(result, ok);
        Model { built, fields: Box::new(fields), width, roundings }
    }

    fn one(self, result: Binding, roundings: f64) -> Model {
        self.yields(result, Binding::Default, 1, roundings)
    }
}

fn choice(number: i32) -> Binding {
    Binding::Literal(Literal::Integer(number))
}

fn tangent() -> (&'static str, Binding) {
    ("tangent", vector([1.0, 0.0, 0.0]))
}

/// The graph for a model; none where none is known.
pub fn model(name: &str) -> Option<Model> {
    fresnel(name)
        .or_else(|| lobes(name))
        .or_else(|| diffuse(name))
        .or_else(|| brushed(name))
        .or_else(|| others(name))
}

/// Cosine and indices are rounded once, and enter a difference of exact products. A conductor's difference of
/// squared indices is rounded three times.
fn fresnel(name: &str) -> Option<Model> {
    Some(match name {
        "fresnel_dielectric" => {
            let mut sheet = Sheet::of(&[("cos_i", same), ("n1", same), ("n2", same)]);
            let inputs = [("cosine", "cos_i"), ("ior_in", "n1"), ("ior_out", "n2")];
            let inputs = inputs.map(|(input, of)| (input, sheet.number(of)));
            let share = sheet.of_numbers("fresnel_dielectric", &inputs);
            sheet.one(share, 2.0)
        }
        "fresnel_conductor" => {
            let mut sheet = Sheet::of(&[("cos_i", same), ("n", same), ("k", same)]);
            let inputs = [("cosine", "cos_i"), ("ior", "n"), ("extinction", "k")];
            let inputs = inputs.map(|(input, of)| (input, sheet.number(of)));
            let share = sheet.of_numbers("fresnel_conductor", &inputs);
            sheet.one(share, 4.0)
        }
        "schlick_fresnel" => {
            let mut sheet = Sheet::of(&[("cos", same), ("f0", same)]);
            let inputs = [("cosine", sheet.number("cos")), ("f0", sheet.number("f0"))];
            let share = sheet.of_numbers("fresnel_schlick", &inputs);
            sheet.one(share, 2.0)
        }
        "refraction_dir" => {
            let mut sheet = Sheet::of(&[("n1", same), ("n2", same)]);
            let direction = sheet.vector("d", Field::Direction, 1.0);
            let normal = sheet.vector("n", Field::Normal, 1.0);
            let inputs = [
                ("direction", direction),
                ("normal", normal.clone()),
                ("normal_geom", normal),
                ("ior_in", sheet.number("n1")),
                ("ior_out", sheet.number("n2")),
            ];
            let bent = sheet.build.node("refraction_direction", &inputs);
            let ok = sheet.build.node("not", &[("input", bent.output("tir"))]).first();
            let numbers = sheet.components(bent.output("direction"));
            sheet.yields(numbers, ok, 3, 2.0)
        }
        "reflection_dir" => {
            let mut sheet = Sheet::of(&[]);
            let direction = sheet.vector("d", Field::Direction, 1.0);
            let normal = sheet.vector("n", Field::Normal, 1.0);
            let inputs =
                [("direction", direction), ("normal", normal.clone()), ("normal_geom", normal)];
            let mirrored = sheet.build.node("reflection_direction", &inputs).first();
            let numbers = sheet.components(mirrored);
            sheet.yields(numbers, Binding::Default, 3, 2.0)
        }
        _ => return None,
    })
}

impl Sheet {
    /// A vector as a colour.
    fn components(&mut self, vector: Binding) -> Binding {
        let split = self.build.node("split_vector", &[("vector", vector)]);
        let inputs =
            [("r", "x"), ("g", "y"), ("b", "z")].map(|(to, from)| (to, split.output(from)));
        self.build.node("combine_color", &inputs).first()
    }
}

/// Directions are rounded once, and their sum once more; its square, the squared tangent and what it is
/// multiplied or divided by each once, half of which go the other way: two units in all.
const LOBE: f64 = 2.0;

fn lobes(name: &str) -> Option<Model> {
    let phong = |kind: i32| {
        let mut sheet = Sheet::of(&[("n", same)]);
        let inputs = [("exponent", sheet.number("n")), ("kind", choice(kind))];
        let value = sheet.reflectance("phong_brdf", &inputs).first();
        sheet.one(value, LOBE)
    };
    let distribution = |kind: i32, parameter: &'static str, convert: Conversion| {
        let mut sheet = Sheet::of(&[(parameter, convert)]);
        let inputs = [("roughness", sheet.number(parameter)), ("distribution", choice(kind))];
        let value = sheet.reflectance("microfacet_distribution", &inputs).first();
        sheet.one(value, LOBE)
    };
    let indices = |sheet: &Sheet| [("ior_in", sheet.number("n1")), ("ior", sheet.number("n2"))];
    Some(match name {
        "phong_cos_n" => phong(0),
        "schlick_phong" => phong(1),
        "lewis_phong" => phong(2),
        "D_beckmann" => distribution(0, "m", same),
        "D_blinn_ellipsoid" => distribution(1, "c", same),
        // The exponent comes back from the squared roughness: one rounding more.
        "D_blinn_power" => Model { roundings: LOBE + 1.0, ..distribution(2, "n", of_exponent) },
        "D_gauss" => distribution(3, "m", same),
        "torrance_sparrow_thesis" => {
            let mut sheet = Sheet::of(&[("c", same), ("n1", same), ("n2", same)]);
            let mut inputs = vec![("eccentricity", sheet.number("c")), ("light", color([1.0; 4]))];
            inputs.extend(indices(&sheet));
            let value = sheet.reflectance("blinn", &inputs).first();
            sheet.one(value, LOBE)
        }
        "torrance_sparrow_brdf" => {
            let mut sheet = Sheet::of(&[("m", same), ("n1", same), ("n2", same)]);
            let mut inputs = vec![("roughness", sheet.number("m"))];
            inputs.extend(indices(&sheet));
            let value = sheet.reflectance("torrance_sparrow_brdf", &inputs).first();
            sheet.one(value, LOBE)
        }
        _ => return None,
    })
}

/// Angles are rounded to two units in the last place, and so are sines; sums of both signs follow.
fn diffuse(name: &str) -> Option<Model> {
    let number = match name {
        "oren_nayar_full" => 0,
        "oren_nayar_qualitative" => 1,
        "ashikhmin_shirley_diff" => {
            let mut sheet = Sheet::of(&[("rd", same), ("rs", same)]);
            let inputs = [("diffuse", sheet.number("rd")), ("specular", sheet.number("rs"))];
            let value = sheet.reflectance("ashikhmin_shirley_brdf", &inputs).output("ground");
            return Some(sheet.one(value, 4.0));
        }
        _ => return None,
    };
    let mut sheet = Sheet::of(&[("rho", same), ("sigma", same)]);
    let inputs = [
        ("color", sheet.number("rho")),
        ("sigma", sheet.number("sigma")),
        ("model", choice(number)),
    ];
    let value = sheet.reflectance("oren_nayar_brdf", &inputs).first();
    Some(sheet.one(value, 4.0))
}

fn brushed(name: &str) -> Option<Model> {
    let ward = |form: i32, [u, v]: [&'static str; 2], convert: Conversion| {
        let mut sheet = Sheet::of(&[(u, convert), (v, convert)]);
        let inputs = [
            tangent(),
            ("roughness_u", sheet.number(u)),
            ("roughness_v", sheet.number(v)),
            ("form", choice(form)),
        ];
        let value = sheet.reflectance("ward_brdf", &inputs).first();
        sheet.one(value, LOBE)
    };
    Some(match name {
        "ward_1992" => ward(0, ["ax", "ay"], same),
        "ward_duer_2006" => ward(1, ["ax", "ay"], same),
        "ward_bounded_2010" => ward(2, ["ax", "ay"], same),
        // A roughness is 1 over what is called shiny.
        "mi_ward_anisglossy" => ward(3, ["shiny_u", "shiny_v"], reciprocal),
        "ashikhmin_shirley_spec" => {
            let mut sheet = Sheet::of(&[("nu", same), ("nv", same), ("rs", same)]);
            let inputs = [
                tangent(),
                ("exponent_u", sheet.number("nu")),
                ("exponent_v", sheet.number("nv")),
                ("specular", sheet.number("rs")),
            ];
            let value = sheet.reflectance("ashikhmin_shirley_brdf", &inputs).output("coat");
            sheet.one(value, LOBE)
        }
        "schlick_1994_brdf" => {
            let mut sheet = Sheet::of(&[("r", same), ("p", same), ("f0", same)]);
            let inputs = [
                tangent(),
                ("roughness", sheet.number("r")),
                ("isotropy", sheet.number("p")),
                ("f0", sheet.number("f0")),
            ];
            let value = sheet.reflectance("schlick_anisotropic_brdf", &inputs).first();
            sheet.one(value, LOBE)
        }
        _ => return None,
    })
}

fn others(name: &str) -> Option<Model> {
    Some(match name {
        "schlick_phase" => {
            let mut sheet = Sheet::of(&[("cos", same), ("k", same)]);
            let inputs = [("cosine", sheet.number("cos")), ("k", sheet.number("k"))];
            let value = sheet.of_numbers("schlick_phase", &inputs);
            sheet.one(value, 2.0)
        }
        "hsv_to_rgb" => {
            let mut sheet = Sheet::of(&[("h", same), ("s", same), ("v", same)]);
            let inputs = [("hue", "h"), ("saturation", "s"), ("value", "v")];
            let inputs = inputs.map(|(input, of)| (input, sheet.number(of)));
            let value = sheet.build.node("hsv_to_rgb", &inputs).first();
            sheet.yields(value, Binding::Default, 3, 2.0)
        }
        "rainbow_thesis" => {
            let mut sheet = Sheet::of(&[("cos", same)]);
            let turn = [("input", sheet.number("cos"))];
            let turn = sheet.of_numbers("absolute", &turn);
            let value = sheet.build.node("hsv_to_rgb", &[("hue", turn)]).first();
            sheet.yields(value, Binding::Default, 3, 2.0)
        }
        "screen" => screen_formula(),
        "overlay_thesis" => overlay_formula(),
        "perlin_improved" => {
            let mut sheet = Sheet::of(&[("x", same), ("y", same), ("z", same)]);
            let inputs = ["x", "y", "z"].map(|of| (of, sheet.number(of)));
            let position = sheet.build.node("combine_vector", &inputs).first();
            let value = sheet.build.node("perlin_noise", &[("position", position)]).first();
            sheet.one(value, 4.0)
        }
        "glass_depth_mix" => {
            let mut sheet = Sheet::of(&[("dist", same), ("depth", same), ("opacity", same)]);
            let inputs = [("value", sheet.number("dist")), ("whole", sheet.number("depth"))];
            let share = sheet.of_numbers("ratio", &inputs);
            let inputs = [("weight", share), ("a", sheet.number("opacity")), ("b", scalar(1.0))];
            let value = sheet.of_numbers("mix", &inputs);
            sheet.one(value, 2.0)
        }
        _ => return None,
    })
}

/// `a + b - a b`: the file goes on with it above 1, where the node `screen` takes the brighter of both.
fn screen_formula() -> Model {
    let mut sheet = Sheet::of(&[("a", same), ("b", same)]);
    let both = [("a", sheet.number("a")), ("b", sheet.number("b"))];
    let sum = sheet.of_numbers("add", &both);
    let product = sheet.of_numbers("multiply", &both);
    let value = sheet.of_numbers("subtract", &[("a", sum), ("b", product)]);
    sheet.one(value, 2.0)
}

/// `i (i + 2 m (1 - i))`: the file goes on with it above 1, where the node `overlay` holds.
fn overlay_formula() -> Model {
    let mut sheet = Sheet::of(&[("i", same), ("m", same)]);
    let rest = [("input", sheet.number("i"))];
    let rest = sheet.of_numbers("one_minus", &rest);
    let twice = [("input", sheet.number("m")), ("factor", scalar(2.0))];
    let twice = sheet.of_numbers("scale", &twice);
    let share = sheet.of_numbers("multiply", &[("a", rest), ("b", twice)]);
    let sum = [("a", sheet.number("i")), ("b", share)];
    let sum = sheet.of_numbers("add", &sum);
    let value = [("a", sheet.number("i")), ("b", sum)];
    let value = sheet.of_numbers("multiply", &value);
    sheet.one(value, 2.0)
}

/// The node `screen`.
pub fn screen_node() -> Model {
    let mut sheet = Sheet::of(&[("a", same), ("b", same)]);
    let inputs = [("base", sheet.number("a")), ("layer", sheet.number("b"))];
    let value = sheet.build.node("screen", &inputs).first();
    sheet.one(value, 2.0)
}

/// The node `overlay`.
pub fn overlay_node() -> Model {
    let mut sheet = Sheet::of(&[("i", same), ("m", same)]);
    let inputs = [("base", sheet.number("i")), ("layer", sheet.number("m"))];
    let value = sheet.build.node("overlay", &inputs).first();
    sheet.one(value, 2.0)
}
