//! Environment, depth limits and what rays count as.

use std::sync::Arc;

use phenomenon_compiler::effects::{Answer, Renderer, Trace};
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::state::{RayType, State};
use phenomenon_runtime::geometry::Transform;
use phenomenon_runtime::lights::Environment;
use phenomenon_runtime::render::{Context, RayCounts, Settings, render};
use phenomenon_runtime::scene::{SceneBuilder, TraceDepth};

use crate::shaders::{Hand, ask, builder, each, mirror, mirrored, trace};

fn small() -> Settings {
    Settings { width: 24, height: 24, samples: 4, threads: 1, ..Settings::default() }
}

#[test]
fn mirrors_in_a_constant_environment_vanish() {
    let mut builder = builder();
    let material = builder.material(mirror());
    builder.sphere([0.0; 3], 1.0, &Transform::default(), material).unwrap();
    builder.sphere([1.5, 0.5, 0.0], 0.7, &Transform::default(), material).unwrap();
    builder.environment(Environment::Constant([0.25, 0.5, 0.75, 1.0]));
    builder.depth(TraceDepth::from_numbers(&[3]).unwrap());
    let scene = builder.build().unwrap();
    let rendered = render(&scene, &small(), &|_, _| {}).unwrap();
    for pixel in rendered.film.pixels() {
        assert_eq!(*pixel, [0.25, 0.5, 0.75, 1.0]);
    }
    let rays = rendered.statistics.rays;
    assert_eq!(rays.eye, 24 * 24 * 4);
    // Every path ends in one lookup.
    assert_eq!(rays.environment, rays.eye);
    assert!(rays.reflection > 200 && rays.refraction == 0 && rays.shadow == 0);
}

#[test]
fn without_an_environment_misses_are_black_and_not_ok() {
    let mut builder = builder();
    let material = builder.material(mirror());
    builder.sphere([0.0; 3], 1.0, &Transform::default(), material).unwrap();
    let scene = builder.build().unwrap();
    let rendered = render(&scene, &small(), &|_, _| {}).unwrap();
    assert!(rendered.film.pixels().iter().all(|pixel| *pixel == [0.0; 4]));
    assert_eq!(rendered.statistics.rays.environment, 0);
    assert!(rendered.statistics.rays.reflection > 0);
}

/// Rays bounce between the walls of a mirrored ball until the depth ends them.
fn rays_within(depth: &[i32], kind: Trace) -> RayCounts {
    let hand = Hand::material(move |points, renderer, results| {
        let answers = trace(renderer, kind, points, true, mirrored);
        for (answer, result) in answers.iter().zip(results) {
            *result = Shaded { color: answer.color, ok: answer.ok };
        }
    });
    let camera = crate::shaders::looking_from([0.0, 0.1, 0.5]);
    let mut builder = SceneBuilder::new(camera);
    let material = builder.material(Arc::new(hand));
    builder.sphere([0.0; 3], 1.0, &Transform::default(), material).unwrap();
    builder.environment(Environment::Constant([1.0; 4]));
    builder.depth(TraceDepth::from_numbers(depth).unwrap());
    let scene = builder.build().unwrap();
    let rendered = render(&scene, &small(), &|_, _| {}).unwrap();
    // Past the depth the environment answers.
    assert!(rendered.film.pixels().iter().all(|pixel| *pixel == [1.0; 4]));
    rendered.statistics.rays
}

#[test]
fn depth_limits_cut_reflections_and_refractions() {
    let eye = 24 * 24 * 4;
    for depth in [0, 1, 4] {
        let rays = rays_within(&[depth], Trace::Reflection);
        assert_eq!((rays.eye, rays.reflection), (eye, eye * depth as u64));
        assert_eq!(rays.environment, eye);
    }
    assert_eq!(rays_within(&[5, 0, 3], Trace::Reflection).reflection, eye * 3);
    assert_eq!(rays_within(&[5, 2], Trace::Refraction).refraction, eye * 2);
    assert_eq!(rays_within(&[2, 5, 2], Trace::Refraction).refraction, eye * 2);
}

#[test]
fn transparent_rays_go_straight_on_whatever_direction_is_asked() {
    let (hand, seen) = crate::shaders::recorder();
    let glass = Hand::material(|points, renderer, results| {
        let answers = trace(renderer, Trace::Transparent, points, true, |_| [0.0; 3]);
        for (answer, result) in answers.iter().zip(results) {
            *result = Shaded { color: answer.color, ok: answer.hit };
        }
    });
    let mut builder = SceneBuilder::new(crate::shaders::looking_from([0.0, 0.0, 5.0]));
    let (glass, wall) = (builder.material(Arc::new(glass)), builder.material(hand));
    builder.sphere([0.0; 3], 1.0, &Transform::default(), glass).unwrap();
    builder.sphere([0.0, 0.0, -20.0], 10.0, &Transform::default(), wall).unwrap();
    let scene = builder.build().unwrap();
    render(&scene, &small(), &|_, _| {}).unwrap();
    let seen = seen.lock().unwrap();
    let through: Vec<_> =
        seen.iter().filter(|state| state.ray_type == RayType::Transparent).collect();
    assert!(through.len() > 100);
    for state in through {
        assert_eq!((state.refraction_level, state.reflection_level), (2, 0));
        let towards = [0, 1, 2].map(|k| state.point[k] - [0.0, 0.0, 5.0][k]);
        let length = crate::shaders::dot(towards, towards).sqrt();
        let straight = crate::shaders::dot(towards, state.direction) / length;
        assert!(straight > 1.0 - 1e-6);
    }
}

#[test]
fn environment_shaders_see_the_direction_and_never_recurse() {
    let hand = Hand::material(each(|_| [0.0; 4])).with_environment(|points, renderer, results| {
        let nested = trace(renderer, Trace::Environment, points, true, |s| s.direction);
        for ((point, result), nested) in points.iter().zip(results).zip(nested) {
            assert_eq!((point.ray_type, point.dist), (RayType::Environment, 0.0));
            assert_eq!(nested, Answer::default());
            let [x, y, z] = point.direction.map(f32::abs);
            *result = Shaded { color: [x, y, z, 1.0], ok: point.direction[1] > 0.0 };
        }
    });
    let mut builder = builder();
    builder.environment(Environment::Shader(Arc::new(hand)));
    let scene = builder.build().unwrap();
    let mut context = Context::new(&scene, 3);
    let state = State::default();
    let rays: Vec<_> = (0..8).map(|at| ask(&state, [0.0, 1.0 - at as f32, 0.0], at)).collect();
    let mut answers = vec![Answer::default(); 8];
    context.trace(Trace::Environment, &[state], &rays, &mut answers);
    assert_eq!(answers[0], Answer { color: [0.0, 1.0, 0.0, 1.0], ok: true, ..Answer::default() });
    // A zero direction sees nothing.
    assert_eq!(answers[1], Answer::default());
    assert!(!answers[2].ok && answers[2].color == [0.0, 1.0, 0.0, 1.0]);
    assert_eq!((context.counts().environment, context.points()), (7, 7));
    assert_eq!(context.counts().reflection, 0);
}

#[test]
fn children_inherit_the_media_and_get_keys_of_their_own() {
    let (hand, seen) = crate::shaders::recorder();
    let mut builder = builder();
    let material = builder.material(hand);
    builder.sphere([0.0; 3], 1.0, &Transform::default(), material).unwrap();
    let scene = builder.build().unwrap();
    let mut context = Context::new(&scene, 64);
    let state = State {
        point: [0.0, 0.0, 3.0],
        ior: 1.5,
        ior_in: 1.25,
        time: 0.5,
        raster: [3.5, 4.5],
        path: 42,
        ..State::default()
    };
    let rays = [1, 2].map(|site| ask(&state, [0.0, 0.0, -1.0], site));
    let mut answers = [Answer::default(); 2];
    context.trace(Trace::Refraction, &[state], &rays, &mut answers);
    let seen = seen.lock().unwrap();
    for child in &*seen {
        assert_eq!((child.ior, child.ior_in, child.time), (1.5, 1.25, 0.5));
        assert_eq!((child.raster, child.ray_type), ([3.5, 4.5], RayType::Refraction));
    }
    assert_ne!(seen[0].path, seen[1].path);
    assert_ne!(seen[0].path, 42);
}
