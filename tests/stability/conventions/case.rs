//! The table of conventions in `docs/numerics.md`, row by row, in every engine. A row of the page without an example
//! here fails, and so does an example without a row.

use std::collections::BTreeSet;
use std::path::Path;

use phenomenon_compiler::engine::{Shade, Shaded};
use phenomenon_compiler::graph::{Binding, RootKind};
use phenomenon_compiler::state::{Field, State};
use phenomenon_compiler::testing::build::{Build, scalar};
use phenomenon_compiler::testing::mock::MockRenderer;
use phenomenon_compiler::values::{Literal, Type};

#[path = "examples.rs"]
mod examples;

use examples::EXAMPLES;

const INF: f32 = f32::INFINITY;
const NAN: f32 = f32::NAN;

/// What an input is given.
#[derive(Clone, Copy, Debug)]
enum Given {
    /// Numbers that come with the point: one, or a vector.
    At(&'static [f32]),
    /// A choice or a whole number, known before.
    Whole(i32),
}

/// A row of the page, a node, its inputs, its output, and what that is.
#[derive(Debug)]
struct Example(
    &'static str,
    &'static str,
    &'static [(&'static str, Given)],
    &'static str,
    [f32; 3],
);

const fn grey(value: f32) -> [f32; 3] {
    [value; 3]
}

const UP: Given = Given::At(&[0.0, 0.0, 1.0]);

/// The state's fields that numbers come in.
const NUMBERS: [Field; 5] = [Field::U, Field::V, Field::Dist, Field::Ior, Field::IorIn];
const VECTORS: [Field; 4] = [Field::Point, Field::Direction, Field::Origin, Field::NormalGeom];

/// What the engines make of an example.
fn found(Example(_, node, given, output, _): &Example) -> Vec<[f32; 3]> {
    let mut build = Build::new();
    let made = build.node("state", &[]);
    let (mut numbers, mut vectors) = (NUMBERS.into_iter(), VECTORS.into_iter());
    let (mut state, mut inputs) = (State::default(), Vec::new());
    for &(name, given) in *given {
        let binding = match given {
            Given::Whole(number) => Binding::Literal(Literal::Integer(number)),
            Given::At(value) => {
                let field = if value.len() == 1 { numbers.next() } else { vectors.next() };
                let field = field.expect("a field is left");
                field.write(&mut state, &value.iter().map(|x| x.to_bits()).collect::<Vec<_>>());
                made.output(field.name())
            }
        };
        inputs.push((name, binding));
    }
    let result = build.node_of(node, Type::Scalar, &inputs).output(output);
    let is_vector = matches!(*node, "normalize" | "refract" | "rotate");
    let is_vector = is_vector || *output == "direction";
    let color = match is_vector {
        _ if node.contains("integer") => {
            build.node_of("add", Type::Scalar, &[("a", result), ("b", scalar(0.0))]).first()
        }
        true => build.node("vector_to_color", &[("vector", result)]).first(),
        false => result,
    };
    let built = build.material(color);
    let engines = crate::nodes::engines();
    let shade = |options| {
        let mut shaded = [Shaded::default(); 9];
        let shader = built.shader(&[], options);
        shader.shade(RootKind::Material, &[state; 9], &mut MockRenderer::default(), &mut shaded);
        [0, 1, 2].map(|at| shaded[8].color[at])
    };
    engines.map(shade).to_vec()
}

/// Equal, and a zero below 0 where one is expected; NaN is NaN.
fn same(a: f32, b: f32) -> bool {
    let signs = b != 0.0 || b.is_sign_positive() || a.is_sign_negative();
    (a == b && signs) || (a.is_nan() && b.is_nan())
}

#[test]
fn every_engine_keeps_to_the_table() {
    let mut missed = Vec::new();
    for example in EXAMPLES {
        let Example(row, node, _, _, expected) = example;
        for found in found(example) {
            // Some units in the last place, for functions.
            let near =
                |(a, b): (f32, f32)| same(a, b) || (a - b).abs() <= 8.0 * f32::EPSILON * b.abs();
            if !found.into_iter().zip(*expected).all(near) {
                missed.push(format!("{row}, {node}: {found:?} for {expected:?}"));
            }
        }
    }
    assert!(missed.is_empty(), "{}", missed.join("\n"));
}

/// First cells of the rows under a heading of the page.
fn rows_of_the_page() -> BTreeSet<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/numerics.md");
    let page = std::fs::read_to_string(path).unwrap();
    let section = page.split("\n## ").find(|section| section.starts_with("Conventions")).unwrap();
    let rows = section.lines().filter_map(|line| line.strip_prefix("| "));
    let first = rows.map(|row| row.split(" | ").next().unwrap_or_default().to_owned());
    first.filter(|cell| cell != "case" && !cell.starts_with("---")).collect()
}

#[test]
fn the_table_has_an_example_for_each_row() {
    let tried: BTreeSet<String> = EXAMPLES.iter().map(|example| example.0.to_owned()).collect();
    let told = rows_of_the_page();
    let missing: Vec<_> = told.symmetric_difference(&tried).collect();
    assert!(missing.is_empty(), "rows without an example, or the other way round: {missing:#?}");
}
