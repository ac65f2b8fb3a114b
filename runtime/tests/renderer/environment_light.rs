//! The environment as a light of the scene.

use phenomenon_compiler::effects::{Answer, LightMode, LightSample, Ray, Renderer, Trace};
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::state::{RayType, State};
use phenomenon_runtime::film::Film;
use phenomenon_runtime::geometry::Transform;
use phenomenon_runtime::lights::{Environment, EnvironmentImage, LIGHT_LIMIT, Light, LightKind};
use phenomenon_runtime::render::{Context, Entry, Settings, render};
use phenomenon_runtime::scene::Scene;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::shaders::{Hand, builder, dot, each, matte, normals};

const UP: [f32; 3] = [0.0, 1.0, 0.0];

fn lit_by(environment: Option<Environment>, samples: u32, ball: bool) -> Scene {
    let mut builder = builder();
    let kind = LightKind::Environment { samples };
    builder.light(Light { name: "sky".into(), power: [1.0; 3], kind });
    if let Some(environment) = environment {
        builder.environment(environment);
    }
    if ball {
        let material = builder.material(normals());
        builder.sphere([0.0, 3.0, 0.0], 1.0, &Transform::default(), material).unwrap();
    }
    builder.build().unwrap()
}

fn image(width: u32, height: u32, color: impl Fn(u32, u32) -> f32) -> Option<Environment> {
    let mut film = Film::new(width, height).unwrap();
    for row in 0..height {
        for column in 0..width {
            film.set(column, row, [color(column, row), 0.0, 0.0, 1.0]);
        }
    }
    Some(Environment::Image(Arc::new(EnvironmentImage { film, intensity: 1.0, rotation: 0.0 })))
}

fn floor(path: u64) -> State {
    State { normal: UP, normal_geom: UP, path, ..State::default() }
}

/// All samples as a point sees them, and what they send.
fn arrivals(context: &mut Context<'_>, point: State) -> Vec<(LightSample, [f32; 3])> {
    let points = [point];
    let list = context.light_list(&[], LightMode::All);
    let mut found = Vec::new();
    for turn in 0..context.light_count(list) {
        let (mut sample, mut color) = ([LightSample::default()], [[0.0; 3]]);
        context.light_samples(list, turn, (&points[..]).into(), &mut sample);
        context.light_colors((&points[..]).into(), &[sample[0].token], &mut color);
        if sample[0].reachable {
            let mut density = [0.0];
            context.light_density(&[sample[0].direction], &mut density);
            assert!((density[0] / sample[0].density - 1.0).abs() < 1e-3, "{density:?} {sample:?}");
            found.push((sample[0], color[0]));
        } else {
            assert_eq!(color[0], [0.0; 3]);
        }
    }
    found
}

/// What white that is matt shows of it.
fn irradiance(found: &[(LightSample, [f32; 3])]) -> f32 {
    found.iter().map(|(sample, color)| color[0] * dot(sample.direction, UP).max(0.0)).sum()
}

#[test]
fn a_white_sky_makes_white_white_and_a_ball_before_it_a_shadow() {
    let white = || Some(Environment::Constant([1.0; 4]));
    let open = lit_by(white(), 256, false);
    let mut context = Context::new(&open, 16);
    let lit = irradiance(&arrivals(&mut context, floor(1)));
    assert!((lit - 1.0).abs() < 0.01, "{lit}");
    assert_eq!(context.counts().shadow, 256);
    let covered = lit_by(white(), 256, true);
    // A ball of radius 1 at distance 3 takes 1/9 from a floor that faces it.
    let lit = irradiance(&arrivals(&mut Context::new(&covered, 16), floor(1)));
    assert!((lit - 8.0 / 9.0).abs() < 0.01, "{lit}");
}

#[test]
fn a_sun_of_one_pixel_is_found_by_four_samples() {
    let sun = |column: u32, row: u32| match (column, row) {
        (20, 5) => 1e5,
        _ if row < 16 => 0.5,
        _ => 0.0,
    };
    let found = |samples, path| {
        let scene = lit_by(image(64, 32, sun), samples, false);
        irradiance(&arrivals(&mut Context::new(&scene, 16), floor(path)))
    };
    let all = found(256, 7);
    for path in 0..20 {
        let few = found(4, path);
        assert!((few / all - 1.0).abs() < 0.25, "{few} {all}");
    }
}

#[test]
fn skies_without_light_send_nothing_and_all_numbers_are_finite() {
    let odd = |value: f32| Some(Environment::Constant([value, 1.0, 0.0, 1.0]));
    for environment in [None, image(4, 2, |_, _| 0.0), Some(Environment::Constant([0.0; 4]))] {
        let scene = lit_by(environment, 4, false);
        let mut context = Context::new(&scene, 16);
        assert!(arrivals(&mut context, floor(1)).is_empty());
        assert_eq!(context.counts().shadow, 0);
        let mut density = [1.0];
        context.light_density(&[UP], &mut density);
        assert_eq!(density, [0.0]);
    }
    let poles = image(3, 4, |_, row| if row == 0 || row == 3 { f32::MAX } else { 0.0 });
    for environment in [odd(f32::NAN), odd(-3.0), odd(f32::INFINITY), odd(f32::MAX), poles] {
        let scene = lit_by(environment, 64, false);
        let mut context = Context::new(&scene, 16);
        for (sample, color) in arrivals(&mut context, floor(1)) {
            assert!(color.iter().all(|x| (0.0..=LIGHT_LIMIT).contains(x)), "{color:?}");
            assert!(sample.density.is_finite() && sample.density > 0.0);
        }
        let mut densities = [0.0; 3];
        let nowhere = [[0.0; 3], [f32::NAN; 3], [0.0, f32::INFINITY, 0.0]];
        context.light_density(&nowhere, &mut densities);
        assert_eq!(densities, [0.0; 3]);
    }
}

#[test]
fn the_length_of_a_direction_does_not_matter() {
    let scene = lit_by(image(8, 64, |column, row| (column * row) as f32), 3, false);
    let mut context = Context::new(&scene, 16);
    for [x, y, z] in [[0.6, 0.8, 0.0], [0.0, -0.28, 0.96], [-0.36, 0.48, 0.8]] {
        let scales = [1.0, 0.25, 8.0, 2.0_f32.powi(-60), 2.0_f32.powi(60)];
        let directions = scales.map(|by| [x * by, y * by, z * by]);
        let mut densities = [0.0; 5];
        context.light_density(&directions, &mut densities);
        assert!(densities[0] > 0.0);
        assert_eq!(densities, [densities[0]; 5]);
    }
}

#[test]
fn what_looks_at_the_sky_is_counted() {
    let calls = Arc::new(AtomicU64::new(0));
    let counted = calls.clone();
    let shade = move |points: &[State], renderer: &mut dyn Renderer, results: &mut [Shaded]| {
        counted.fetch_add(points.len() as u64, Ordering::Relaxed);
        // A shader with rays of its own: each meets nothing, and an environment's sees none.
        let rays: Vec<Ray> = (0..points.len() as u32)
            .map(|point| Ray { point, origin: [0.0; 3], direction: UP, site: 1 })
            .collect();
        renderer.trace(Trace::Probe, points, &rays, &mut vec![Answer::default(); points.len()]);
        results.fill(Shaded { color: [1.0; 4], ok: true });
    };
    let shader = Arc::new(Hand::default().with_environment(shade));
    let mut builder = builder();
    let kind = LightKind::Environment { samples: 2 };
    builder.light(Light { name: "sky".into(), power: [1.0; 3], kind });
    builder.environment(Environment::Shader(shader));
    let material = builder.material(matte(true));
    builder.sphere([0.0; 3], 1.0, &Transform::default(), material).unwrap();
    let scene = builder.build().unwrap();
    let settings = Settings { width: 8, height: 8, samples: 1, threads: 2, ..Settings::default() };
    for looks in [512 * 256, 0] {
        calls.store(0, Ordering::Relaxed);
        let rendered = render(&scene, &settings, &|_, _| {}).unwrap();
        let (calls, cost) = (calls.load(Ordering::Relaxed), &rendered.costs);
        let statistics = rendered.statistics;
        assert!((looks + 50..looks + 100).contains(&calls), "{calls}");
        assert_eq!(cost.of(Entry::EnvironmentShader).count, calls);
        assert_eq!((statistics.rays.probe, cost.of(Entry::Probe).count), (calls, calls));
        let on_the_ball = 64 - statistics.rays.environment;
        assert_eq!(statistics.points, calls + on_the_ball);
    }
}

#[test]
fn a_shader_of_the_sky_is_asked_where_samples_lie_and_is_not_lit_itself() {
    let half = |state: &State| {
        let light = if state.direction[0] > 0.0 { 2.0 } else { 0.0 };
        assert_eq!(state.ray_type, RayType::Environment);
        [light, 0.5 * light, 0.0, 1.0]
    };
    let shader = Hand::default().with_environment(each(half));
    let scene = lit_by(Some(Environment::Shader(Arc::new(shader))), 256, false);
    let mut context = Context::new(&scene, 16);
    let found = arrivals(&mut context, floor(3));
    let lit = irradiance(&found);
    assert!((lit - 1.0).abs() < 0.02, "{lit}");
    let dark = found.iter().filter(|(sample, _)| sample.direction[0] < 0.0).count();
    assert!(dark < 8, "only what is drawn evenly lies in the dark: {dark}");
    // Another that lights itself: it gets nothing.
    let itself = |points: &[State], renderer: &mut dyn Renderer, results: &mut [Shaded]| {
        let list = renderer.light_list(&[], LightMode::All);
        let (mut sample, mut density) = ([LightSample::default()], [1.0]);
        for (point, result) in points.iter().zip(results) {
            let point = std::slice::from_ref(point);
            renderer.light_samples(list, 0, point.into(), &mut sample);
            renderer.light_density(&[UP], &mut density);
            assert!(!sample[0].reachable && density == [0.0]);
            *result = Shaded { color: [1.0; 4], ok: true };
        }
    };
    let shader = Hand::default().with_environment(itself);
    let scene = lit_by(Some(Environment::Shader(Arc::new(shader))), 64, false);
    let lit = irradiance(&arrivals(&mut Context::new(&scene, 16), floor(3)));
    assert!((lit - 1.0).abs() < 0.03, "{lit}");
}
