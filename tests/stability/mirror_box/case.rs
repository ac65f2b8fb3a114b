//! A closed box of mirrors: thirty-two bounces in a picture, a thousand by rays. Its light is a geometric series; nothing
//! gets out, and energy does not grow.

use phenomenon_compiler::engine::Options;
use phenomenon_runtime::geometry::PreparedRay;

use crate::bounds::ROUNDING;
use crate::scenes::{pixels, scene, text};

/// Reflections on a path, by the scene.
const DEPTH: i32 = 32;

/// The scene with mirrors of a share, all of which glow.
fn with(share: f64, glow: f64) -> String {
    let text = text("mirror_box");
    let changed =
        text.replace("\"share\": [1, 1, 1]", &format!("\"share\": [{share}, {share}, 1]"));
    let changed = changed.replace("\"glow\": [0, 0, 0]", &format!("\"glow\": [{glow}, 0, {glow}]"));
    assert!(changed != text || (share == 1.0 && glow == 0.0));
    changed
}

/// What walls glow with, summed up over all bounces; the last ray sees the sky, which is as bright as its colour.
fn series(share: f64, glow: f64) -> f64 {
    let sky = 1.0;
    (0..=DEPTH).fold(sky, |light, _| light * share + glow)
}

#[test]
fn light_in_a_box_of_mirrors_is_a_geometric_series() {
    for (share, glow) in [(1.0, 0.0), (1.0, 1.0), (0.5, 0.25), (0.999, 1e-3), (0.0, 3.0)] {
        let text = with(share, glow);
        let found = pixels(16, 1, |options| scene("mirror_box", &text, options));
        // Each bounce is a product and a sum.
        let allowed = |value: f64| value * ((1.0 + ROUNDING).powi(3 * (DEPTH + 2)) - 1.0);
        let share32 = f64::from(share as f32);
        let glow32 = f64::from(glow as f32);
        let expected = [series(share32, glow32), series(share32, 0.0), series(1.0, glow32)];
        for pixel in &found {
            for (value, expected) in pixel.iter().zip(expected) {
                let off = (f64::from(*value) - expected).abs();
                assert!(off <= allowed(expected), "{share} {glow}: {pixel:?} for {expected}");
            }
        }
        // Mirrors that add nothing do not make light.
        assert!(glow > 0.0 || found.iter().all(|pixel| pixel.iter().all(|x| *x <= 1.0)));
    }
}

/// Where a point comes to that goes straight on among mirrored boxes, in the first one.
fn folded(x: f64) -> f64 {
    let turn = (x + 1.0).rem_euclid(4.0);
    if turn < 2.0 { turn - 1.0 } else { 3.0 - turn }
}

#[test]
fn a_thousand_bounces_are_where_they_should_be() {
    const BOUNCES: u32 = 1000;
    let scene = scene("mirror_box", &text("mirror_box"), Options::default());
    let mut worst = 0.0_f64;
    for number in 1..=40_u32 {
        // Steep and grazing ways: parts of square roots, and next to nothing along one axis.
        let part = |of: f64| (f64::from(number) * of).fract() - 0.5;
        let along = [part(2.0_f64.sqrt()), part(3.0_f64.sqrt()), part(5.0_f64.sqrt())];
        let along = match number % 4 {
            0 => [along[0], along[1] * 1e-9, along[2]],
            1 => [along[0] * 1e-30, along[1], along[2] * 1e-5],
            _ => along,
        };
        let start = [0.1_f32, -0.2, 0.3];
        let way = along.map(|x| x as f32);
        let (mut ray, mut direction) = (PreparedRay::new(start, way), way.map(f64::from));
        let mut long = 0.0;
        for bounce in 0..BOUNCES {
            let hit = scene.intersect(&ray, f64::INFINITY);
            let hit = hit.unwrap_or_else(|| panic!("ray {number} got out at bounce {bounce}"));
            let surface = scene.surface(ray.origin, ray.direction, &hit);
            assert!(surface.normal_geom.iter().all(|x| x.fract() == 0.0), "the walls are straight");
            long += hit.t;
            for (axis, of) in surface.normal_geom.into_iter().enumerate() {
                if of != 0.0 {
                    direction[axis] = -direction[axis];
                }
            }
            ray = PreparedRay::leaving(surface.position, surface.normal_geom, direction.into());
            let found = surface.position.to_array();
            for axis in 0..3 {
                let straight = f64::from(start[axis]) + f64::from(way[axis]) * long;
                // Each bounce rounds a place and a way of about the size of the box.
                let allowed = 16.0 * f64::from(bounce + 1) * f64::EPSILON * (1.0 + straight.abs());
                let off = (found[axis] - folded(straight)).abs();
                worst = worst.max(off / allowed);
                assert!(off <= allowed, "ray {number}, bounce {bounce}: {found:?}, off by {off:e}");
            }
        }
    }
    println!("mirror_box: after a thousand bounces at most {worst:.2} of what is allowed");
}
