//! What no root reads is not worked out: looked for in the points themselves, not in what is counted.

use std::sync::{Arc, Mutex};

use phenomenon_compiler::effects::Trace;
use phenomenon_compiler::state::{Cone, Field, State};
use phenomenon_runtime::geometry::{ShadowTerminator, Transform};
use phenomenon_runtime::lights::{Light, LightKind};
use phenomenon_runtime::render::{Settings, render};
use phenomenon_runtime::scene::SceneBuilder;

use crate::shaders::{Hand, ball, looking_from, mirrored, trace};

/// The points at which a shader is called that reads these fields: of camera rays, of reflection rays and of shadow
/// rays, on triangles and on a sphere.
fn points(fields: &[Field]) -> Vec<State> {
    let seen = Arc::new(Mutex::new(Vec::new()));
    let (of_rays, of_shadows) = (Arc::clone(&seen), Arc::clone(&seen));
    let hand = Hand::material(move |points, renderer, _| {
        of_rays.lock().unwrap().extend_from_slice(points);
        trace(renderer, Trace::Reflection, points, true, mirrored);
        let list = renderer.light_list(&[], Default::default());
        let mut samples = vec![Default::default(); points.len()];
        renderer.light_samples(list, 0, points.into(), &mut samples);
        let tokens: Vec<u64> = samples.iter().map(|sample| sample.token).collect();
        renderer.light_colors(points.into(), &tokens, &mut vec![[0.0; 3]; points.len()]);
    });
    let hand = hand.with_shadow(move |point| {
        of_shadows.lock().unwrap().push(*point);
        [0.5; 4]
    });
    let mut builder = SceneBuilder::new(looking_from([0.3, 0.5, 4.0]));
    let material = builder.material(Arc::new(hand.reading(fields)));
    let smooth = ShadowTerminator::Smooth;
    builder.mesh_with(&ball(1), &Transform::default(), material, smooth).unwrap();
    builder.sphere([0.0, -9.0, 0.0], 7.9, &Transform::default(), material).unwrap();
    builder.sphere([0.3, 1.6, 0.2], 0.4, &Transform::default(), material).unwrap();
    let kind = LightKind::Point { position: [0.1, 4.0, 2.0] };
    builder.light(Light { name: "lamp".into(), power: [9.0; 3], kind });
    let size = Settings { width: 16, height: 16, samples: 1, threads: 1, ..Settings::default() };
    render(&builder.build().unwrap(), &size, &|_, _| {}).unwrap();
    std::mem::take(&mut seen.lock().unwrap())
}

#[test]
fn hits_have_coordinates_and_rays_cones_only_for_those_who_read_them() {
    let nothing = points(&[Field::Normal]);
    let (placed, covered) = (points(&[Field::U]), points(&[Field::DpDx]));
    assert_eq!((nothing.len(), nothing.len()), (placed.len(), covered.len()));
    for ray_type in ["eye", "reflection", "shadow"] {
        let of = |states: &[State], what: &dyn Fn(&State) -> bool| {
            let states = states.iter().filter(|state| state.ray_type.name() == ray_type);
            states.filter(|state| what(state)).count()
        };
        let has_uv = |state: &State| state.uv != [0.0; 2];
        let has_cone = |state: &State| state.hit.cone != Cone::default();
        assert!(of(&nothing, &|_| true) > 10, "{ray_type}");
        assert_eq!((of(&nothing, &has_uv), of(&nothing, &has_cone)), (0, 0), "{ray_type}");
        assert!(of(&placed, &has_uv) > 10, "{ray_type}");
        assert_eq!(of(&placed, &has_cone), 0, "{ray_type}");
        assert_eq!(of(&covered, &has_uv), 0, "{ray_type}");
        if ray_type != "shadow" {
            assert!(of(&covered, &has_cone) > 10, "{ray_type}");
        }
    }
}
