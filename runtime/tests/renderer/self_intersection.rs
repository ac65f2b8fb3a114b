//! No surface meets itself where it must not, and none is missed where it must be met.
//!
//! `RAYS=10000000 cargo test --release -p phenomenon-runtime --test renderer self_intersection`
//! casts ten million rays of each kind; without it there are fewer.

use std::ops::Range;

use glam::DVec3;
use phenomenon_runtime::geometry::{Mesh, PreparedRay, RawHit, Surface, Transform, double};
use phenomenon_runtime::scene::{Scene, SceneBuilder};

use crate::shaders::{Numbers, ball, builder, normals};

/// Rays cast from each surface that was hit.
const FROM_EACH: usize = 50;

fn rays() -> usize {
    std::env::var("RAYS").ok().and_then(|rays| rays.parse().ok()).unwrap_or(200_000)
}

/// A number whose logarithm is evenly distributed.
fn decades(numbers: &mut Numbers, powers: Range<f64>) -> f64 {
    10f64.powf(powers.start + (powers.end - powers.start) * numbers.next())
}

fn signed(numbers: &mut Numbers) -> f64 {
    numbers.next() * 2.0 - 1.0
}

fn vector(numbers: &mut Numbers) -> DVec3 {
    DVec3::new(signed(numbers), signed(numbers), signed(numbers))
}

/// Where an object of a size lies: round the origin, near it, or so far out that its numbers have
/// a tenth of their digits left for it.
fn place(numbers: &mut Numbers, size: f64) -> [f64; 3] {
    let far = match (numbers.next() * 4.0) as u32 {
        0 => 0.0,
        1 => size,
        2 => size * decades(numbers, 0.0..3.0),
        _ => size * decades(numbers, -3.0..0.0),
    };
    (vector(numbers) * far).to_array()
}

fn turned(numbers: &mut Numbers, size: f64) -> Transform {
    let quarter = numbers.next() < 0.3;
    let degrees = [0, 1, 2].map(|_| {
        let angle = signed(numbers) * 360.0;
        if quarter { (angle / 90.0).round() * 90.0 } else { angle }
    });
    let stretch = [0, 1, 2].map(|_| size * decades(numbers, -0.5..0.5));
    let place = place(numbers, size);
    Transform::new(stretch, degrees, place)
}

/// The first hit of a ray from outside towards a point near `middle`, and the surface there.
fn hit(
    scene: &Scene,
    numbers: &mut Numbers,
    middle: DVec3,
    size: f64,
) -> Option<(RawHit, Surface)> {
    let away = size * decades(numbers, 0.0..3.0);
    let from = middle + DVec3::from(numbers.direction()) * away;
    let towards = (middle + vector(numbers) * size * 0.5 - from).normalize();
    let ray =
        PreparedRay::new(from.to_array().map(|x| x as f32), towards.to_array().map(|x| x as f32));
    let hit = scene.intersect(&ray, f64::INFINITY)?;
    Some((hit, scene.surface(ray.origin, ray.direction, &hit)))
}

/// A unit direction, as a shader gives it: every second grazes the surface, some of them exactly
/// along it as far as f32 can say.
fn direction(numbers: &mut Numbers, normal: DVec3) -> DVec3 {
    let free = DVec3::from(numbers.direction());
    let along = (free - normal * free.dot(normal)).normalize();
    let cosine = match (numbers.next() * 4.0) as u32 {
        0 => decades(numbers, -8.0..-1.0) * signed(numbers).signum(),
        1 => decades(numbers, -45.0..-8.0) * signed(numbers).signum(),
        _ => free.dot(normal),
    };
    let direction = along * (1.0 - cosine * cosine).max(0.0).sqrt() + normal * cosine;
    double(direction.to_array().map(|x| x as f32))
}

/// Casts rays from hits on scenes that `build` makes of one object of a size, and gives `judge` each
/// surface, ray and hit.
fn cast(
    seed: u64,
    build: impl Fn(&mut SceneBuilder, &mut Numbers, f64) -> DVec3,
    judge: impl Fn(&Scene, f64, (&RawHit, &Surface), DVec3, Option<RawHit>),
) {
    let mut numbers = Numbers(seed);
    let (mut cast, wanted) = (0, rays());
    while cast < wanted {
        let size = decades(&mut numbers, -6.0..6.0);
        let mut builder = builder();
        let middle = build(&mut builder, &mut numbers, size);
        let scene = builder.build().unwrap();
        for _ in 0..20 {
            let Some((first, surface)) = hit(&scene, &mut numbers, middle, size) else { continue };
            let normal = double(surface.normal_geom);
            for _ in 0..FROM_EACH {
                let direction = direction(&mut numbers, normal);
                let ray = PreparedRay::leaving(surface.position, surface.normal_geom, direction);
                let second = scene.intersect(&ray, f64::INFINITY);
                judge(&scene, size, (&first, &surface), direction, second);
                cast += 1;
            }
        }
    }
}

#[test]
fn self_intersection_of_planes_and_triangles_never_happens() {
    let build = |builder: &mut SceneBuilder, numbers: &mut Numbers, size: f64| {
        let material = builder.material(normals());
        let transform = turned(numbers, size);
        let mesh = match (numbers.next() * 3.0) as u32 {
            // One triangle, of any shape.
            0 => {
                let mut corner = || vector(numbers).to_array().map(|x| x as f32);
                let positions = vec![corner(), corner(), corner()];
                Mesh { positions, triangles: vec![[0, 1, 2]], ..Mesh::default() }
            }
            // Four corners in a plane of coordinates, whatever its height.
            1 => {
                let (axis, height) = ((numbers.next() * 3.0) as usize, signed(numbers) * size);
                let height = if numbers.next() < 0.3 { 0.0 } else { height } as f32;
                let mut mesh = Mesh::rectangle(size as f32, 3.0 * size as f32);
                for position in &mut mesh.positions {
                    position.rotate_left(axis);
                    position[(4 - axis) % 3] = height;
                }
                builder.mesh(&mesh, &Transform::default(), material).unwrap();
                let mut middle = DVec3::ZERO;
                middle[(4 - axis) % 3] = height.into();
                return middle;
            }
            _ => Mesh::rectangle(1.0, 1.0),
        };
        if builder.mesh(&mesh, &transform, material).is_err() {
            // Three corners in a row.
            builder.mesh(&Mesh::rectangle(1.0, 1.0), &transform, material).unwrap();
        }
        transform.translation
    };
    cast(1, build, |scene, size, (_, surface), direction, second| {
        let Some(second) = second else { return };
        // Rounded corners bend a turned rectangle by the last digit: the other half may be met
        // there, but only under so small an angle.
        let cosine = double(surface.normal_geom).dot(direction).abs();
        let bend = surface.position.length() / size * 1e-6 + 1e-6;
        assert!(
            scene.primitive_count() == 2 && cosine < bend,
            "size {size}: {surface:?} meets itself towards {direction:?}: {second:?}"
        );
    });
}

#[test]
fn self_intersection_of_spheres_never_happens_and_their_far_side_is_met() {
    let build = |builder: &mut SceneBuilder, numbers: &mut Numbers, size: f64| {
        let material = builder.material(normals());
        let center = place(numbers, size);
        builder.sphere(center, size, &Transform::default(), material).unwrap();
        DVec3::from(center)
    };
    cast(2, build, |_, size, (_, surface), direction, second| {
        let cosine = double(surface.normal_geom).dot(direction);
        match second {
            Some(hit) => {
                assert!(cosine < 0.0, "size {size}: {surface:?} meets itself: {hit:?}");
                let chord = -2.0 * size * cosine;
                // The normal is rounded to f32, the sphere's centre and radius too.
                assert!((hit.t - chord).abs() < 1e-6 * size, "{} for {chord}", hit.t);
                assert!(hit.inside);
            }
            None => assert!(cosine > -1e-7, "size {size}: {surface:?} lost its far side"),
        }
    });
}

#[test]
fn self_intersection_of_closed_meshes_never_happens_and_their_far_side_is_met() {
    let build = |builder: &mut SceneBuilder, numbers: &mut Numbers, size: f64| {
        let material = builder.material(normals());
        let degrees = [0, 1, 2].map(|_| signed(numbers) * 180.0);
        let far = if numbers.next() < 0.5 { 0.0 } else { size * decades(numbers, -2.0..1.0) };
        let transform = Transform::new([size; 3], degrees, (vector(numbers) * far).to_array());
        builder.mesh(&ball(2), &transform, material).unwrap();
        transform.translation
    };
    cast(3, build, |_, size, (_, surface), direction, second| {
        let cosine = double(surface.normal_geom).dot(direction);
        match second {
            // A rounded mesh is convex to within its last digits only.
            Some(hit) => assert!(cosine < 1e-4, "size {size}: {surface:?} meets itself: {hit:?}"),
            None => assert!(cosine > -1e-7, "size {size}: {surface:?} lost its far side"),
        }
    });
}

#[test]
fn close_panes_and_thin_shells_are_told_apart() {
    let build = |builder: &mut SceneBuilder, numbers: &mut Numbers, size: f64| {
        let material = builder.material(normals());
        // A pane and a second one above it, both in planes of coordinates.
        let gap = size * decades(numbers, -12.0..-3.0);
        for height in [0.0, gap] {
            let mut mesh = Mesh::rectangle(size as f32, size as f32);
            for position in &mut mesh.positions {
                position[1] = height as f32;
            }
            builder.mesh(&mesh, &Transform::default(), material).unwrap();
        }
        DVec3::ZERO
    };
    cast(4, build, |scene, size, (first, surface), direction, second| {
        let other = scene.intersect(
            &PreparedRay::leaving(surface.position, surface.normal_geom, {
                let away = if surface.position.y > 0.0 { -1.0 } else { 1.0 };
                DVec3::new(0.0, away, 0.0)
            }),
            f64::INFINITY,
        );
        let gap = other.expect("the other pane is met").t;
        assert!(gap > 0.9e-12 * size && gap < 1.1e-3 * size, "{first:?}: {gap} of {size}");
        let towards = direction.y * (if surface.position.y > 0.0 { -1.0 } else { 1.0 });
        let expected = gap / direction.y.abs();
        let there = surface.position + direction * expected;
        let within = there.x.abs().max(there.z.abs()) < 0.499 * size;
        assert!(
            second.is_some() || towards <= 0.0 || !within,
            "size {size}, gap {gap}: the other pane is missed towards {direction}"
        );
        if let Some(second) = second {
            let error = 1e-6 * expected + 1e-12 * size / direction.y.abs();
            assert!((second.t - expected).abs() <= error, "{} {expected}", second.t);
        }
    });
}

#[test]
fn what_a_light_touches_does_not_shadow_it() {
    let mut numbers = Numbers(5);
    for _ in 0..rays() / 100 {
        let size = decades(&mut numbers, -6.0..6.0);
        let mut builder = builder();
        let material = builder.material(normals());
        let height = (size * decades(&mut numbers, -1.0..1.0)) as f32;
        for y in [0.0, height] {
            let mut mesh = Mesh::rectangle(4.0 * size as f32, 4.0 * size as f32);
            for position in &mut mesh.positions {
                position[1] = y;
            }
            builder.mesh(&mesh, &Transform::default(), material).unwrap();
        }
        let scene = builder.build().unwrap();
        let lamp = DVec3::new(
            (signed(&mut numbers) * size) as f32 as f64,
            height.into(),
            (signed(&mut numbers) * size) as f32 as f64,
        );
        for _ in 0..100 {
            let floor = DVec3::new(signed(&mut numbers) * size, 0.0, signed(&mut numbers) * size);
            let ray = PreparedRay::to(floor, [0.0, 1.0, 0.0], lamp).unwrap();
            let mut met = 0;
            scene.every(&ray, |_| {
                met += 1;
                true
            });
            assert_eq!(met, 0, "size {size}: {lamp} from {floor}");
            // Behind the ceiling it is in shadow.
            let above = lamp + DVec3::new(0.0, size * 1e-3, 0.0);
            let ray = PreparedRay::to(floor, [0.0, 1.0, 0.0], above).unwrap();
            scene.every(&ray, |_| {
                met += 1;
                true
            });
            assert_eq!(met, 1, "size {size}: {above} from {floor}");
        }
    }
}

#[test]
fn a_lamp_on_a_ball_is_shadowed_by_what_lies_before_it_alone() {
    let mut numbers = Numbers(6);
    for _ in 0..rays() / 100 {
        let size = decades(&mut numbers, -6.0..6.0) as f32;
        let mut builder = builder();
        let material = builder.material(normals());
        builder.sphere([0.0; 3], size.into(), &Transform::default(), material).unwrap();
        let scene = builder.build().unwrap();
        let axis = (numbers.next() * 3.0) as usize;
        let mut lamp = DVec3::ZERO;
        lamp[axis] = f64::from(size) * signed(&mut numbers).signum();
        let met = |from: DVec3| {
            let ray = PreparedRay::to(from, [0.0; 3], lamp).unwrap();
            let mut met = 0;
            scene.every(&ray, |_| {
                met += 1;
                true
            });
            met
        };
        for _ in 0..20 {
            let inside = vector(&mut numbers) * f64::from(size) * 0.5;
            assert_eq!(met(inside), 0, "size {size}: {lamp} from {inside}");
            let before = lamp * decades(&mut numbers, 0.1..3.0) + inside * 0.1;
            assert_eq!(met(before), 0, "size {size}: {lamp} from {before}");
            let behind = -before;
            assert_eq!(met(behind), 1, "size {size}: {lamp} from {behind}");
        }
    }
}
