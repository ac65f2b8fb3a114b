//! Light that grazes what it falls on: a floor and a ball shadow themselves nowhere, down to heights of 10^-12, and what
//! they show is the cosine.

use phenomenon_compiler::engine::Options;
use phenomenon_runtime::camera::Camera;
use phenomenon_runtime::geometry::{Mesh, ShadowTerminator, Transform};
use phenomenon_runtime::lights::{Light, LightKind};
use phenomenon_runtime::scene::{Scene, SceneBuilder};

use crate::bounds::ROUNDING;
use crate::scenes::{dot, pixels, rays, shader};

const SIDE: u32 = 24;

fn camera() -> Camera {
    Camera::new([0.7, 2.9, 3.0], [0.0; 3], [0.0, 1.0, 0.0], 35.0).unwrap()
}

/// A scene of one object under one light from `towards`.
fn scene(options: Options, towards: [f64; 3], put: impl Fn(&mut SceneBuilder, u32)) -> Scene {
    let mut builder = SceneBuilder::new(camera());
    let material = builder.material(shader("lit.json", options));
    put(&mut builder, material);
    let direction = towards.map(|x| -x as f32);
    let kind = LightKind::Directional { direction };
    builder.light(Light { name: "light".into(), power: [1.0; 3], kind });
    builder.build().unwrap()
}

#[test]
fn floors_do_not_shadow_themselves() {
    // The second lies in a plane of no coordinate, and its light is turned with it.
    let degrees = [[0.0; 3], [10.0, 25.0, -15.0]];
    for (turn, degrees) in degrees.into_iter().enumerate() {
        let place = Transform::new([1.0, 3.0, 0.7], degrees, [0.01, 0.02, 0.03]);
        let turned = Transform::new([1.0; 3], degrees, [0.0; 3]);
        for height in [1e-2, 1e-4, 1e-6, 1e-12] {
            let towards = turned.normal([-1.0, height, 0.3_f64].into()).normalize().to_array();
            let normal = turned.normal([0.0, 1.0, 0.0].into()).normalize().to_array();
            let rectangle = |builder: &mut SceneBuilder, material| {
                builder.mesh(&Mesh::rectangle(30.0, 30.0), &place, material).unwrap();
            };
            let found = pixels(SIDE, 1, |options| scene(options, towards, rectangle));
            let expected = dot(towards, normal);
            // Normal and direction are rounded to 32 bits, and their product is.
            let allowed = 8.0 * ROUNDING + 4.0 * ROUNDING * expected;
            for pixel in &found {
                let value = f64::from(pixel[0]);
                // In a plane of a coordinate nothing is rounded but the height itself.
                let allowed = if turn == 0 { 8.0 * ROUNDING * expected } else { allowed };
                assert!(
                    (value - expected).abs() <= allowed,
                    "{height:e} {turn}: {pixel:?}, {expected:e}"
                );
            }
        }
    }
}

/// Where the cosine is below 0 it is dark, and nowhere else.
#[test]
fn balls_are_dark_only_on_their_far_side() {
    let towards = [0.8, 0.0, -0.6];
    let sphere = |builder: &mut SceneBuilder, material| {
        builder.sphere([0.0; 3], 1.0, &Transform::default(), material).unwrap();
    };
    let found = pixels(SIDE, 1, |options| scene(options, towards, sphere));
    let (mut lit, mut dark) = (0, 0);
    for (pixel, (origin, direction)) in found.iter().zip(rays(&camera(), SIDE)) {
        let squared = dot(direction, direction);
        let along = -dot(origin, direction) / squared;
        let closest = [0, 1, 2].map(|k| origin[k] + direction[k] * along);
        let rest = 1.0 - dot(closest, closest);
        if rest < 1e-9 {
            continue;
        }
        let point = [0, 1, 2].map(|k| closest[k] - direction[k] * (rest / squared).sqrt());
        let expected = dot(point, towards).max(0.0);
        let off = (f64::from(pixel[0]) - expected).abs();
        assert!(off <= 8.0 * ROUNDING, "{pixel:?} for {expected} at {point:?}");
        lit += u32::from(expected > 0.0);
        dark += u32::from(expected == 0.0);
    }
    assert!(lit > 50 && dark > 50, "{lit} {dark}");
}

/// A mesh of a ball, flat shaded: each face has one brightness, and none is spotted by shadows of its neighbours.
#[test]
fn faces_of_a_convex_mesh_do_not_shadow_each_other() {
    let towards = [0.8, 0.0, -0.6];
    let octahedron = Mesh {
        positions: vec![
            [1.0, 0.0, 0.0],
            [-1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, -1.0, 0.0],
            [0.0, 0.0, 1.0],
            [0.0, 0.0, -1.0],
        ],
        triangles: vec![
            [0, 2, 4],
            [2, 1, 4],
            [1, 3, 4],
            [3, 0, 4],
            [2, 0, 5],
            [1, 2, 5],
            [3, 1, 5],
            [0, 3, 5],
        ],
        ..Mesh::default()
    };
    let put = |builder: &mut SceneBuilder, material| {
        let facets = ShadowTerminator::Facets;
        builder.mesh_with(&octahedron, &Transform::default(), material, facets).unwrap();
    };
    let found = pixels(SIDE, 1, |options| scene(options, towards, put));
    let mut lit = 0;
    for (pixel, (origin, direction)) in found.iter().zip(rays(&camera(), SIDE)) {
        // The faces are |x| + |y| + |z| = 1: a ray meets the one that it enters last.
        let signs =
            (0..8).map(|bits: u32| [0, 1, 2].map(|k| if bits >> k & 1 == 0 { 1.0 } else { -1.0 }));
        let (mut enter, mut leave, mut face) = (f64::NEG_INFINITY, f64::INFINITY, [0.0; 3]);
        for sign in signs {
            let (speed, gap) = (dot(sign, direction), 1.0 - dot(sign, origin));
            if speed < 0.0 && gap / speed > enter {
                (enter, face) = (gap / speed, sign);
            } else if speed > 0.0 {
                leave = leave.min(gap / speed);
            }
        }
        if enter > leave - 1e-6 {
            continue;
        }
        let expected = (dot(face, towards) / 3.0_f64.sqrt()).max(0.0);
        let off = (f64::from(pixel[0]) - expected).abs();
        assert!(off <= 8.0 * ROUNDING, "{pixel:?} for {expected}");
        lit += u32::from(expected > 0.0);
    }
    assert!(lit > 50, "{lit}");
}
