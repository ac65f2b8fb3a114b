//! Loops over samples, and every way turns become one value: in all engines, against the definition.
//! Most loops are of another crate: the standard library has means over samples only.

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::document;
use phenomenon_compiler::effects::Effect;
use phenomenon_compiler::graph::Binding;
use phenomenon_compiler::state::State;
use phenomenon_compiler::testing::build::Build;
use phenomenon_compiler::testing::mock::MockRenderer;
use phenomenon_compiler::testing::random::Random;
use phenomenon_compiler::values::{Literal, Type};
use phenomenon_foreign_nodes::library;

const LOOPS: [&str; 5] =
    ["sample_sum", "sample_mean", "sample_maximum", "sample_over", "sample_loop"];

fn integer(value: i32) -> Binding {
    Binding::Literal(Literal::Integer(value))
}

/// A colour of the numbers of the sample: index, u, v, and alpha v.
fn drawn(build: &mut Build) -> Binding {
    let sample = build.node("sample", &[]);
    let [u, v] = ["u", "v"].map(|name| sample.output(name));
    let inputs = [("r", sample.output("index")), ("g", u), ("b", v.clone()), ("a", v)];
    build.node("combine_color", &inputs).first()
}

#[test]
fn every_reduction_is_the_same_in_all_engines() {
    for name in LOOPS {
        for count in [0, 1, 5] {
            let mut build = Build::with(library());
            let body = drawn(&mut build);
            let made = build.node(name, &[("count", integer(count)), ("body", body)]);
            build.material(made.first()).agree(7);
        }
    }
}

#[test]
fn samples_are_numbered_and_their_numbers_spread() {
    let shaded = |name: &str| {
        let mut build = Build::with(library());
        let body = drawn(&mut build);
        let made = build.node(name, &[("count", integer(1000)), ("body", body)]);
        let built = build.material(made.first());
        let mut found = Vec::new();
        let points = [State { path: 3, ..State::default() }, State::default()];
        built.in_every_engine(&[], &points, &MockRenderer::default(), |_, _, results| {
            found = results.to_vec();
        });
        found
    };
    let means = shaded("sample_mean");
    let [index, u, v, alpha] = means[0].color;
    assert_eq!((index, alpha), (499.5, 1.0));
    assert!((u - 0.5).abs() < 0.03 && (v - 0.5).abs() < 0.03 && u != v, "{u} {v}");
    assert_ne!(means[1].color[1], u, "points draw their own numbers");
    assert_eq!(shaded("sample_sum")[0].color[0], 499_500.0);
    let greatest = shaded("sample_maximum")[0].color;
    assert!(greatest[0] == 999.0 && greatest[1] < 1.0 && greatest[1] > 0.99, "{greatest:?}");
}

#[test]
fn a_count_may_differ_from_point_to_point() {
    for name in LOOPS {
        let mut build = Build::with(library());
        let state = build.node("state", &[]);
        let body = drawn(&mut build);
        // Computed by what the jit fuses: nobody but the loop reads it.
        let count = build.node("twice", &[("number", state.output("reflection_level"))]);
        let inputs = [("count", count.first()), ("body", body)];
        let made = build.node(name, &inputs);
        let mut points = Random::new(3).states(33);
        for (at, point) in points.iter_mut().enumerate() {
            // Some ask for none, and for less.
            point.reflection_level = at as i32 - 3;
        }
        build.material(made.first()).agree_at(points);
    }
}

#[test]
fn each_turn_asks_and_what_does_not_look_at_it_is_asked_once() {
    let mut build = Build::with(library());
    let sample = build.node("sample", &[]);
    let u = sample.output("u");
    let direction = build.node("combine_vector", &[("x", u.clone()), ("y", u)]);
    let inside = build.node("trace_reflection", &[("direction", direction.first())]);
    let outside = build.node("trace_environment", &[]);
    let both = build.node("add", &[("a", inside.first()), ("b", outside.first())]);
    let inputs = [("count", integer(3)), ("body", both.first())];
    let made = build.node("sample_mean", &inputs);
    let built = build.material(made.first());
    assert_eq!(built.agree(11).requests, 33 * 4);
    let points = [State::default(); 9];
    built.in_every_engine(&[], &points, &MockRenderer::default(), |engine, renderer, _| {
        assert_eq!(renderer.count(Effect::TraceReflection), 27, "{engine}");
        assert_eq!(renderer.count(Effect::TraceEnvironment), 9, "{engine}");
    });
}

#[test]
fn loops_over_lights_and_samples_stand_in_one_another() {
    // Light in samples: asked once, however many samples. Samples in light: new in each turn.
    for outer_is_light in [false, true] {
        let mut build = Build::with(library());
        let light = build.node("light_color", &[]);
        let drawn = drawn(&mut build);
        let both = build.node("multiply", &[("a", light.first()), ("b", drawn)]);
        let samples = |build: &mut Build, body: Binding| {
            build.node("sample_sum", &[("count", integer(3)), ("body", body)]).first()
        };
        let lights =
            |build: &mut Build, body: Binding| build.node("light_loop", &[("body", body)]).first();
        let made = if outer_is_light {
            let inner = samples(&mut build, both.first());
            lights(&mut build, inner)
        } else {
            let inner = lights(&mut build, both.first());
            samples(&mut build, inner)
        };
        build.material(made).agree(13);
    }
}

#[test]
fn numbers_are_averaged_over_lights() {
    let mut build = Build::with(library());
    let light = build.node("light", &[]);
    let lit = build.node("light_color", &[]);
    let split = build.node("split_color", &[("color", lit.first())]);
    let inputs = [("a", light.output("distance")), ("b", split.first())];
    let sum = build.node_of("add", Type::Scalar, &inputs);
    let made = build.node("mean_over_lights", &[("body", sum.first())]);
    assert!(build.material(made.first()).agree(17).requests > 0);
}

#[test]
fn the_sample_is_read_below_its_loop_only() {
    let codes = |source: &str| {
        let text = format!(
            r#"{{
                "phenomenon": "sampled", "version": 1,
                "nodes": {{
                    "drawn": {{ "type": "sample" }},
                    "shade": {{ "type": "combine_color", "inputs": {{
                        "r": {{ "node": "drawn", "output": "u" }} }} }},
                    "mean": {{ "type": "sample_mean", "inputs": {{
                        "count": 4, "body": {{ "node": "shade" }} }} }}
                }},
                "roots": {{ "material": {{ "node": "{source}" }} }}
            }}"#
        );
        let document = document::read("sampled.json", text.as_bytes()).expect("it is JSON");
        let findings = check_graph(&document, &library()).findings.into_iter();
        findings.map(|finding| (finding.code, finding.message)).collect::<Vec<_>>()
    };
    assert_eq!(codes("mean"), []);
    let outside = "node `drawn` (sample) reads the sample outside of a sample loop";
    assert!(codes("shade").contains(&(Code::OUTSIDE_LIGHT_LOOP, outside.to_owned())));
}
