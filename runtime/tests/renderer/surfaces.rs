//! States at hits, and rays that leave surfaces.

use std::sync::Arc;

use phenomenon_compiler::effects::{Answer, Renderer, Trace};
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::state::State;
use phenomenon_runtime::geometry::{Mesh, Transform};
use phenomenon_runtime::render::{Context, Settings, render};
use phenomenon_runtime::scene::SceneBuilder;

use crate::shaders::{Hand, Numbers, ask, ball, dot, looking_from, recorder};

fn settings(side: u32) -> Settings {
    Settings { width: side, height: side, samples: 1, threads: 1, ..Settings::default() }
}

/// Renders one object and gives the states of its hits.
fn states(
    add: impl Fn(&mut SceneBuilder, u32),
    camera: [f64; 3],
    look_at: [f64; 3],
) -> (Vec<State>, SceneBuilder) {
    let camera =
        phenomenon_runtime::camera::Camera::new(camera, look_at, [0.0, 1.0, 1e-3], 40.0).unwrap();
    let (hand, seen) = recorder();
    let mut builder = SceneBuilder::new(camera);
    let material = builder.material(hand);
    add(&mut builder, material);
    let scene = builder.build().unwrap();
    render(&scene, &settings(32), &|_, _| {}).unwrap();
    let mut again = SceneBuilder::new(camera);
    let material = again.material(recorder().0);
    add(&mut again, material);
    let seen = std::mem::take(&mut *seen.lock().unwrap());
    (seen, again)
}

/// From every state, rays outwards must leave a convex object without meeting it again, and rays
/// inwards must meet its other side.
fn leaves_cleanly(states: &[State], builder: SceneBuilder, what: &str) {
    let scene = builder.build().unwrap();
    let mut context = Context::new(&scene, 64);
    let mut numbers = Numbers(9);
    assert!(states.len() > 100, "{what}: only {} hits", states.len());
    for state in states {
        for grazing in [false, true] {
            let mut direction = numbers.direction().map(|x| x as f32);
            let side = dot(direction, state.normal_geom);
            if grazing {
                let keep = 1e-4 * side.signum() - side;
                direction = [0, 1, 2].map(|k| direction[k] + keep * state.normal_geom[k]);
            }
            let side = dot(direction, state.normal_geom);
            let outwards = if state.inv_normal { -side } else { side };
            let mut answer = [Answer::default()];
            context.trace(Trace::Probe, &[*state], &[ask(state, direction, 0)], &mut answer);
            if outwards > 0.0 {
                assert!(!answer[0].hit, "{what}: acne at {:?} towards {direction:?}", state.point);
            } else if !grazing {
                assert!(answer[0].hit, "{what}: leak at {:?} towards {direction:?}", state.point);
            }
        }
    }
}

#[test]
fn spheres_of_all_sizes_have_no_acne() {
    for radius in [1e-3, 0.1, 1.0, 50.0, 1e6] {
        for far in [0.0, 3.0] {
            let center = [radius * far, -radius * far, radius * far * 0.5];
            let add = |builder: &mut SceneBuilder, material: u32| {
                builder.sphere(center, radius, &Transform::default(), material).unwrap();
            };
            let eye = [center[0], center[1], center[2] + 3.0 * radius];
            let (seen, builder) = states(add, eye, center);
            leaves_cleanly(&seen, builder, &format!("radius {radius} at {center:?}"));
            // From inside.
            let eye = [center[0], center[1], center[2] + 0.5 * radius];
            let (seen, builder) = states(add, eye, center);
            assert!(seen.iter().all(|state| state.inv_normal));
            leaves_cleanly(&seen, builder, &format!("inside radius {radius} at {center:?}"));
        }
    }
}

#[test]
fn meshes_far_from_the_origin_have_no_acne() {
    for (scale, offset) in [(1.0, 0.0), (1e-3, 0.0), (1e5, 0.0), (1.0, 1000.0), (1.0, 30_000.0)] {
        let center = [offset, -offset, offset * 0.5];
        let transform = Transform::new([scale; 3], [0.0; 3], center);
        let add = |builder: &mut SceneBuilder, material: u32| {
            builder.mesh(&ball(2), &transform, material).unwrap();
        };
        let eye = [center[0], center[1], center[2] + 3.0 * scale];
        let (seen, builder) = states(add, eye, center);
        // Only outwards along the normal: a rounded mesh far out is not exactly convex.
        let scene = builder.build().unwrap();
        let mut context = Context::new(&scene, 64);
        assert!(seen.len() > 100);
        for state in &seen {
            let mut answers = [Answer::default(); 2];
            let inwards = state.normal_geom.map(|x| -x);
            let rays = [ask(state, state.normal_geom, 0), ask(state, inwards, 0)];
            context.trace(Trace::Probe, &[*state], &rays, &mut answers);
            assert!(!answers[0].hit, "acne at {:?}", state.point);
            assert!(answers[1].hit && answers[1].distance > scale as f32 * 0.1, "{answers:?}");
        }
    }
}

#[test]
fn states_are_in_their_ranges() {
    let mut smooth = ball(2);
    smooth.smooth().unwrap();
    type Add = Box<dyn Fn(&mut SceneBuilder, u32)>;
    let shapes: [(&str, Add); 2] = [
        (
            "sphere",
            Box::new(|builder, material| {
                builder.sphere([0.0; 3], 1.0, &Transform::default(), material).unwrap();
            }),
        ),
        (
            "mesh",
            Box::new(move |builder, material| {
                builder.mesh(&smooth, &Transform::default(), material).unwrap();
            }),
        ),
    ];
    for (what, add) in shapes {
        for eye in [[0.0, 0.2, 3.0], [0.0, 0.1, 0.2]] {
            let (seen, _) = states(&add, eye, [0.0; 3]);
            let inside = eye[2] < 1.0;
            assert!(seen.len() > 100);
            for state in &seen {
                let unit = |v: [f32; 3]| (dot(v, v) - 1.0).abs() < 1e-6;
                assert!(unit(state.direction) && unit(state.normal) && unit(state.normal_geom));
                assert_eq!(state.inv_normal, inside, "{what}");
                assert!(dot(state.normal_geom, state.direction) <= 0.0);
                assert!(dot(state.normal, state.normal_geom) > 0.0);
                assert!((-1.0..=0.0).contains(&state.dot_nd));
                assert!(state.dist > 0.0 && state.uv.iter().all(|x| (0.0..=1.0).contains(x)));
                let reached = [0, 1, 2].map(|k| state.origin[k] + state.dist * state.direction[k]);
                let gap = [0, 1, 2].map(|k| reached[k] - state.point[k]);
                assert!(dot(gap, gap) < 1e-11, "{what}: {gap:?}");
                let radius = dot(state.point, state.point).sqrt();
                assert!(radius < 1.0 + 1e-6 && (what == "mesh" || radius > 1.0 - 1e-6));
            }
        }
    }
}

#[test]
fn a_sphere_at_a_grazing_angle_is_met_at_its_rim() {
    // Seen from 1000 radii away, rays that pass just inside the rim.
    let (hand, seen) = recorder();
    let mut builder = SceneBuilder::new(looking_from([0.0, 0.0, 1000.0]));
    let material = builder.material(hand);
    builder.sphere([0.0; 3], 1.0, &Transform::default(), material).unwrap();
    let scene = builder.build().unwrap();
    let mut context = Context::new(&scene, 64);
    let base = State { point: [0.0, 0.0, 1000.0], ..State::default() };
    for height in [0.999, 0.99999, 0.999_999_9] {
        let start = [0.0, height, 1000.0];
        let mut ray = ask(&base, [0.0, 0.0, -1.0], 0);
        ray.origin = start;
        let mut answers = [Answer::default()];
        context.trace(Trace::Reflection, &[base], &[ray], &mut answers);
        assert!(answers[0].hit, "{height}");
        let state = *seen.lock().unwrap().last().unwrap();
        assert!((state.point[1] - height).abs() < 1e-6 && state.dot_nd < 0.0);
        let expected = -(1.0 - f64::from(height).powi(2)).sqrt();
        assert!((f64::from(state.dot_nd) - expected).abs() < 1e-4 * expected.abs() + 1e-5);
    }
    let mut ray = ask(&base, [0.0, 0.0, -1.0], 0);
    ray.origin = [0.0, 1f32.next_up(), 1000.0];
    let mut answers = [Answer::default()];
    context.trace(Trace::Reflection, &[base], &[ray], &mut answers);
    assert!(!answers[0].hit);
}

#[test]
fn directions_of_any_length_are_normalised_and_impossible_ones_miss() {
    let mut builder = SceneBuilder::new(looking_from([0.0, 0.0, 5.0]));
    let white = Hand::material(|_, _, results| results.fill(Shaded { color: [1.0; 4], ok: true }));
    let material = builder.material(Arc::new(white));
    builder.mesh(&Mesh::rectangle(2.0, 2.0), &Transform::default(), material).unwrap();
    let scene = builder.build().unwrap();
    let mut context = Context::new(&scene, 64);
    let above = State { point: [0.1, 2.0, 0.2], ..State::default() };
    let mut answer = |direction: [f32; 3], kind| {
        let mut answers = [Answer { ok: true, ..Answer::default() }];
        context.trace(kind, &[above], &[ask(&above, direction, 0)], &mut answers);
        answers[0]
    };
    for length in [1.0, 1e-38, f32::MAX, f32::from_bits(1)] {
        let down = answer([0.0, -length, 0.0], Trace::Reflection);
        assert!(down.ok && down.hit, "{length}");
        assert!((down.distance - 2.0).abs() < 1e-6);
    }
    for wrong in [[0.0; 3], [-0.0; 3], [f32::NAN, -1.0, 0.0], [0.0, f32::NEG_INFINITY, 0.0]] {
        for kind in [Trace::Reflection, Trace::Refraction, Trace::Probe] {
            assert_eq!(answer(wrong, kind), Answer::default(), "{wrong:?}");
        }
    }
}
