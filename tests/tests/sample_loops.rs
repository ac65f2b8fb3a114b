//! Loops over samples, and every way turns become one value: in all engines, against the definition.
//! The nodes are those of another crate; the standard library has none over samples.

use std::sync::Arc;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::document;
use phenomenon_compiler::effects::Effect;
use phenomenon_compiler::graph::Binding;
use phenomenon_compiler::nodes::{Definition, NodeLibrary};
use phenomenon_compiler::state::{Iterated, State};
use phenomenon_compiler::values::{Literal, Type};
use phenomenon_tests::build::{Build, Built, every_engine};
use phenomenon_tests::differential::Case;
use phenomenon_tests::mock::MockRenderer;
use phenomenon_tests::random::Random;

/// Loops over samples of colours, one for each way their values become one.
macro_rules! over_samples {
    ($($name:ident $reduction:ident),+) => { $(
        mod $name {
            use phenomenon_compiler::node;
            use phenomenon_compiler::nodes::{BLACK, Kind};
            use phenomenon_compiler::state::{Iterated, Reduction};

            node! {
                /// Evaluates `body` once for every sample.
                $name in scopes structural [Kind::Loop(Iterated::Samples, Reduction::$reduction)],
                source "test",
                inputs {
                    /// How many samples.
                    count: integer = 4;
                }
                scoped {
                    /// What a sample yields.
                    body: color = BLACK;
                }
                outputs {
                    /// What they become.
                    color: color;
                }
            }
        }
    )+ };
}

over_samples!(sample_sum Sum, sample_mean Mean, sample_maximum Maximum, sample_over Over);

mod twice {
    use phenomenon_compiler::node;

    node! {
        /// A whole number, twice.
        twice in arithmetic,
        source "test",
        inputs {
            /// The number.
            number: integer = 0;
        }
        outputs {
            /// Its double.
            result: integer;
        }
        body |e, i| Outputs { result: i.number + i.number }
    }
}

mod mean_over_lights {
    use phenomenon_compiler::node;
    use phenomenon_compiler::nodes::Kind;
    use phenomenon_compiler::state::{Iterated, Reduction};

    node! {
        /// The mean of a number over lights.
        mean_over_lights in scopes structural [Kind::Loop(Iterated::Lights, Reduction::Mean)],
        source "test",
        inputs {
            /// Which.
            lights: lights = Vec::new();
        }
        scoped {
            /// What a light yields.
            body: scalar = 0.0;
        }
        outputs {
            /// Their mean.
            value: scalar;
        }
    }
}

fn library() -> NodeLibrary {
    let mut library = NodeLibrary::standard();
    library.add(sample_sum::definition());
    library.add(sample_mean::definition());
    library.add(sample_maximum::definition());
    library.add(sample_over::definition());
    library.add(mean_over_lights::definition());
    library.add(twice::definition());
    let fields = Iterated::Samples.provides().map(|field| (field.name(), field));
    library.add(Definition::of_fields("sample", "The sample of the loop round it.", fields));
    library
}

const LOOPS: [&str; 4] = ["sample_sum", "sample_mean", "sample_maximum", "sample_over"];

fn integer(value: i32) -> Binding {
    Binding::Literal(Literal::Integer(value))
}

/// All engines and the naive evaluator agree on `built`; the requests made.
fn agree(built: &Built, seed: u64) -> usize {
    let mut random = Random::new(seed);
    let case = Case {
        graph: Arc::clone(&built.graph),
        values: Vec::new(),
        points: random.states(33),
        options: every_engine(),
        naive: true,
    };
    let agreement = case.check().unwrap_or_else(|error| panic!("{error}"));
    assert!(agreement.ran && agreement.naive);
    agreement.requests
}

/// A colour of the numbers of the sample: index, u, v, and alpha v.
fn drawn(build: &mut Build) -> Binding {
    let sample = build.node("sample", &[]);
    let [u, v] = ["sample_u", "sample_v"].map(|name| sample.output(name));
    let inputs = [("r", sample.output("sample_index")), ("g", u), ("b", v.clone()), ("a", v)];
    build.node("combine_color", &inputs).first()
}

#[test]
fn every_reduction_is_the_same_in_all_engines() {
    for name in LOOPS {
        for count in [0, 1, 5] {
            let mut build = Build::with(library());
            let body = drawn(&mut build);
            let made = build.node(name, &[("count", integer(count)), ("body", body)]);
            agree(&build.material(made.first()), 7);
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
        let built = build.material(made.first());
        let case = Case {
            graph: built.graph,
            values: Vec::new(),
            points,
            options: every_engine(),
            naive: true,
        };
        assert!(case.check().unwrap_or_else(|error| panic!("{error}")).naive);
    }
}

#[test]
fn each_turn_asks_and_what_does_not_look_at_it_is_asked_once() {
    let mut build = Build::with(library());
    let sample = build.node("sample", &[]);
    let u = sample.output("sample_u");
    let direction = build.node("combine_vector", &[("x", u.clone()), ("y", u)]);
    let inside = build.node("trace_reflection", &[("direction", direction.first())]);
    let outside = build.node("trace_environment", &[]);
    let both = build.node("add", &[("a", inside.first()), ("b", outside.first())]);
    let inputs = [("count", integer(3)), ("body", both.first())];
    let made = build.node("sample_mean", &inputs);
    let built = build.material(made.first());
    assert_eq!(agree(&built, 11), 33 * 4);
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
        agree(&build.material(made), 13);
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
    assert!(agree(&build.material(made.first()), 17) > 0);
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
                        "r": {{ "node": "drawn", "output": "sample_u" }} }} }},
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
