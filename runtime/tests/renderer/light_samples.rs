//! Lists of lights in their modes, and lights with several samples.

use phenomenon_compiler::effects::{LightList, LightMode, LightSample, Renderer};
use phenomenon_compiler::state::State;
use phenomenon_runtime::geometry::Transform;
use phenomenon_runtime::lights::{Disc, LIGHT_LIMIT, Light, LightKind, Rectangle, Sphere, Spot};
use phenomenon_runtime::render::Context;
use phenomenon_runtime::scene::{Scene, SceneBuilder};

use crate::shaders::{builder, normals};

const DOWN: [f64; 3] = [0.0, -1.0, 0.0];

fn light(name: &str, kind: LightKind) -> Light {
    Light { name: name.into(), power: [4.0, 8.0, 16.0], kind }
}

fn window(samples: u32) -> LightKind {
    let size = [2.0, 1.0];
    LightKind::Rectangle(
        Rectangle::new([0.0, 4.0, 0.0], DOWN, [0.0, 0.0, -1.0], size, samples).unwrap(),
    )
}

fn state(x: f32, path: u64) -> State {
    State {
        point: [x, 0.0, 0.0],
        normal: [0.0, 1.0, 0.0],
        normal_geom: [0.0, 1.0, 0.0],
        path,
        ..State::default()
    }
}

fn with(lights: impl IntoIterator<Item = Light>, add: impl Fn(&mut SceneBuilder)) -> Scene {
    let mut builder = builder();
    for light in lights {
        builder.light(light);
    }
    add(&mut builder);
    builder.build().unwrap()
}

/// What a list of lights sends to points: direction, distance and colour of each sample that reaches one.
fn arrivals(
    context: &mut Context<'_>,
    list: LightList,
    points: &[State],
) -> Vec<Vec<(LightSample, [f32; 3])>> {
    let mut found = vec![Vec::new(); points.len()];
    for turn in 0..context.light_count(list) {
        let mut samples = vec![LightSample::default(); points.len()];
        context.light_samples(list, turn, points.into(), &mut samples);
        let mut colors = vec![[0.0; 3]; points.len()];
        let tokens: Vec<u64> = samples.iter().map(|sample| sample.token).collect();
        context.light_colors(points.into(), &tokens, &mut colors);
        for ((sample, color), found) in samples.into_iter().zip(colors).zip(&mut found) {
            match sample.reachable {
                true => found.push((sample, color)),
                false => assert_eq!(color, [0.0; 3]),
            }
        }
    }
    found
}

fn sum(arrivals: &[(LightSample, [f32; 3])]) -> f32 {
    arrivals.iter().map(|(_, color)| color[0]).sum()
}

#[test]
fn modes_choose_lights() {
    let point = |x: f32| LightKind::Point { position: [x, 2.0, 0.0] };
    let scene =
        with([light("a", point(1.0)), light("b", point(2.0)), light("c", window(3))], |_| {});
    let mut context = Context::new(&scene, 8);
    let floor = [state(0.0, 1)];
    let mut lit = |names: &[&str], mode| {
        let names: Vec<String> = names.iter().map(|&name| name.to_owned()).collect();
        let list = context.light_list(&names, mode);
        let before = context.counts().shadow;
        let found = arrivals(&mut context, list, &floor).remove(0);
        assert_eq!(context.counts().shadow - before, found.len() as u64, "a ray for each sample");
        found.iter().map(|(sample, _)| sample.token as u32).collect::<Vec<u32>>()
    };
    assert_eq!(lit(&["b", "a"], LightMode::Listed), [1, 0]);
    assert_eq!(lit(&["b", "a", "b"], LightMode::Listed), [1, 0, 1]);
    assert_eq!(lit(&["b", "a", "b"], LightMode::Inclusive), [0, 1]);
    assert_eq!(lit(&["b"], LightMode::Exclusive), [0, 2, 2, 2]);
    assert_eq!(lit(&["a", "c"], LightMode::Exclusive), [1]);
    assert_eq!(lit(&["b"], LightMode::All), [0, 1, 2, 2, 2]);
    assert_eq!(lit(&[], LightMode::Listed), [0, 1, 2, 2, 2]);
    assert_eq!(lit(&[], LightMode::Exclusive), [0, 1, 2, 2, 2]);
    assert_eq!(lit(&[], LightMode::Inclusive), [0_u32; 0]);
    assert_eq!(lit(&["a", "b", "c"], LightMode::Exclusive), [0_u32; 0]);
}

#[test]
fn samples_of_a_light_are_averaged_and_differ_from_point_to_point() {
    let sphere = LightKind::Sphere(Sphere::new([0.0, 4.0, 0.0], 1.0, 16));
    let disc = LightKind::Disc(Disc::new([0.0, 4.0, 0.0], DOWN, 1.0, 16).unwrap());
    for kind in [window(16), sphere, disc] {
        let scene = with([light("a", kind)], |_| {});
        let mut context = Context::new(&scene, 3);
        let list = context.light_list(&[], LightMode::All);
        assert_eq!(context.light_count(list), 16);
        let points = [state(0.0, 1), state(0.0, 2), state(0.0, 1)];
        let found = arrivals(&mut context, list, &points);
        assert!(found.iter().all(|of_point| of_point.len() == 16));
        // About as much as of a point light: less where most of it is further away or seen slanted, and more of
        // a sphere, whose light comes from the sides too.
        for of_point in &found {
            let of_a_point_light = sum(of_point) / (4.0 / 16.0);
            assert!((0.85..1.02).contains(&of_a_point_light), "{kind:?} {of_a_point_light}");
        }
        assert_eq!(found[0], found[2], "chance is of the path");
        assert_ne!(found[0][0].0.direction, found[1][0].0.direction);
        // However the points are grouped.
        for (point, all) in points.iter().zip(&found) {
            let alone = arrivals(&mut context, list, &[*point]);
            assert_eq!(&alone[0], all);
        }
    }
}

#[test]
fn a_ball_before_a_window_casts_a_soft_shadow() {
    let scene = with([light("a", window(64))], |builder| {
        let material = builder.material(normals());
        builder.sphere([0.0, 2.0, 0.0], 0.4, &Transform::default(), material).unwrap();
    });
    let mut context = Context::new(&scene, 64);
    let list = context.light_list(&[], LightMode::All);
    let points: Vec<State> = (0..9).map(|at| state(0.3 * at as f32, at)).collect();
    let found = arrivals(&mut context, list, &points);
    let lit: Vec<usize> = found
        .iter()
        .map(|of_point| of_point.iter().filter(|(_, color)| color[0] > 0.0).count())
        .collect();
    assert!(lit.is_sorted_by(|a, b| *a <= *b + 3), "{lit:?}");
    let partly = lit.iter().filter(|lit| (4..60).contains(*lit)).count();
    assert!(lit[0] < 32 && lit[8] == 64 && partly >= 4, "{lit:?}");
}

#[test]
fn lights_of_any_size_send_finite_light_anywhere() {
    let near = |y: f32| State { point: [0.0, y, 0.0], ..state(0.0, 9) };
    let points: Vec<State> =
        [0.0, 4.0, 3.999_999_8, 3.9, -1e12, 1e12, 5.0, f32::NAN].map(near).into();
    for size in [0.0, 1e-12, 1.0, 1e6, 1e12] {
        let middle = [0.0, 4.0, 0.0];
        let kinds = [
            LightKind::Rectangle(
                Rectangle::new(middle, DOWN, [1.0, 0.0, 0.0], [size, 1.0], 3).unwrap(),
            ),
            LightKind::Rectangle(
                Rectangle::new(middle, DOWN, [1.0, 0.0, 0.0], [size; 2], 3).unwrap(),
            ),
            LightKind::Disc(Disc::new(middle, DOWN, size, 3).unwrap()),
            LightKind::Sphere(Sphere::new(middle, size, 3)),
            LightKind::Spot(
                Spot::new(middle, DOWN, 0.0, (10.0 * size).clamp(1e-3, 180.0)).unwrap(),
            ),
        ];
        for kind in kinds {
            let scene = with([Light { power: [1e30, 1.0, 1e-40], ..light("a", kind) }], |_| {});
            let mut context = Context::new(&scene, 8);
            let list = context.light_list(&[], LightMode::All);
            for (sample, color) in arrivals(&mut context, list, &points).into_iter().flatten() {
                assert!(
                    color.iter().all(|x| (0.0..=LIGHT_LIMIT).contains(x)),
                    "{kind:?} {color:?}"
                );
                let length: f32 = sample.direction.iter().map(|x| x * x).sum();
                assert!(
                    (length - 1.0).abs() < 1e-5 && sample.distance >= 0.0,
                    "{kind:?} {sample:?}"
                );
            }
        }
    }
}
