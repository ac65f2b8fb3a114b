//! Answers depend on no field of the state that an effect does not declare to read: it may be poisoned.

use std::sync::Arc;

use phenomenon_compiler::effects::{Answer, Effect, LightMode, LightSample, Ray, Renderer, Trace};
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::state::{Field, Iterated, State};
use phenomenon_compiler::values::Type;
use phenomenon_runtime::geometry::{ShadowTerminator, Transform};
use phenomenon_runtime::lights::{Environment, Light, LightKind};
use phenomenon_runtime::render::{Context, Settings, render};
use phenomenon_runtime::scene::{Scene, SceneBuilder};

use crate::shaders::{Hand, ball, looking_from, recorder};

/// What a shader further on gets as the point has it, whatever scopes there changed; the renderer counts
/// levels by it.
const HANDED_ON: [Field; 8] = [
    Field::RayType,
    Field::ReflectionLevel,
    Field::RefractionLevel,
    Field::RasterX,
    Field::RasterY,
    Field::Ior,
    Field::IorIn,
    Field::Time,
];

fn words(field: Field, state: &State) -> Vec<u32> {
    let mut words = vec![0; field.value_type().width()];
    field.read(state, &mut words);
    words
}

/// A colour that tells apart all that a shader can know of its point.
fn told(state: &State) -> [f32; 4] {
    let all = Field::ALL.iter().flat_map(|field| words(*field, state));
    let hash = all.fold(1_u64, |hash, word| {
        phenomenon_runtime::sampling::mixed(hash ^ u64::from(word)).wrapping_add(1)
    });
    [0, 16, 32, 48].map(|shift| (hash >> shift & 0xffff) as f32 / 65_536.0)
}

/// The state with nonsense in all fields but those read and those handed on.
fn poisoned(state: &State, reads: &[Field]) -> State {
    let mut poisoned = *state;
    for &field in Field::ALL {
        if reads.contains(&field) || HANDED_ON.contains(&field) {
            continue;
        }
        let words = words(field, state).into_iter().map(|word| match field.value_type() {
            Type::Boolean => !word,
            Type::Integer => 0xdead,
            _ => 0x7fc0_dead,
        });
        field.write(&mut poisoned, &words.collect::<Vec<_>>());
    }
    poisoned
}

/// A smooth ball of triangles between a filter and a floor, all of which show what they are told, under
/// a lamp; and points on the ball, from outside and from inside.
fn scene() -> (Scene, Vec<State>) {
    let tell = |points: &[State], _: &mut dyn Renderer, results: &mut [Shaded]| {
        for (point, result) in points.iter().zip(results) {
            *result = Shaded { color: told(point), ok: true };
        }
    };
    let build = |material: Arc<Hand>| {
        let mut builder = SceneBuilder::new(looking_from([0.3, 0.5, 4.0]));
        let filter = Arc::new(Hand::material(tell).with_shadow(told).with_environment(tell));
        let (of_ball, of_filter) = (builder.material(material), builder.material(filter.clone()));
        let mut mesh = ball(1);
        mesh.smooth().unwrap();
        let smooth = ShadowTerminator::Smooth;
        builder.mesh_with(&mesh, &Transform::default(), of_ball, smooth).unwrap();
        builder.sphere([0.0, 1.8, 1.0], 0.4, &Transform::default(), of_filter).unwrap();
        builder.sphere([0.0, -9.0, 0.0], 7.0, &Transform::default(), of_filter).unwrap();
        let kind = LightKind::Point { position: [0.1, 4.0, 2.0] };
        builder.light(Light { name: "lamp".into(), power: [9.0; 3], kind });
        builder.environment(Environment::Shader(filter));
        builder.build().unwrap()
    };
    let (hand, seen) = recorder();
    let settings =
        Settings { width: 24, height: 24, samples: 1, threads: 1, ..Settings::default() };
    render(&build(hand), &settings, &|_, _| {}).unwrap();
    let mut points = std::mem::take(&mut *seen.lock().unwrap());
    let inside: Vec<State> = points.iter().map(|point| turned(*point)).collect();
    points.extend(inside);
    // The same ball, but light passes it.
    let glass = Hand::material(tell).with_shadow(told);
    (build(Arc::new(glass)), points)
}

/// The point as a ray from inside meets it.
fn turned(mut point: State) -> State {
    let back = |v: [f32; 3]| v.map(|x| -x);
    point.inv_normal = !point.inv_normal;
    (point.normal, point.normal_geom) = (back(point.normal), back(point.normal_geom));
    point.direction = back(point.direction);
    point
}

#[test]
fn rays_see_the_same_from_a_poisoned_state() {
    let (scene, points) = scene();
    assert!(points.len() > 200);
    for trace in Trace::ALL {
        let answers = |poison: bool| {
            let reads = Effect::from(trace).reads();
            let state = |point: &State| if poison { poisoned(point, reads) } else { *point };
            let states: Vec<State> = points.iter().map(state).collect();
            let ray = |(number, point): (u32, &State)| {
                let direction = match trace {
                    Trace::Transparent => point.direction,
                    _ => point.normal,
                };
                Ray { point: number, origin: point.point, direction, site: 5 }
            };
            let rays: Vec<Ray> = (0..).zip(&points).map(ray).collect();
            let mut context = Context::new(&scene, 64);
            let mut answers = vec![Answer::default(); rays.len()];
            context.trace(trace, &states, &rays, &mut answers);
            assert!(answers.iter().any(|answer| answer.ok), "{trace:?}");
            (answers, context.counts())
        };
        assert_eq!(answers(true), answers(false), "{trace:?}");
    }
}

#[test]
fn light_is_the_same_from_a_poisoned_state() {
    let (scene, points) = scene();
    let lit = |of_samples: &[Field], of_colors: &[Field]| {
        let poison = |reads: &[Field]| {
            points.iter().map(|point| poisoned(point, reads)).collect::<Vec<State>>()
        };
        let mut context = Context::new(&scene, 64);
        let list = context.light_list(&[], LightMode::Listed);
        let mut samples = vec![LightSample::default(); points.len()];
        context.light_samples(list, 0, poison(of_samples)[..].into(), &mut samples);
        let tokens: Vec<u64> = samples.iter().map(|sample| sample.token).collect();
        let mut colors = vec![[0.0; 3]; points.len()];
        context.light_colors(poison(of_colors)[..].into(), &tokens, &mut colors);
        (samples, colors, context.counts())
    };
    let expected = lit(Field::ALL, Field::ALL);
    assert!(expected.1.iter().any(|color| *color != [0.0; 3]));
    assert_eq!(lit(Iterated::Lights.reads(), Effect::LightColor.reads()), expected);
}
