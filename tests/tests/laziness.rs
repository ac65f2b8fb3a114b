//! What is not demanded is not asked for: requests are counted, in every engine.

use std::sync::Arc;

use phenomenon_compiler::effects::{Effect, LightSample};
use phenomenon_compiler::engine::{Engine, Options, Shader};
use phenomenon_compiler::graph::{Binding, RootKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::state::State;
use phenomenon_compiler::testing::build::{Build, Built, color, every_engine, scalar, vector};
use phenomenon_compiler::testing::differential::outcome;
use phenomenon_compiler::testing::mock::MockRenderer;
use phenomenon_compiler::testing::random::Random;
use phenomenon_compiler::testing::random_graph::{random_graph, random_value};
use phenomenon_compiler::values::{Literal, Space, Texture};

/// Ordinary points, each its own place; every third hit from inside.
fn points(count: u32) -> Vec<State> {
    let state = |index: u32| {
        let mut state = State { inv_normal: index.is_multiple_of(3), ..State::default() };
        state.point[0] = index as f32;
        state.hit.instance = index;
        state
    };
    (0..count).map(state).collect()
}

/// Demands that shading `points` asks for `effect` that many times, in every engine.
fn expect_requests(
    built: &Built,
    points: &[State],
    renderer: &MockRenderer,
    expected: &[(Effect, usize)],
) {
    built.in_every_engine(&[], points, renderer, |engine, renderer, _| {
        for &(effect, count) in expected {
            assert_eq!(renderer.count(effect), count, "{effect:?} in {engine}");
        }
    });
}

fn light(direction: [f32; 3]) -> LightSample {
    LightSample { direction, distance: 1.0, density: 1.0, reachable: true, token: 0 }
}

const ABOVE: [f32; 3] = [0.0, 0.6, 0.8];
const BEHIND: [f32; 3] = [0.0, 0.6, -0.8];

#[test]
fn a_mirror_of_weight_zero_casts_no_reflection_ray() {
    type Weight<'a> = &'a dyn Fn(&mut Build) -> Binding;
    let mirror = |weight: Weight<'_>| {
        let mut build = Build::new();
        let weight = weight(&mut build);
        let trace = build.node("trace_reflection", &[]);
        let mix = build.node(
            "mix",
            &[("weight", weight), ("a", color([0.1; 4])), ("b", trace.output("color"))],
        );
        build.material(mix.first())
    };
    let weights: [(Weight<'_>, usize); 6] = [
        (&|_| scalar(0.0), 0),
        (&|_| scalar(-0.0), 0),
        (&|_| scalar(1e-45), 20),
        (&|build| build.parameter("weight", Literal::Scalar(0.0)), 0),
        (&|build| build.parameter("weight", Literal::Scalar(0.25)), 20),
        // Per point: -0 at every third.
        (&|build| build.node("state", &[]).output("u"), 13),
    ];
    let mut points = points(20);
    for point in &mut points {
        point.uv[0] = if point.inv_normal { -0.0 } else { 0.5 };
    }
    for (weight, expected) in weights {
        let renderer = MockRenderer::default();
        expect_requests(
            &mirror(weight),
            &points,
            &renderer,
            &[(Effect::TraceReflection, expected)],
        );
    }
}

#[test]
fn a_choice_evaluates_one_side() {
    let mut build = Build::new();
    let inside = build.node("state", &[]).output("inv_normal");
    let (reflection, environment) = (
        build.node("trace_reflection", &[]),
        build.node("trace_environment", &[("direction", vector(ABOVE))]),
    );
    let choice = build.node(
        "select",
        &[
            ("condition", inside),
            ("if_true", reflection.first()),
            ("if_false", environment.first()),
        ],
    );
    let built = build.material(choice.first());
    let expected = [(Effect::TraceReflection, 7), (Effect::TraceEnvironment, 13)];
    expect_requests(&built, &points(20), &MockRenderer::default(), &expected);
}

#[test]
fn a_condition_and_its_branch_share_what_both_demand() {
    let mut build = Build::new();
    let trace = build.node("trace_reflection", &[]);
    let choice = build.node(
        "select",
        &[
            ("condition", trace.output("ok")),
            ("if_true", trace.output("color")),
            ("if_false", color([0.2; 4])),
        ],
    );
    // Its weight is a trace, and so is what it guards.
    let mix = build.node(
        "mix",
        &[
            ("weight", trace.output("distance")),
            ("a", choice.first()),
            ("b", trace.output("color")),
        ],
    );
    let built = build.material_where(mix.first(), trace.output("hit"));
    expect_requests(
        &built,
        &points(33),
        &MockRenderer::default(),
        &[(Effect::TraceReflection, 33)],
    );
}

#[test]
fn a_root_that_fails_demands_no_color() {
    let mut build = Build::new();
    let inside = build.node("state", &[]).output("inv_normal");
    let trace = build.node("trace_reflection", &[]);
    let built = build.material_where(trace.first(), inside);
    expect_requests(&built, &points(9), &MockRenderer::default(), &[(Effect::TraceReflection, 3)]);
}

#[test]
fn lights_behind_the_surface_cast_no_shadow_ray() {
    let mut build = Build::new();
    let lambert = build.node("lambert", &[]);
    let sum = build.node("light_loop", &[("body", lambert.first())]);
    let built = build.material(sum.first());
    let behind = MockRenderer::with_lights(vec![light(BEHIND); 3]);
    expect_requests(&built, &points(9), &behind, &[(Effect::LightColor, 0)]);
    let mut lights = vec![light(ABOVE), light(BEHIND), light(ABOVE), light(ABOVE)];
    lights[2].reachable = false;
    let some = MockRenderer::with_lights(lights);
    expect_requests(&built, &points(9), &some, &[(Effect::LightColor, 18)]);
}

#[test]
fn loops_over_the_same_lights_share_shadow_rays() {
    let mut build = Build::new();
    let lambert = build.node("lambert", &[]);
    let arriving = build.node("light_color", &[]);
    let diffuse = build.node("light_loop", &[("body", lambert.first())]);
    let all = build.node("light_loop", &[("body", arriving.first())]);
    let both = build.node("add", &[("a", diffuse.first()), ("b", all.first())]);
    let built = build.material(both.first());
    let renderer = MockRenderer::with_lights(vec![light(ABOVE), light(BEHIND)]);
    expect_requests(&built, &points(9), &renderer, &[(Effect::LightColor, 18)]);
}

#[test]
fn what_a_loop_does_not_change_is_evaluated_once() {
    let mut build = Build::new();
    let trace = build.node("trace_reflection", &[]);
    let arriving = build.node("light_color", &[]);
    let product = build.node("multiply", &[("a", trace.first()), ("b", arriving.first())]);
    let inside = build.node("light_loop", &[("body", product.first())]);
    let built = build.clone().material(inside.first());
    let renderer = MockRenderer::with_lights(vec![light(ABOVE); 3]);
    let expected = [(Effect::TraceReflection, 9), (Effect::LightColor, 27)];
    expect_requests(&built, &points(9), &renderer, &expected);

    // The body itself belongs outside.
    let alone = build.node("light_loop", &[("body", trace.first())]);
    let built = build.material(alone.first());
    expect_requests(&built, &points(9), &renderer, &[(Effect::TraceReflection, 9)]);
}

#[test]
fn nothing_outside_is_evaluated_for_a_loop_without_iterations() {
    let mut build = Build::new();
    let trace = build.node("trace_reflection", &[]);
    let sum = build.node("light_loop", &[("body", trace.first())]);
    let built = build.material(sum.first());
    let none = MockRenderer::with_lights(Vec::new());
    expect_requests(&built, &points(9), &none, &[(Effect::TraceReflection, 0)]);
    let unreachable = LightSample { reachable: false, ..light(ABOVE) };
    let none = MockRenderer::with_lights(vec![unreachable; 2]);
    expect_requests(&built, &points(9), &none, &[(Effect::TraceReflection, 0)]);
}

#[test]
fn a_trace_inside_a_loop_is_evaluated_in_each_iteration() {
    let mut build = Build::new();
    let direction = build.node("light", &[]).output("direction");
    let trace = build.node("trace_reflection", &[("direction", direction)]);
    let sum = build.node("light_loop", &[("body", trace.first())]);
    let built = build.material(sum.first());
    let renderer = MockRenderer::with_lights(vec![light(ABOVE), light(BEHIND)]);
    expect_requests(&built, &points(9), &renderer, &[(Effect::TraceReflection, 18)]);
}

#[test]
fn a_scope_evaluates_anew_what_reads_the_normal_and_nothing_else() {
    let mut build = Build::new();
    // Its default direction is made from the normal.
    let mirror = build.node("trace_reflection", &[]);
    let environment = build.node("trace_environment", &[("direction", vector(ABOVE))]);
    let both = build.node("add", &[("a", mirror.first()), ("b", environment.first())]);
    let bent = build.node("perturb_normal", &[("normal", vector(ABOVE)), ("input", both.first())]);
    let sum = build.node("add", &[("a", both.first()), ("b", bent.first())]);
    let built = build.material(sum.first());
    let expected = [(Effect::TraceReflection, 18), (Effect::TraceEnvironment, 9)];
    expect_requests(&built, &points(9), &MockRenderer::default(), &expected);
}

/// Editing a parameter gives what a shader made with the new value gives.
#[test]
fn a_parameter_set_is_a_parameter_given() {
    let library = NodeLibrary::standard();
    let mut edits = 0;
    for seed in 1 << 33..(1 << 33) + 60 {
        let mut random = Random::new(seed);
        let size = 1 + random.below(25);
        let (graph, mut values) = random_graph(&mut random, &library, size);
        let graph = Arc::new(graph);
        let options = random.pick(&every_engine());
        let new = |values: &[(String, Literal)], options: Options| {
            Shader::new(Arc::clone(&graph), values, options).expect("compiles")
        };
        let mut edited = new(&values, options);
        for _ in 0..4 {
            let Some((name, value)) = random_value(&mut random, &graph) else { break };
            edited.set(&name, &value).expect("a parameter of the graph");
            values.push((name, value));
            let fresh = new(&values, Options { engine: Engine::Walk, ..options });
            let points = random.states(9);
            for root in &graph.roots {
                let (a, b) =
                    (outcome(&edited, root.kind, &points), outcome(&fresh, root.kind, &points));
                assert_eq!(a, b, "seed {seed}, {options:?}, {values:?}");
            }
            edits += 1;
        }
    }
    assert!(edits > 100);
}

/// A weight edited to 0 and back stops the rays and brings them back.
#[test]
fn an_edited_weight_stops_the_rays() {
    let mut build = Build::new();
    let weight = build.parameter("weight", Literal::Scalar(0.5));
    let trace = build.node("trace_reflection", &[]);
    let mix = build.node("mix", &[("weight", weight), ("b", trace.first())]);
    let built = build.material(mix.first());
    for options in every_engine() {
        let mut shader = built.shader(&[], options);
        for (weight, expected) in [(0.5, 9), (0.0, 0), (0.25, 9), (1.0, 9), (0.0, 0)] {
            shader.set("weight", &Literal::Scalar(weight)).expect("a parameter");
            let found = outcome(&shader, RootKind::Material, &points(9));
            assert_eq!(found.log.len(), expected, "{weight} in {options:?}");
        }
    }
}

/// The colour beyond a picture matters where an axis has one, and what a footprint covers for one filter.
#[test]
fn what_a_sampling_does_not_look_at_is_not_evaluated() {
    let lookup = |wrap_v: i32, filter: i32| {
        let mut build = Build::new();
        let wood = Texture { file: "wood.png".into(), space: Space::Srgb };
        let beyond = build.node("trace_reflection", &[]).output("color");
        let probe = build.node("trace_probe", &[("direction", vector([0.0, 0.0, 1.0]))]);
        let inputs = [
            ("texture", Binding::Literal(Literal::Texture(Some(wood)))),
            ("wrap_v", Binding::Literal(Literal::Integer(wrap_v))),
            ("filter", Binding::Literal(Literal::Integer(filter))),
            ("default", beyond),
            ("dv_dy", probe.output("distance")),
        ];
        let read = build.node("texture_lookup", &inputs).output("color");
        build.material(read)
    };
    for (wrap_v, filter, default, footprint) in
        [(0, 0, 0, 0), (1, 1, 0, 0), (2, 2, 0, 0), (3, 0, 20, 0), (0, 3, 0, 20), (3, 3, 20, 20)]
    {
        let expected = [
            (Effect::ReadTexture, 20),
            (Effect::TraceReflection, default),
            (Effect::TraceProbe, footprint),
        ];
        let built = lookup(wrap_v, filter);
        expect_requests(&built, &points(20), &MockRenderer::default(), &expected);
    }
}
