//! The picture depends on the scene, the size, the samples and the seed, and on nothing else.

use phenomenon_runtime::film::Film;
use phenomenon_runtime::geometry::{Mesh, Transform};
use phenomenon_runtime::lights::{Environment, Light, LightKind, Sphere};
use phenomenon_runtime::render::{RayCounts, RenderError, Settings, render};
use phenomenon_runtime::scene::Scene;

use crate::shaders::{ball, builder, glass, matte, normals};

fn scene(together: bool) -> Scene {
    let mut builder = builder();
    let floor = builder.material(matte(together));
    let clear = builder.material(glass(together));
    let solid = builder.material(normals());
    let lowered = Transform::new([1.0; 3], [0.0; 3], [0.0, -1.0, 0.0]);
    builder.mesh(&Mesh::rectangle(20.0, 20.0), &lowered, floor).unwrap();
    builder.sphere([-0.8, 0.0, 0.0], 1.0, &Transform::default(), clear).unwrap();
    let mut smooth = ball(2);
    smooth.smooth().unwrap();
    let beside = Transform::new([0.7; 3], [0.0; 3], [1.2, -0.3, 0.5]);
    builder.mesh(&smooth, &beside, clear).unwrap();
    builder.sphere([0.5, 0.5, -2.0], 0.8, &Transform::default(), solid).unwrap();
    let kind = LightKind::Point { position: [3.0, 5.0, 2.0] };
    builder.light(Light { name: "a".into(), power: [30.0; 3], kind });
    let kind = LightKind::Directional { direction: [0.3, -1.0, -0.4] };
    builder.light(Light { name: "b".into(), power: [0.5; 3], kind });
    let kind = LightKind::Sphere(Sphere::new([-3.0, 4.0, 1.0], 0.7, 3));
    builder.light(Light { name: "c".into(), power: [9.0; 3], kind });
    let kind = LightKind::Environment { samples: 2 };
    builder.light(Light { name: "d".into(), power: [0.3; 3], kind });
    builder.environment(Environment::Gradient {
        zenith: [0.2, 0.4, 0.8],
        horizon: [0.9; 3],
        ground: [0.2; 3],
    });
    builder.build().unwrap()
}

fn picture(scene: &Scene, settings: Settings) -> (Vec<[u32; 4]>, RayCounts, u64) {
    let rendered = render(scene, &settings, &|_, _| {}).unwrap();
    let bits = |film: &Film| film.pixels().iter().map(|p| p.map(f32::to_bits)).collect();
    (bits(&rendered.film), rendered.statistics.rays, rendered.statistics.points)
}

#[test]
fn threads_tiles_and_batches_change_no_bit() {
    let (together, alone) = (scene(true), scene(false));
    let base =
        Settings { width: 40, height: 29, samples: 5, seed: 3, threads: 1, ..Settings::default() };
    let first = picture(&together, base);
    assert!(first.1.shadow > 1000 && first.1.refraction > 1000);
    let distinct: std::collections::HashSet<_> = first.0.iter().collect();
    assert!(distinct.len() > 400, "the picture must show something: {}", distinct.len());
    for batch in [1, 7, 64] {
        assert!(picture(&together, Settings { batch, ..base }) == first, "batch {batch}");
    }
    for threads in [2, 3] {
        assert!(picture(&together, Settings { threads, ..base }) == first, "{threads} threads");
    }
    for tile in [1, 5, 64, u32::MAX] {
        assert!(picture(&together, Settings { tile, ..base }) == first, "tile {tile}");
    }
    assert!(picture(&alone, base) == first, "one ray at a time");
    assert!(picture(&alone, Settings { batch: 1, threads: 2, ..base }) == first);
    assert!(picture(&together, Settings { seed: 4, ..base }).0 != first.0);
}

#[test]
fn progress_counts_every_tile_once() {
    let scene = scene(true);
    let settings =
        Settings { width: 33, height: 17, samples: 1, threads: 2, ..Settings::default() };
    let done = std::sync::Mutex::new(Vec::new());
    render(&scene, &settings, &|tile, tiles| {
        assert_eq!(tiles, 6);
        done.lock().unwrap().push(tile);
    })
    .unwrap();
    let mut done = done.into_inner().unwrap();
    done.sort_unstable();
    assert_eq!(done, [1, 2, 3, 4, 5, 6]);
}

#[test]
fn impossible_settings_are_refused() {
    let scene = builder().build().unwrap();
    let with = |width, height, samples| {
        let settings = Settings { width, height, samples, ..Settings::default() };
        render(&scene, &settings, &|_, _| {})
    };
    assert!(matches!(with(0, 4, 1), Err(RenderError::Size(_))));
    assert!(matches!(with(1 << 16, 1 << 16, 1), Err(RenderError::Size(_))));
    assert!(matches!(with(u32::MAX, u32::MAX, 1), Err(RenderError::Size(_))));
    assert!(matches!(with(4, 4, 0), Err(RenderError::Samples(0))));
    // An empty scene is black.
    let rendered = with(4, 4, 1).unwrap();
    assert!(rendered.film.pixels().iter().all(|pixel| *pixel == [0.0; 4]));
}
