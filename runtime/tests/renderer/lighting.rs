//! Lights and their shadows.

use std::sync::Arc;

use phenomenon_compiler::effects::{LightSample, Renderer};
use phenomenon_compiler::state::{RayType, State};
use phenomenon_runtime::geometry::{Mesh, Transform};
use phenomenon_runtime::lights::{Light, LightKind};
use phenomenon_runtime::render::Context;
use phenomenon_runtime::scene::{Scene, SceneBuilder};

use crate::shaders::{Hand, builder, each, normals};

fn sun() -> Light {
    let kind = LightKind::Directional { direction: [0.0, -1.0, 0.0] };
    Light { name: "sun".into(), power: [2.0, 1.0, 0.5], kind }
}

fn lamp() -> Light {
    let kind = LightKind::Point { position: [0.0, 4.0, 0.0] };
    Light { name: "lamp".into(), power: [16.0; 3], kind }
}

fn floor_state(x: f32) -> State {
    State {
        point: [x, 0.0, 0.0],
        normal: [0.0, 1.0, 0.0],
        normal_geom: [0.0, 1.0, 0.0],
        ..State::default()
    }
}

fn colors(scene: &Scene, names: &[&str], iteration: usize, points: &[State]) -> Vec<[f32; 3]> {
    let mut context = Context::new(scene, 2);
    let names: Vec<String> = names.iter().map(|&name| name.to_owned()).collect();
    let list = context.light_list(&names);
    let mut colors = vec![[9.0; 3]; points.len()];
    context.light_colors(list, iteration, points, &mut colors);
    colors
}

fn filter(color: [f32; 4]) -> Arc<Hand> {
    Arc::new(Hand::material(each(|_| [0.0; 4])).with_shadow(move |state| {
        assert_eq!(state.ray_type, RayType::Shadow);
        assert!(state.dist > 0.0 && state.dot_nd <= 0.0);
        color
    }))
}

fn with(add: impl Fn(&mut SceneBuilder)) -> Scene {
    let mut builder = builder();
    builder.light(sun()).light(lamp());
    add(&mut builder);
    builder.build().unwrap()
}

#[test]
fn lights_are_listed_by_name_in_the_order_given() {
    let scene = with(|_| {});
    let mut context = Context::new(&scene, 8);
    let name = |names: &[&str]| names.iter().map(|&n| n.to_owned()).collect::<Vec<_>>();
    let all = context.light_list(&[]);
    assert_eq!(context.light_count(all), 2);
    let swapped = context.light_list(&name(&["lamp", "sun"]));
    assert_eq!(context.light_count(swapped), 2);
    let none = context.light_list(&name(&["moon"]));
    assert_eq!(context.light_count(none), 0);
    // Another thread's renderer gives equal lists equal numbers.
    assert_eq!(Context::new(&scene, 8).light_list(&name(&["lamp", "sun"])), swapped);
    let mut samples = [LightSample::default()];
    context.light_samples(swapped, 0, &[floor_state(0.0)], &mut samples);
    assert_eq!((samples[0].direction, samples[0].distance), ([0.0, 1.0, 0.0], 4.0));
    context.light_samples(all, 0, &[floor_state(0.0)], &mut samples);
    assert_eq!((samples[0].distance, samples[0].reachable), (0.0, true));
    context.light_samples(all, 7, &[floor_state(0.0)], &mut samples);
    assert!(!samples[0].reachable);
}

#[test]
fn open_points_get_all_light_and_covered_ones_none() {
    let scene = with(|builder| {
        let material = builder.material(normals());
        builder.sphere([0.0, 2.0, 0.0], 1.0, &Transform::default(), material).unwrap();
    });
    let points = [floor_state(0.0), floor_state(3.0), floor_state(0.5)];
    assert_eq!(colors(&scene, &["sun"], 0, &points), [[0.0; 3], [2.0, 1.0, 0.5], [0.0; 3]]);
    assert_eq!(colors(&scene, &["lamp"], 0, &points)[1], [16.0 / 25.0; 3]);
}

#[test]
fn filters_multiply_their_colours_on_both_sides_of_each() {
    let scene = with(|builder| {
        let red = builder.material(filter([1.0, 0.5, 0.25, 1.0]));
        let blue = builder.material(filter([0.5, 0.5, 1.0, 1.0]));
        builder.sphere([0.0, 1.5, 0.0], 0.5, &Transform::default(), red).unwrap();
        let sheet = Transform::new([1.0; 3], [0.0; 3], [0.0, 3.0, 0.0]);
        builder.mesh(&Mesh::rectangle(2.0, 2.0), &sheet, blue).unwrap();
    });
    // The sphere counts twice; the sheet once, though the ray runs through its diagonal.
    let expected = [2.0 * 0.5, 0.25 * 0.5, 0.0625 * 0.5];
    let points = [floor_state(0.0), floor_state(0.9), floor_state(5.0)];
    let found = colors(&scene, &["sun"], 0, &points);
    assert_eq!(found, [expected, [1.0, 0.5, 0.5], [2.0, 1.0, 0.5]]);
}

#[test]
fn behind_anything_opaque_no_filter_is_asked() {
    let scene = with(|builder| {
        let never = Hand::material(each(|_| [0.0; 4])).with_shadow(|_| unreachable!());
        let (never, opaque) = (builder.material(Arc::new(never)), builder.material(normals()));
        builder.sphere([0.0, 1.0, 0.0], 0.5, &Transform::default(), never).unwrap();
        builder.sphere([0.0, 2.5, 0.0], 0.5, &Transform::default(), opaque).unwrap();
    });
    let mut context = Context::new(&scene, 8);
    let list = context.light_list(&[]);
    let mut colors = [[1.0; 3]];
    context.light_colors(list, 0, &[floor_state(0.0)], &mut colors);
    assert_eq!(colors[0], [0.0; 3]);
    assert_eq!((context.counts().shadow, context.points()), (1, 0));
}

#[test]
fn the_second_filter_is_not_asked_once_the_first_is_black() {
    let scene = with(|builder| {
        let black = builder.material(filter([0.0; 4]));
        let sheet = |y: f64| Transform::new([1.0; 3], [0.0; 3], [0.3, y, 0.1]);
        for y in [1.0, 2.0, 3.0] {
            builder.mesh(&Mesh::rectangle(2.0, 2.0), &sheet(y), black).unwrap();
        }
    });
    let mut context = Context::new(&scene, 8);
    let list = context.light_list(&[]);
    let mut colors = [[1.0; 3]];
    context.light_colors(list, 0, &[floor_state(0.0)], &mut colors);
    assert_eq!((colors[0], context.points()), ([0.0; 3], 1));
}

#[test]
fn what_lies_behind_a_lamp_casts_no_shadow() {
    let scene = with(|builder| {
        let material = builder.material(normals());
        builder.sphere([0.0, 6.0, 0.0], 1.0, &Transform::default(), material).unwrap();
    });
    assert_eq!(colors(&scene, &["lamp"], 0, &[floor_state(0.0)]), [[1.0; 3]]);
    assert_eq!(colors(&scene, &["sun"], 0, &[floor_state(0.0)]), [[0.0; 3]]);
}
