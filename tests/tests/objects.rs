//! Fields of the object: in every engine, and a scene says what they are.

use std::sync::Arc;

use phenomenon_compiler::effects::{Answer, Ray, Renderer, Trace};
use phenomenon_compiler::state::{Hit, Object, State};
use phenomenon_compiler::testing::build::{Build, Built, every_engine};
use phenomenon_compiler::testing::mock::MockRenderer;
use phenomenon_runtime::camera::Camera;
use phenomenon_runtime::geometry::Transform;
use phenomenon_runtime::render::Context;
use phenomenon_runtime::scene::SceneBuilder;

/// The colour (id, random, the point's x), id and random from the object.
fn told() -> Built {
    let mut build = Build::new();
    let object = build.node("object", &[]);
    let state = build.node("state", &[]);
    let point = build.node("split_vector", &[("vector", state.output("point"))]);
    let color = build.node(
        "combine_color",
        &[("r", object.output("id")), ("g", object.output("random")), ("b", point.first())],
    );
    build.material(color.first())
}

#[test]
fn every_engine_looks_fields_up_by_the_object() {
    let renderer =
        MockRenderer { objects: (0..5).map(Object::at).collect(), ..MockRenderer::default() };
    let points: Vec<State> = (0..45)
        .map(|at| State {
            point: [at as f32, 0.0, 0.0],
            hit: Hit { instance: at % 7, ..Hit::default() },
            ..State::default()
        })
        .collect();
    told().in_every_engine(&[], &points, &renderer, |engine, _, results| {
        for (at, result) in (0_u32..).zip(results) {
            // Two of seven are on no object of the scene.
            let object = renderer.objects.get(at as usize % 7).copied().unwrap_or_default();
            let [id, random, x, _] = result.color;
            assert_eq!((id, random, x), (object.id as f32, object.random, at as f32), "{engine}");
        }
    });
}

#[test]
fn a_scene_numbers_its_objects() {
    for options in every_engine() {
        let camera = Camera::new([0.0, 0.0, 6.0], [0.0; 3], [0.0, 1.0, 1e-3], 40.0).unwrap();
        let mut builder = SceneBuilder::new(camera);
        let material = builder.material(Arc::new(told().shader(&[], options)));
        for x in [-2.0, 2.0] {
            builder.sphere([x, 0.0, 0.0], 1.0, &Transform::default(), material).unwrap();
        }
        let scene = builder.build().unwrap();
        let states = [-2.0, 2.0].map(|x| State { point: [x, 0.0, 4.0], ..State::default() });
        let rays = [0, 1].map(|point| Ray {
            point,
            origin: states[point as usize].point,
            direction: [0.0, 0.0, -1.0],
            site: 0,
        });
        let mut answers = [Answer::default(); 2];
        Context::new(&scene, 64).trace(Trace::Reflection, &states, &rays, &mut answers);
        for (at, (answer, x)) in (0..).zip(answers.iter().zip([-2.0, 2.0])) {
            let object = Object::at(at);
            assert_eq!(answer.color[..3], [object.id as f32, object.random, x], "{options:?}");
        }
    }
}
