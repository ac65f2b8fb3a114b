//! Huge graphs end in a result or an error, on the small stack of a test thread.

use std::time::Instant;

use phenomenon_compiler::engine::{Engine, Options, Shader, ShaderError};
use phenomenon_compiler::graph::{Binding, RootKind};
use phenomenon_compiler::specialise::{MAX_NESTED_LOOPS, SpecialiseError, expand};
use phenomenon_compiler::state::{RayType, State};
use phenomenon_compiler::testing::build::{Build, Built, color, scalar, vector};
use phenomenon_compiler::testing::differential::{Outcome, outcome};
use phenomenon_compiler::values::Type;

const ENGINES: [Engine; 3] = [Engine::Walk, Engine::Batch, Engine::Jit];

/// Points with different first coordinates, 0 and 1 among them.
fn points() -> Vec<State> {
    let state = |index: u32| {
        let mut state = State { uv: [index as f32 / 8.0, 0.5], ..State::default() };
        state.hit.instance = index;
        state
    };
    (0..9).map(state).collect()
}

/// Shades the points and reports the times.
fn shade(name: &str, built: &Built, engine: Engine) -> Outcome {
    let start = Instant::now();
    let shader = built.shader(&[], Options { engine, ..Options::default() });
    let compiled = start.elapsed();
    let found = outcome(&shader, RootKind::Material, &points());
    println!(
        "{name} in {engine:?}: compiled in {compiled:?}, shaded in {:?}",
        start.elapsed() - compiled
    );
    found
}

/// The same outcome in every engine; the walk's is returned.
fn agree(name: &str, built: &Built) -> Outcome {
    let [walk, batch, jit] = ENGINES.map(|engine| shade(name, built, engine));
    assert!(walk == batch, "{name}: walk and batch differ");
    assert!(walk == jit, "{name}: walk and jit differ");
    walk
}

fn additions(length: usize) -> Built {
    let mut build = Build::new();
    let u = build.node("state", &[]).output("u");
    let mut sum = u.clone();
    for _ in 0..length {
        sum = build.node_of("add", Type::Scalar, &[("a", u.clone()), ("b", sum)]).first();
    }
    build.material(sum)
}

/// Each mix decides per point whether to go on down the chain and whether to trace.
fn mixes_of_traces(length: usize) -> Built {
    let mut build = Build::new();
    let u = build.node("state", &[]).output("u");
    let mut mixed = color([0.25; 4]);
    for _ in 0..length {
        let trace = build.node("trace_environment", &[("direction", vector([0.0, 0.0, 1.0]))]);
        let inputs = [("weight", u.clone()), ("a", mixed), ("b", trace.first())];
        mixed = build.node("mix", &inputs).first();
    }
    build.material(mixed)
}

fn nested_scopes(depth: usize) -> Built {
    let mut build = Build::new();
    let state = build.node("state", &[]);
    let mut inner: Binding = build.node("trace_reflection", &[]).first();
    for _ in 0..depth {
        let sum = build.node("add", &[("a", inner), ("b", state.output("dot_nd"))]);
        let inputs = [("normal", vector([0.6, 0.0, 0.8])), ("input", sum.first())];
        inner = build.node("perturb_normal", &inputs).first();
    }
    build.material(inner)
}

/// Every level holds what is below twice: inside a scope and outside.
fn doubling_scopes(levels: usize) -> Built {
    let mut build = Build::new();
    let mut inner = build.node("state", &[]).output("dot_nd");
    for _ in 0..levels {
        let inputs = [("normal", vector([0.6, 0.0, 0.8])), ("input", inner.clone())];
        let bent = build.node("perturb_normal", &inputs);
        inner = build.node("add", &[("a", inner), ("b", bent.first())]).first();
    }
    build.material(inner)
}

#[test]
fn a_hundred_thousand_additions() {
    let found = agree("100,000 additions", &additions(100_000));
    assert_eq!(found.results[0].0[0], 0.0_f32.to_bits());
    assert!(found.log.is_empty());
}

#[test]
fn a_hundred_thousand_mixes_of_traces() {
    let length = 100_000;
    let built = mixes_of_traces(length);
    let walk = shade("100,000 mixes", &built, Engine::Walk);
    // Weight 0 goes down the chain and traces nothing, weight 1 stops at the first trace.
    assert_eq!(walk.log.len(), 7 * length + 1);
    assert!(walk == shade("100,000 mixes", &built, Engine::Batch));
    agree("3,000 mixes", &mixes_of_traces(3_000));
}

#[test]
fn scopes_in_scopes() {
    let found = agree("200 nested scopes", &nested_scopes(200));
    assert_eq!(found.log.len(), points().len());
    agree("5,000 nested scopes", &nested_scopes(5_000));
}

/// Names kept whole would take the square of the depth in memory, and more where scopes double.
#[test]
fn names_in_deep_nests_stay_short() {
    let built = nested_scopes(2_000);
    let root = &built.graph.roots[0];
    let specialised = expand(&built.graph, root, RayType::Eye, &[]).expect("fits");
    let longest = specialised.instances.values().map(|instance| instance.name.len()).max();
    assert!(longest < Some(300), "{longest:?}");
}

#[test]
fn scopes_that_double_end_in_an_error() {
    for (levels, engine) in [(25, Engine::Walk), (200, Engine::Batch)] {
        let built = doubling_scopes(levels);
        let start = Instant::now();
        let options = Options { engine, ..Options::default() };
        let graph = built.graph.clone();
        let found = Shader::new(graph, &[], options);
        println!("{levels} doublings in {engine:?}: {:?}", start.elapsed());
        assert!(
            matches!(found, Err(ShaderError::Specialise(SpecialiseError::TooManyInstances { .. }))),
            "{levels} levels, {engine:?}: {found:?}"
        );
    }
    agree("10 doublings", &doubling_scopes(10));
}

/// Loops in loops, each under a normal that the light of the one outside gives.
fn nested_loops(levels: usize) -> Built {
    let mut build = Build::new();
    let light = build.node("light", &[]);
    let mut body = build.node("lambert", &[]).first();
    for level in 1..=levels {
        let sum = build.node("light_loop", &[("body", body.clone())]).first();
        if level == levels {
            return build.material(sum);
        }
        let inputs = [("normal", light.output("direction")), ("input", sum)];
        body = build.node("perturb_normal", &inputs).first();
    }
    build.material(body)
}

#[test]
fn loops_in_loops_end_in_an_error_before_they_never_end() {
    agree("as many loops as may be", &nested_loops(MAX_NESTED_LOOPS));
    let built = nested_loops(MAX_NESTED_LOOPS + 1);
    let found = Shader::new(built.graph, &[], Options::default());
    assert!(
        matches!(found, Err(ShaderError::Specialise(SpecialiseError::TooManyLoops { .. }))),
        "{found:?}"
    );
}

#[test]
fn a_graph_of_one_literal() {
    let build = Build::new();
    let found = agree("a literal", &build.material(scalar(0.5)));
    let half = 0.5_f32.to_bits();
    assert_eq!(found.results[3], ([half, half, half, 1.0_f32.to_bits()], true));
}
