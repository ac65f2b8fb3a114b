//! Pure code that no point of a block wants is skipped: evaluations are counted, in every engine.

use std::sync::Arc;

use phenomenon_compiler::engine::{Engine, Evaluations, Options, Shader};
use phenomenon_compiler::graph::{Binding, RootKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::state::State;
use phenomenon_compiler::testing::build::{Build, Built, color, every_engine, scalar};
use phenomenon_compiler::testing::differential::{Case, outcome};
use phenomenon_compiler::testing::random::Random;
use phenomenon_compiler::testing::random_graph::random_graph;
use phenomenon_compiler::values::Type;

/// Points of which those hit from inside are chosen.
fn points(count: usize, inside: impl Fn(usize) -> bool) -> Vec<State> {
    let state = |index: usize| State {
        inv_normal: inside(index),
        point: [index as f32 * 0.37, 0.21, -1.4],
        ..State::default()
    };
    (0..count).map(state).collect()
}

/// What the engine of the options counted.
fn counted(shader: &Shader) -> Evaluations {
    shader.evaluations().into_iter().fold(Evaluations::default(), |mut sum, (_, of)| {
        sum += of;
        sum
    })
}

fn noise(build: &mut Build, scale: f32) -> Binding {
    let here = build.node("state", &[]).output("point");
    let place = build.node_of("scale", Type::Vector, &[("input", here), ("factor", scalar(scale))]);
    build.node("perlin_noise", &[("position", place.first())]).first()
}

/// One noise where the surface is hit from inside, another where it is not.
fn choice() -> Built {
    let mut build = Build::new();
    let inside = build.node("state", &[]).output("inv_normal");
    let (a, b) = (noise(&mut build, 1.5), noise(&mut build, -0.7));
    let inputs = [("condition", inside), ("if_true", a), ("if_false", b)];
    let chosen = build.node_of("select", Type::Scalar, &inputs);
    build.material(chosen.first())
}

/// Shades points, and counts.
fn count(built: &Built, options: Options, points: &[State]) -> Evaluations {
    let shader = built.shader(&[], Options { count: true, ..options });
    outcome(&shader, RootKind::Material, points);
    counted(&shader)
}

#[test]
fn a_side_that_no_point_of_a_block_wants_is_not_evaluated() {
    let built = choice();
    let blocks = 5;
    let all = blocks * 8;
    let mixed = points(all, |index| index % 2 == 0);
    let inside = points(all, |_| true);
    // The last block alone is outside.
    let one_outside = points(all, |index| index < all - 8);
    for options in every_engine().into_iter().filter(|options| options.batch == 256) {
        let of = |points: &[State]| count(&built, options, points);
        let [mixed, inside, one_outside] = [of(&mixed), of(&inside), of(&one_outside)];
        // The scaled place, the noise, the choice and the root.
        let wanted = 4 * all as u64;
        assert_eq!([mixed.wanted, inside.wanted, one_outside.wanted], [wanted; 3], "{options:?}");
        let side = match options.engine {
            Engine::Walk => 0,
            // A noise and what it alone needs.
            _ => 2 * all as u64,
        };
        assert_eq!(mixed.done, wanted + side, "{options:?}");
        assert_eq!([inside.done, one_outside.done], [wanted; 2], "{options:?}");
    }
}

/// Lanes that no point fills want no other side than the points beside them.
#[test]
fn lanes_without_a_point_want_nothing_besides() {
    let built = choice();
    for options in every_engine().into_iter().filter(|options| options.engine != Engine::Walk) {
        for side in [true, false] {
            let found = count(&built, options, &points(21, |_| side));
            let blocks = match options.batch {
                1 => 21,
                7 => 3,
                _ => 21_u64.div_ceil(8),
            };
            assert_eq!((found.wanted, found.done), (4 * 21, 4 * 8 * blocks), "{options:?}");
        }
    }
}

/// A side within a side: where the outer one is not wanted, nor is the inner one, whatever it is chosen by.
#[test]
fn sides_stand_within_sides() {
    let mut build = Build::new();
    let state = build.node("state", &[]);
    let (a, b, c) = (noise(&mut build, 1.5), noise(&mut build, -0.7), noise(&mut build, 0.3));
    let high = build.node_of("less", Type::Scalar, &[("a", scalar(0.5)), ("b", c)]);
    let inputs = [("condition", high.first()), ("if_true", a), ("if_false", scalar(0.25))];
    let inner = build.node_of("select", Type::Scalar, &inputs);
    let inputs =
        [("condition", state.output("inv_normal")), ("if_true", inner.first()), ("if_false", b)];
    let outer = build.node_of("select", Type::Scalar, &inputs);
    let built = build.material(outer.first());
    for options in every_engine() {
        let outside = count(&built, options, &points(24, |_| false));
        assert_eq!(outside.wanted, 4 * 24, "{options:?}");
        if options.engine != Engine::Walk && options.batch == 256 {
            // Light steps may be taken along, the noises of the other side not.
            assert!((4 * 24..=7 * 24).contains(&outside.done), "{outside:?} in {options:?}");
        }
        let inside = count(&built, options, &points(24, |_| true));
        let walk =
            count(&built, Options { engine: Engine::Walk, ..options }, &points(24, |_| true));
        assert_eq!(inside.wanted, walk.wanted, "{options:?}");
        assert_eq!(walk.wanted, walk.done);
    }
}

/// What reads an answer is evaluated in blocks that ask, and what only a request needs, too.
#[test]
fn what_belongs_to_a_request_is_evaluated_where_that_is_made() {
    let mut build = Build::new();
    let weight = build.node("state", &[]).output("u");
    let trace = build.node("trace_reflection", &[]);
    let dim = build.node("scale", &[("input", trace.first()), ("factor", scalar(0.5))]);
    let inputs = [("weight", weight), ("a", color([0.1; 4])), ("b", dim.first())];
    let mix = build.node("mix", &inputs);
    let built = build.material(mix.first());
    let mut points = points(40, |_| false);
    for point in &mut points[16..24] {
        point.uv[0] = 0.25;
    }
    for options in every_engine() {
        let found = count(&built, options, &points);
        // Everywhere the mix and the root; in one block the direction, the trace, and what dims it.
        let all = 2 * 40 + 3 * 8;
        assert_eq!(found.wanted, all, "{options:?}");
        if options.engine == Engine::Walk || options.batch == 256 {
            assert_eq!(found.done, all, "{options:?}");
        }
    }
}

/// A case of two numbers is wanted where one of them is.
#[test]
fn what_is_demanded_in_two_ways_is_wanted_where_one_of_them_is() {
    let mut build = Build::new();
    let index = build.node("state", &[]).output("reflection_level");
    let (even, odd) = (noise(&mut build, 1.5), noise(&mut build, -0.7));
    let inputs = [
        ("index", index),
        ("case_0", even.clone()),
        ("case_1", odd.clone()),
        ("case_2", even),
        ("case_3", odd),
    ];
    let chosen = build.node_of("switch", Type::Scalar, &inputs);
    let built = build.material(chosen.first());
    let mut points = points(16, |_| false);
    for (index, point) in points.iter_mut().enumerate() {
        point.reflection_level = 2 * (index as i32 % 2);
    }
    for options in every_engine() {
        let found = count(&built, options, &points);
        assert_eq!(found.wanted, 4 * 16, "{options:?}");
        if options.engine == Engine::Walk || options.batch == 256 {
            assert_eq!(found.done, 4 * 16, "{options:?}");
        }
    }
}

/// The other side of a choice may ask for rays: the condition is known all the same.
#[test]
fn a_side_is_skipped_beside_one_that_asks() {
    let mut build = Build::new();
    let inside = build.node("state", &[]).output("inv_normal");
    let (trace, noise) = (build.node("trace_reflection", &[]), noise(&mut build, 1.5));
    let gray = build.node("scale", &[("input", color([0.5; 4])), ("factor", noise)]);
    let inputs = [("condition", inside), ("if_true", trace.first()), ("if_false", gray.first())];
    let chosen = build.node("select", &inputs);
    let built = build.material(chosen.first());
    for options in every_engine() {
        let found = count(&built, options, &points(16, |_| true));
        // The direction, the trace, the choice and the root.
        assert_eq!(found.wanted, 4 * 16, "{options:?}");
        if options.engine == Engine::Walk || options.batch == 256 {
            assert_eq!(found.done, 4 * 16, "{options:?}");
        }
    }
}

/// What is not counted costs nothing and says nothing.
#[test]
fn nothing_is_counted_unless_that_is_asked_for() {
    let built = choice();
    for options in every_engine() {
        let shader = built.shader(&[], options);
        outcome(&shader, RootKind::Material, &points(9, |_| true));
        assert_eq!(counted(&shader), Evaluations::default(), "{options:?}");
    }
}

/// On random graphs all engines want what the walk wants, the walk makes what it wants, and the others make
/// no less; results and requests do not depend on it (see `engines_agree`, too).
#[test]
fn every_engine_wants_what_the_walk_wants() {
    let library = NodeLibrary::standard();
    let (mut ran, mut skipping, mut loops) = (0, 0, 0);
    for seed in 1 << 34..(1 << 34) + 250 {
        let mut random = Random::new(seed);
        let size = 20 + random.below(50);
        let (graph, values) = random_graph(&mut random, &library, size);
        let case = Case::random(&mut random, graph, values);
        let agreement = case.check().unwrap_or_else(|error| panic!("seed {seed}: {error}"));
        if !agreement.ran {
            continue;
        }
        ran += 1;
        let shader = |options| {
            let graph = Arc::clone(&case.graph);
            Shader::new(graph, &case.values, options).expect("it compiled before")
        };
        let walk = shader(Options { engine: Engine::Walk, count: true, ..Options::default() });
        let text = shader(Options { engine: Engine::Batch, ..Options::default() }).print();
        skipping += u32::from(text.contains(") where s"));
        loops += u32::from(text.contains("= loop"));
        let others: Vec<Shader> = case.options[1..]
            .iter()
            .map(|options| shader(Options { count: true, ..*options }))
            .collect();
        for root in &case.graph.roots {
            let expected = outcome(&walk, root.kind, &case.points);
            for other in &others {
                assert_eq!(outcome(other, root.kind, &case.points), expected, "seed {seed}");
            }
        }
        let expected = counted(&walk);
        assert_eq!(expected.wanted, expected.done, "seed {seed}");
        for other in &others {
            let found = counted(other);
            assert_eq!(found.wanted, expected.wanted, "seed {seed}");
            assert!(found.done >= found.wanted, "seed {seed}: {found:?}");
        }
    }
    println!("{ran} graphs, {skipping} that skip something, {loops} with loops");
    assert!(ran >= 200 && skipping >= 50 && loops >= 20, "{ran} {skipping} {loops}");
}
