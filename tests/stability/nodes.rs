//! One node at many rows of numbers, in every engine.

use phenomenon_compiler::engine::jit::Generator;
use phenomenon_compiler::engine::{Engine, Options, Shade, Shaded};
use phenomenon_compiler::graph::{Binding, RootKind};
use phenomenon_compiler::state::{Field, State};
use phenomenon_compiler::testing::build::{Build, vector};
use phenomenon_compiler::testing::mock::MockRenderer;
use phenomenon_compiler::values::{Literal, Type};

/// Walk, batch, and the jit with both generators.
pub fn engines() -> [Options; 4] {
    let of = |engine, generator| Options { engine, generator, ..Options::default() };
    [
        of(Engine::Walk, None),
        of(Engine::Batch, None),
        of(Engine::Jit, Some(Generator::Native)),
        of(Engine::Jit, Some(Generator::Cranelift)),
    ]
}

/// What the numbers of a row are.
#[derive(Clone, Copy, Debug)]
pub enum Input {
    /// One number.
    Number(&'static str),
    /// Three.
    Vector(&'static str),
}

/// A node and what is asked of it.
#[derive(Debug)]
pub struct Asked<'a> {
    /// The node, in its form for numbers where it is generic.
    pub node: &'a str,
    /// The inputs that a row gives, in its order.
    pub inputs: &'a [Input],
    /// Other inputs.
    pub fixed: &'a [(&'a str, Binding)],
    /// The output.
    pub output: &'a str,
}

/// Inputs of a reflectance: light, ray, and some numbers; normal z and tangent x are fixed.
pub const LIGHT_AND_RAY: [Input; 2] = [Input::Vector("direction"), Input::Vector("ray")];

/// The normal of all reflectances.
pub fn upright() -> (&'static str, Binding) {
    ("normal", vector([0.0, 0.0, 1.0]))
}

/// The tangent of those that have one.
pub fn along_x() -> (&'static str, Binding) {
    ("tangent", vector([1.0, 0.0, 0.0]))
}

/// A choice.
pub fn choice(number: i32) -> Binding {
    Binding::Literal(Literal::Integer(number))
}

/// The fields that rows arrive in: they differ from point to point, so that nothing is folded.
const NUMBERS: [Field; 5] = [Field::U, Field::V, Field::Dist, Field::Ior, Field::IorIn];
const VECTORS: [Field; 4] = [Field::Point, Field::Direction, Field::Origin, Field::NormalGeom];

fn points(fields: &[Field], rows: &[Vec<f32>]) -> Vec<State> {
    let point = |row: &Vec<f32>| {
        let (mut state, mut rest) = (State::default(), row.as_slice());
        for field in fields {
            let (own, others) = rest.split_at(field.value_type().width());
            field.write(&mut state, &own.iter().map(|x| x.to_bits()).collect::<Vec<_>>());
            rest = others;
        }
        assert!(rest.is_empty(), "a row has more numbers than inputs");
        state
    };
    rows.iter().map(point).collect()
}

/// The output at each row: a number three times, or a vector.
///
/// # Panics
/// If engines differ, or a number is not finite.
pub fn values(asked: &Asked<'_>, rows: &[Vec<f32>]) -> Vec<[f32; 3]> {
    let mut build = Build::new();
    let state = build.node("state", &[]);
    let (mut numbers, mut vectors) = (NUMBERS.into_iter(), VECTORS.into_iter());
    let (mut fields, mut inputs) = (Vec::new(), asked.fixed.to_vec());
    for &input in asked.inputs {
        let (name, field) = match input {
            Input::Number(name) => (name, numbers.next()),
            Input::Vector(name) => (name, vectors.next()),
        };
        let field = field.expect("a field is left");
        inputs.push((name, state.output(field.name())));
        fields.push(field);
    }
    let made = build.node_of(asked.node, Type::Scalar, &inputs).output(asked.output);
    let is_vector = matches!(asked.output, "direction");
    let color = match is_vector {
        true => build.node("vector_to_color", &[("vector", made)]).first(),
        false => made,
    };
    let built = build.material(color);
    let points = points(&fields, rows);
    let mut found: Option<Vec<[f32; 3]>> = None;
    for options in engines() {
        let mut shaded = vec![Shaded::default(); points.len()];
        let shader = built.shader(&[], options);
        shader.shade(RootKind::Material, &points, &mut MockRenderer::default(), &mut shaded);
        let colors: Vec<[f32; 3]> =
            shaded.iter().map(|it| [0, 1, 2].map(|component| it.color[component])).collect();
        for (row, color) in rows.iter().zip(&colors) {
            let finite = color.iter().all(|x| x.is_finite());
            assert!(finite, "{} at {row:?} in {options:?}: {color:?}", asked.node);
        }
        let found = found.get_or_insert_with(|| colors.clone());
        let bits = |colors: &[[f32; 3]]| -> Vec<[u32; 3]> {
            colors.iter().map(|color| color.map(f32::to_bits)).collect()
        };
        assert!(bits(found) == bits(&colors), "{} differs in {options:?}", asked.node);
    }
    found.expect("there are engines")
}
