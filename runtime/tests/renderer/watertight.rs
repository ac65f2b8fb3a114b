//! No ray slips through a closed mesh.

use phenomenon_runtime::geometry::{PreparedRay, Transform};

use crate::shaders::{Numbers, ball, builder, normals};

/// Shoots from inside a closed ball exactly at vertices, edge middles and points of edges.
fn shoot(scale: f64, offset: [f64; 3]) {
    let transform = Transform::new([scale, scale * 0.7, scale * 1.3], [10.0, 20.0, 30.0], offset);
    let mesh = ball(3).transformed(&transform).unwrap();
    let mut builder = builder();
    let material = builder.material(normals());
    builder.mesh(&mesh, &Transform::default(), material).unwrap();
    let scene = builder.build().unwrap();
    let origin = offset.map(|x| x as f32);
    let mut numbers = Numbers(1);
    for triangle in 0..mesh.triangles.len() {
        let corners = mesh.vertices(triangle);
        for edge in 0..3 {
            let (a, b) = (corners[edge], corners[(edge + 1) % 3]);
            for weight in [0.0, 0.5, 1e-7, numbers.next()] {
                let target = [0, 1, 2]
                    .map(|k| f64::from(a[k]) + (f64::from(b[k]) - f64::from(a[k])) * weight);
                let direction = [0, 1, 2].map(|k| (target[k] - f64::from(origin[k])) as f32);
                let length = direction.iter().map(|x| x * x).sum::<f32>().sqrt();
                let ray = PreparedRay::new(origin, direction.map(|x| x / length));
                let hit = scene.intersect(&ray, f64::INFINITY);
                assert!(hit.is_some(), "scale {scale}: leak at {target:?} of triangle {triangle}");
            }
        }
    }
}

#[test]
fn edges_and_vertices_do_not_leak() {
    shoot(1.0, [0.0; 3]);
    shoot(1e-4, [0.0; 3]);
    shoot(1e6, [0.0; 3]);
    shoot(1.0, [1000.0, -2000.0, 500.0]);
}

#[test]
fn rays_along_the_axes_do_not_leak() {
    let mut builder = builder();
    let material = builder.material(normals());
    builder.mesh(&ball(4), &Transform::default(), material).unwrap();
    let scene = builder.build().unwrap();
    for direction in
        [[1.0, 0.0, 0.0], [-1.0, -0.0, 0.0], [0.0, 1.0, -0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]
    {
        for shift in [0.0, -0.0, f32::from_bits(1), 1e-20, 0.25, -0.5] {
            let origin = direction.map(|x: f32| if x == 0.0 { shift } else { 0.0 });
            let hit = scene.intersect(&PreparedRay::new(origin, direction), f64::INFINITY);
            assert!(hit.is_some(), "{origin:?} {direction:?}");
        }
    }
}
