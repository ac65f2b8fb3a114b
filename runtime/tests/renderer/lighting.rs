//! Lights and their shadows.

use std::sync::Arc;

use phenomenon_compiler::effects::{LightList, LightMode, LightSample, Points, Renderer};
use phenomenon_compiler::state::{RayType, State};
use phenomenon_runtime::geometry::{Mesh, ShadowTerminator, Transform};
use phenomenon_runtime::lights::{Light, LightKind};
use phenomenon_runtime::render::{Context, Settings, render};
use phenomenon_runtime::scene::{Scene, SceneBuilder};

use crate::shaders::{Hand, ball, builder, dot, each, looking_from, normals, recorder};

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
    let list = context.light_list(&names, LightMode::Listed);
    let mut colors = vec![[9.0; 3]; points.len()];
    let tokens = tokens(&mut context, list, iteration, points);
    context.light_colors(points.into(), &tokens, &mut colors);
    colors
}

/// The tokens by which a light is known at the points.
fn tokens(
    context: &mut Context<'_>,
    list: LightList,
    iteration: usize,
    points: &[State],
) -> Vec<u64> {
    let mut samples = vec![LightSample::default(); points.len()];
    context.light_samples(list, iteration, points.into(), &mut samples);
    samples.iter().map(|sample| sample.token).collect()
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
    let all = context.light_list(&[], LightMode::Listed);
    assert_eq!(context.light_count(all), 2);
    let swapped = context.light_list(&name(&["lamp", "sun"]), LightMode::Listed);
    assert_eq!(context.light_count(swapped), 2);
    let none = context.light_list(&name(&["moon"]), LightMode::Listed);
    assert_eq!(context.light_count(none), 0);
    // Asked again, a renderer gives the same number: it looks for names once.
    assert_eq!(context.light_list(&name(&["lamp", "sun"]), LightMode::Listed), swapped);
    let mut samples = [LightSample::default()];
    let floor = [floor_state(0.0)];
    let floor = Points::from(&floor[..]);
    context.light_samples(swapped, 0, floor, &mut samples);
    assert_eq!((samples[0].direction, samples[0].distance), ([0.0, 1.0, 0.0], 4.0));
    context.light_samples(all, 0, floor, &mut samples);
    assert_eq!((samples[0].distance, samples[0].reachable), (0.0, true));
    context.light_samples(all, 7, floor, &mut samples);
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
    let list = context.light_list(&[], LightMode::Listed);
    let mut colors = [[1.0; 3]];
    let tokens = tokens(&mut context, list, 0, &[floor_state(0.0)]);
    context.light_colors((&[floor_state(0.0)][..]).into(), &tokens, &mut colors);
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
    let list = context.light_list(&[], LightMode::Listed);
    let mut colors = [[1.0; 3]];
    let tokens = tokens(&mut context, list, 0, &[floor_state(0.0)]);
    context.light_colors((&[floor_state(0.0)][..]).into(), &tokens, &mut colors);
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

/// Of the points of a coarse round mesh that face the light, those that lie in shadow.
fn dark_points(scale: f64, turned: f64, terminator: ShadowTerminator) -> (usize, usize) {
    let mut mesh = ball(1);
    mesh.smooth().unwrap();
    let transform = Transform::new([scale; 3], [0.0, turned, 0.0], [0.0; 3]);
    let mut builder = SceneBuilder::new(looking_from([0.0, 0.0, 3.0 * scale]));
    let (hand, seen) = recorder();
    let material = builder.material(hand);
    builder.mesh_with(&mesh, &transform, material, terminator).unwrap();
    let kind = LightKind::Directional { direction: [-1.0, -0.35, -0.2] };
    builder.light(Light { name: "sun".into(), power: [1.0; 3], kind });
    let scene = builder.build().unwrap();
    let whole = Settings::default();
    let settings = Settings { width: 64, height: 64, samples: 1, threads: 1, ..whole };
    render(&scene, &settings, &|_, _| {}).unwrap();
    let sun = [1.0f32, 0.35, 0.2].map(|x| x / 1.078_f32);
    let lit: Vec<State> = std::mem::take(&mut *seen.lock().unwrap())
        .into_iter()
        .filter(|state| dot(state.normal, sun) > 0.01)
        .collect();
    let colors = colors(&scene, &[], 0, &lit);
    (colors.iter().filter(|color| **color == [0.0; 3]).count(), lit.len())
}

#[test]
fn a_coarse_round_mesh_shows_no_facets_where_light_ends() {
    for scale in [1e-6, 1.0, 1e6] {
        for turned in [0.0, 10.0, 37.0, 80.0] {
            let (dark, of) = dark_points(scale, turned, ShadowTerminator::Smooth);
            assert!(of > 300, "only {of} points face the light");
            assert_eq!(dark, 0, "scale {scale} turned {turned}: of {of}");
            let (dark, of) = dark_points(scale, turned, ShadowTerminator::Facets);
            assert!(dark > of / 50, "scale {scale} turned {turned}: {dark} of {of}");
        }
    }
}

#[test]
fn light_from_next_to_nothing_away_is_finite() {
    for distance in [1e-45_f32, 1e-30, 1e-20, 1e-10] {
        let kind = LightKind::Point { position: [0.0, distance, 0.0] };
        let mut builder = builder();
        builder.light(Light { name: "near".into(), power: [4.0, 1e30, 1e-40], kind });
        let scene = builder.build().unwrap();
        let points = [floor_state(0.0), floor_state(1e-6), floor_state(0.5), floor_state(1e12)];
        for color in colors(&scene, &[], 0, &points).into_iter().flatten() {
            assert!((0.0..=phenomenon_runtime::lights::LIGHT_LIMIT).contains(&color), "{color}");
        }
    }
}
