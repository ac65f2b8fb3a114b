//! A closed tube of needles, some 10^9 times as long as they are wide, that share their corners: no ray gets out, of
//! a picture from inside or aimed at an edge.

use phenomenon_compiler::engine::Options;
use phenomenon_runtime::camera::Camera;
use phenomenon_runtime::geometry::{Mesh, PreparedRay, Transform};
use phenomenon_runtime::lights::Environment;
use phenomenon_runtime::scene::{Scene, SceneBuilder};

use crate::scenes::{pixels, shader};

/// Half the length of the tube; its radius is 1.
const HALF: f32 = 100.0;

/// Angles of the needles: gaps from a few units in the last place to an eighth of a turn, one after the other.
fn ring() -> Vec<[f32; 2]> {
    let mut angle = 0.0_f64;
    let mut ring = Vec::new();
    for turn in 0_i32.. {
        let at = [angle.cos() as f32, angle.sin() as f32];
        if ring.last() != Some(&at) {
            ring.push(at);
        }
        angle += 10.0_f64.powi(-(turn % 8)) * 0.7;
        if angle > 6.2 {
            return ring;
        }
    }
    ring
}

/// The tube with its two ends, which share the corners of the ring.
fn tube() -> Mesh {
    let ring = ring();
    let around = ring.len() as u32;
    let mut positions: Vec<[f32; 3]> = vec![[0.0, 0.0, -HALF], [0.0, 0.0, HALF]];
    for end in [-HALF, HALF] {
        positions.extend(ring.iter().map(|&[x, y]| [x, y, end]));
    }
    let mut triangles = Vec::new();
    for at in 0..around {
        let next = (at + 1) % around;
        let [a, b, c, d] = [2 + at, 2 + next, 2 + around + at, 2 + around + next];
        triangles.extend([[a, b, d], [a, d, c], [0, b, a], [1, c, d]]);
    }
    Mesh { positions, triangles, ..Mesh::default() }
}

fn scene(options: Options, place: [f64; 3]) -> Scene {
    let at = [0.1, -0.2, 0.3];
    let position = [0, 1, 2].map(|k| place[k] + at[k]);
    let camera = Camera::new(position, place, [0.0, 1.0, 0.0], 150.0).unwrap();
    let mut builder = SceneBuilder::new(camera);
    let material = builder.material(shader("plain.json", options));
    let transform = Transform::new([1.0; 3], [20.0, 130.0, 70.0], place);
    builder.mesh(&tube(), &transform, material).unwrap();
    builder.environment(Environment::Constant([1e6; 4]));
    builder.build().unwrap()
}

#[test]
fn no_ray_gets_out_of_a_picture() {
    for place in [[0.0; 3], [1000.0, -200.0, 500.0]] {
        let found = pixels(32, 4, |options| scene(options, place));
        assert!(found.iter().all(|pixel| *pixel == [1.0; 3]), "it leaks at {place:?}");
    }
}

#[test]
fn no_ray_gets_out_at_an_edge() {
    let place = [5.0, 0.5, -3.0];
    let transform = Transform::new([1.0; 3], [20.0, 130.0, 70.0], place);
    let mesh = tube().transformed(&transform).unwrap();
    let scene = scene(Options::default(), place);
    let mut shot = 0;
    for triangle in 0..mesh.triangles.len() {
        let corners = mesh.vertices(triangle);
        for edge in 0..3 {
            let (a, b) = (corners[edge], corners[(edge + 1) % 3]);
            for weight in [0.0, 1e-7, 0.3, 0.5] {
                let towards = [0, 1, 2].map(|k| {
                    let (a, b) = (f64::from(a[k]), f64::from(b[k]));
                    (a + (b - a) * weight - place[k]) as f32
                });
                let ray = PreparedRay::new(place.map(|x| x as f32), towards);
                assert!(
                    scene.intersect(&ray, f64::INFINITY).is_some(),
                    "{triangle} {edge} {weight}"
                );
                shot += 1;
            }
        }
    }
    assert!(shot > 1000, "{shot}");
}
