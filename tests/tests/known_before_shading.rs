//! Counts and choices: code for their value, the same in every engine, and made anew for another.

use phenomenon_compiler::effects::Renderer;
use phenomenon_compiler::engine::{Options, Shade, Shaded, Shader, ShaderError};
use phenomenon_compiler::graph::{Binding, RootKind};
use phenomenon_compiler::state::State;
use phenomenon_compiler::testing::build::{Build, Built, every_engine};
use phenomenon_compiler::testing::mock::MockRenderer;
use phenomenon_compiler::values::Literal;

/// Noise of so many octaves, as a colour.
fn noise(octaves: Binding, kind: Binding, mut build: Build) -> Built {
    let noise = build.node("perlin_noise", &[("octaves", octaves), ("kind", kind)]);
    build.material(noise.first())
}

fn integer(value: i32) -> Binding {
    Binding::Literal(Literal::Integer(value))
}

fn points() -> Vec<State> {
    let point = |k: i32| [k as f32 * 0.37 - 3.0, k as f32 * 1.03, 7.5 - k as f32 * 0.59];
    (0..37).map(|k| State { point: point(k), ..State::default() }).collect()
}

fn shaded(shader: &Shader, renderer: &mut dyn Renderer) -> Vec<[u32; 4]> {
    let points = points();
    let mut results = vec![Shaded::default(); points.len()];
    shader.shade(RootKind::Material, &points, renderer, &mut results);
    results.iter().map(|shaded| shaded.color.map(f32::to_bits)).collect()
}

#[test]
fn every_engine_gives_the_same_bits() {
    let mut seen: Vec<Vec<[u32; 4]>> = Vec::new();
    for octaves in [1, 2, 8] {
        for kind in [0, 1] {
            let built = noise(integer(octaves), integer(kind), Build::new());
            let mut all = every_engine().into_iter().map(|options| {
                let shader = built.shader(&[], options);
                (format!("{options:?}"), shaded(&shader, &mut MockRenderer::default()))
            });
            let (_, first) = all.next().expect("there are engines");
            for (options, results) in all {
                assert_eq!(results, first, "{octaves} octaves, kind {kind}, {options}");
            }
            assert!(!seen.contains(&first), "{octaves} octaves of kind {kind} are like others");
            seen.push(first);
        }
    }
}

#[test]
fn another_value_is_other_code() {
    let name = "octaves".to_owned();
    let mut build = Build::new();
    let octaves = build.parameter(&name, Literal::Integer(1));
    let built = noise(octaves, integer(0), build);
    let of = |octaves: i32, options: Options| {
        let fresh = built.shader(&[(name.clone(), Literal::Integer(octaves))], options);
        shaded(&fresh, &mut MockRenderer::default())
    };
    for options in every_engine() {
        let mut shader = built.shader(&[], options);
        for octaves in [3, 8, 1, 1] {
            shader.set(&name, &Literal::Integer(octaves)).expect("it compiles anew");
            let now = shaded(&shader, &mut MockRenderer::default());
            assert_eq!(now, of(octaves, options), "{octaves} octaves, {options:?}");
        }
        for nonsense in [0, 9, i32::MAX, i32::MIN] {
            let refused = shader.set(&name, &Literal::Integer(nonsense));
            assert!(matches!(refused, Err(ShaderError::Specialise(_))), "{nonsense}: {refused:?}");
            let now = shaded(&shader, &mut MockRenderer::default());
            assert_eq!(now, of(1, options), "as before, {options:?}");
        }
    }
}

#[test]
fn no_node_gives_them() {
    let mut build = Build::new();
    let state = build.node("state", &[]);
    let built = noise(state.output("ray_type"), integer(0), build);
    let refused = Shader::new(built.graph, &[], Options::default());
    let told = refused.expect_err("it cannot be known").to_string();
    assert!(told.contains("`octaves` must be a known number"), "{told}");
}
