//! Faces of any shape are cut into triangles that cover them once.

use phenomenon_runtime::bvh::{PrimitiveId, Tree};
use phenomenon_runtime::geometry::{Mesh, Normals, ObjFault, PreparedRay, Primitive, parse_obj};

use crate::shaders::Numbers;

type Point = [f64; 2];

/// The mesh of one face with these corners; how many triangles had no area.
fn face(corners: &[[f32; 3]]) -> (Mesh, usize) {
    let mut text = String::new();
    for [x, y, z] in corners {
        text += &format!("v {x} {y} {z}\n");
    }
    text += "f";
    for at in 1..=corners.len() {
        text += &format!(" {at}");
    }
    let read =
        parse_obj(text.as_bytes(), Normals::Flat).unwrap_or_else(|e| panic!("{e:?}\n{text}"));
    (read.mesh, read.flat_triangles)
}

fn cross(a: Point, b: Point, c: Point) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Twice the area by the shoelace formula.
fn shoelace(polygon: &[Point]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum()
}

fn crosses(a: Point, b: Point, c: Point, d: Point) -> bool {
    cross(a, b, c) * cross(a, b, d) < 0.0 && cross(c, d, a) * cross(c, d, b) < 0.0
}

/// A random polygon without crossings: crossing edges are exchanged until there are none.
fn simple_polygon(numbers: &mut Numbers, count: usize) -> Vec<Point> {
    // Few places, so that corners lie on lines and columns together.
    let mut point = || [0, 1].map(|_| (numbers.next() * 64.0).floor() / 4.0 - 8.0);
    let mut polygon: Vec<Point> = Vec::new();
    while polygon.len() < count {
        let point = point();
        if !polygon.contains(&point) {
            polygon.push(point);
        }
    }
    loop {
        let mut changed = false;
        for i in 0..count {
            for j in i + 2..count {
                let (a, b) = (polygon[i], polygon[i + 1]);
                let (c, d) = (polygon[j], polygon[(j + 1) % count]);
                let length = |a: Point, b: Point| (b[0] - a[0]).hypot(b[1] - a[1]);
                // Touching edges too, if that makes the way shorter.
                let shorter = length(a, c) + length(b, d) < length(a, b) + length(c, d) - 1e-9;
                if shorter
                    && (crosses(a, b, c, d) || cross(a, b, c) == 0.0 || cross(a, b, d) == 0.0)
                {
                    polygon[i + 1..=j].reverse();
                    changed = true;
                }
            }
        }
        if !changed {
            return polygon;
        }
    }
}

/// Whether no two edges meet but neighbours in their corner.
fn is_simple(polygon: &[Point]) -> bool {
    let count = polygon.len();
    let within = |a: Point, b: Point, p: Point| {
        cross(a, b, p) == 0.0 && (0..2).all(|k| p[k] >= a[k].min(b[k]) && p[k] <= a[k].max(b[k]))
    };
    (0..count).all(|i| {
        let (a, b) = (polygon[i], polygon[(i + 1) % count]);
        let others = (0..count).filter(|j| *j != i && *j != (i + 1) % count);
        let untouched = others.clone().all(|j| !within(a, b, polygon[j]));
        untouched && (0..count).all(|j| !crosses(a, b, polygon[j], polygon[(j + 1) % count]))
    })
}

/// The polygon's triangles have its orientation and area, and a ray through each of many points meets as
/// many of them as the polygon winds round the point: one or none.
fn covered_once(name: &str, polygon: &[Point], numbers: &mut Numbers) {
    let corners: Vec<[f32; 3]> = polygon.iter().map(|p| [p[0] as f32, p[1] as f32, 0.0]).collect();
    let polygon: Vec<Point> = corners.iter().map(|c| [c[0], c[1]].map(f64::from)).collect();
    let polygon = &polygon[..];
    let (mesh, flat) = face(&corners);
    assert_eq!(mesh.triangles.len() + flat, polygon.len() - 2, "{name}");
    let sign = shoelace(polygon).signum();
    let mut area = 0.0;
    for at in 0..mesh.triangles.len() {
        let [a, b, c] = mesh.vertices(at).map(|v| [f64::from(v[0]), f64::from(v[1])]);
        assert!(cross(a, b, c) * sign > 0.0, "{name}: triangle {at} is turned, {polygon:?}");
        area += cross(a, b, c);
    }
    let expected = shoelace(polygon);
    assert!((area - expected).abs() <= 1e-9 * expected.abs(), "{name}: {area} for {expected}");
    let primitives: Vec<_> = (0..mesh.triangles.len())
        .map(|at| {
            let id = PrimitiveId { object: 0, primitive: at as u32 };
            (id, Primitive::Triangle(mesh.vertices(at)))
        })
        .collect();
    let tree = Tree::build(&primitives).unwrap();
    let mut insides = 0;
    for _ in 0..60 {
        // Away from the grid the corners lie on.
        let point = [0, 1].map(|_| (numbers.next() * 18.0 - 9.0) as f32 + 0.001);
        let ray = PreparedRay::new([point[0], point[1], 1.0], [0.0, 0.0, -1.0]);
        let mut hits = 0;
        tree.every(&ray, f64::INFINITY, |_| {
            hits += 1;
            true
        });
        let point = point.map(f64::from);
        let next = polygon.iter().cycle().skip(1);
        let is_inside = polygon.iter().zip(next).fold(false, |inside, (a, b)| {
            let between = (a[1] > point[1]) != (b[1] > point[1]);
            inside != (between && (cross(*a, *b, point) > 0.0) == (b[1] > a[1]))
        });
        assert_eq!(hits, i32::from(is_inside), "{name} at {point:?}: {polygon:?}");
        insides += usize::from(is_inside);
    }
    // Squares of 60 points would all miss a face of no area.
    assert!(insides > 0 || expected.abs() < 40.0, "{name}: no point lies inside");
}

/// The same with either winding and from every first corner.
fn covered_however_written(name: &str, polygon: &[Point], numbers: &mut Numbers) {
    for first in 0..polygon.len().min(12) {
        let mut turned = polygon.to_vec();
        turned.rotate_left(first);
        covered_once(name, &turned, numbers);
        turned.reverse();
        covered_once(name, &turned, numbers);
    }
}

#[test]
fn concave_faces_are_covered_once() {
    let mut numbers = Numbers(3);
    let shapes: [(&str, &[Point]); 9] = [
        ("arrow", &[[-9.0, -9.0], [0.0, -3.0], [9.0, -9.0], [0.0, 9.0]]),
        (
            "u",
            &[
                [-8., -8.],
                [8., -8.],
                [8., 8.],
                [4., 8.],
                [4., -4.],
                [-4., -4.],
                [-4., 8.],
                [-8., 8.],
            ],
        ),
        (
            "plus",
            &[
                [-2., -8.],
                [2., -8.],
                [2., -2.],
                [8., -2.],
                [8., 2.],
                [2., 2.],
                [2., 8.],
                [-2., 8.],
                [-2., 2.],
                [-8., 2.],
                [-8., -2.],
                [-2., -2.],
            ],
        ),
        (
            "corners on edges",
            &[[-8., -8.], [0., -8.], [4., -8.], [8., -8.], [8., 8.], [-8., 8.], [-8., 0.]],
        ),
        ("first corner on an edge", &[[0., -8.], [8., -8.], [8., 8.], [-8., 8.], [-8., -8.]]),
        (
            "a corner given twice",
            &[
                [-8., -8.],
                [8., -8.],
                [8., -8.],
                [8., 8.],
                [0., 0.],
                [0., 0.],
                [-8., 8.],
                [-8., -8.],
            ],
        ),
        (
            "a hole by a bridge",
            &[
                [-8., -8.],
                [8., -8.],
                [8., 8.],
                [-8., 8.],
                [-8., -8.],
                [-4., -4.],
                [-4., 4.],
                [4., 4.],
                [4., -4.],
                [-4., -4.],
            ],
        ),
        (
            "a hole that touches a corner",
            &[
                [-8., -8.],
                [8., -8.],
                [8., 8.],
                [-8., 8.],
                [-8., -8.],
                [-2., 4.],
                [4., 4.],
                [4., -2.],
            ],
        ),
        (
            "two holes",
            &[
                [-8., -8.],
                [8., -8.],
                [8., 8.],
                [-8., 8.],
                [-8., -8.],
                [-6., -6.],
                [-6., 2.],
                [-2., 2.],
                [-2., -6.],
                [2., 0.],
                [2., 6.],
                [6., 6.],
                [6., 0.],
                [2., 0.],
                [-2., -6.],
                [-6., -6.],
            ],
        ),
    ];
    for (name, polygon) in shapes {
        covered_however_written(name, polygon, &mut numbers);
    }
}

#[test]
fn random_simple_faces_are_covered_once() {
    let mut numbers = Numbers(11);
    let mut tried = 0;
    for round in 0..400 {
        let polygon = simple_polygon(&mut numbers, 4 + round % 45);
        if is_simple(&polygon) {
            covered_once(&format!("round {round}"), &polygon, &mut numbers);
            tried += 1;
        }
    }
    assert!(tried > 200, "only {tried}");
}

#[test]
fn faces_with_thousands_of_corners_are_covered_once() {
    let mut numbers = Numbers(5);
    // A comb, a star, a spiral of two arms, and a disc, which is a fan whatever its size.
    let mut comb: Vec<Point> = vec![[8.0, -8.0], [8.0, -7.0]];
    comb.extend(
        (0..4000).map(|at| [7.0 - at as f64 * 0.0035, if at % 2 == 0 { 7.5 } else { -7.0 }]),
    );
    comb.extend([[-8.0, -7.0], [-8.0, -8.0]]);
    covered_once("comb", &comb, &mut numbers);
    let turned = |at: f64, radius: f64| [at.cos() * radius, at.sin() * radius];
    let star: Vec<Point> = (0..5000)
        .map(|at| turned(at as f64 * 0.0012566, if at % 2 == 0 { 8.0 } else { 2.0 }))
        .collect();
    covered_once("star", &star, &mut numbers);
    let arm = |at: usize, radius: f64| turned(at as f64 * 0.05, radius + at as f64 * 0.0035);
    let mut spiral: Vec<Point> = (0..2000).map(|at| arm(at, 1.0)).collect();
    spiral.extend((0..2000).rev().map(|at| arm(at, 1.2)));
    covered_once("spiral", &spiral, &mut numbers);
    let disc: Vec<Point> =
        (0..20_000).map(|at| turned(at as f64 * std::f64::consts::TAU / 2e4, 8.0)).collect();
    let corners: Vec<[f32; 3]> = disc.iter().map(|p| [p[0] as f32, p[1] as f32, 0.0]).collect();
    assert!(face(&corners).0.triangles.len() > 19_000);
}

/// In a plane of any slant a concave face has the area of its outline, whichever way it is seen.
#[test]
fn slanted_and_bent_faces_keep_their_area_vector() {
    let mut numbers = Numbers(17);
    for round in 0..200 {
        let polygon = simple_polygon(&mut numbers, 4 + round % 20);
        if !is_simple(&polygon) {
            continue;
        }
        let scale = 10f64.powf(numbers.next() * 12.0 - 6.0);
        let axes: [[f64; 3]; 3] =
            [0, 1, 2].map(|_| [0, 1, 2].map(|_| (numbers.next() - 0.5) * scale));
        // Some are not even flat.
        let bend = if round % 4 == 0 { 0.01 } else { 0.0 };
        let corners: Vec<[f32; 3]> = polygon
            .iter()
            .map(|p| {
                let height = bend * numbers.next();
                [0, 1, 2]
                    .map(|k| (axes[0][k] * p[0] + axes[1][k] * p[1] + axes[2][k] * height) as f32)
            })
            .collect();
        let (mesh, _) = face(&corners);
        let vector = |a: [f32; 3], b: [f32; 3], c: [f32; 3]| {
            let [a, b, c] = [a, b, c].map(|v| v.map(f64::from));
            let (u, v) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - a[k]));
            [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        };
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let mut outline = [0.0; 3];
        for at in 1..corners.len() - 1 {
            let part = vector(corners[0], corners[at], corners[at + 1]);
            outline = [0, 1, 2].map(|k| outline[k] + part[k]);
        }
        let size = dot(outline, outline).sqrt();
        let mut area = 0.0;
        for at in 0..mesh.triangles.len() {
            let [a, b, c] = mesh.vertices(at);
            let along = dot(vector(a, b, c), outline) / size;
            assert!(along > -1e-12 * size, "round {round}: a triangle is turned");
            area += along;
        }
        assert!((area - size).abs() < 1e-6 * size, "round {round}: {area} for {size}");
    }
}

#[test]
fn faces_that_are_fans_stay_the_fans_they_were() {
    let quad = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.1], [0.0, 1.0, 0.0]];
    assert_eq!(face(&quad).0.triangles, [[0, 1, 2], [0, 2, 3]]);
    // Concave at its first or third corner a quad is covered by the same two.
    let dart = [[0.0, 0.2, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0], [-1.0, -1.0, 0.0]];
    assert_eq!(face(&dart).0.triangles, [[0, 1, 2], [0, 2, 3]]);
    let hexagon = [0.0_f32, 1.0, 2.0, 3.0, 4.0, 5.0].map(|at| [at.cos(), at.sin(), 0.0]);
    assert_eq!(face(&hexagon).0.triangles, [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]]);
    // Crossed so that it has no side: as before.
    let crossed = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    assert_eq!(face(&crossed).0.triangles, [[0, 1, 2], [0, 2, 3]]);
}

#[test]
fn faces_without_sense_end_all_the_same() {
    let mut numbers = Numbers(23);
    for round in 0..500 {
        // Any corners in few places: crossings, corners in one place, edges upon edges.
        let corners: Vec<[f32; 3]> = (0..3 + round % 30)
            .map(|_| {
                [0, 1, 2].map(|k| (numbers.next() * 4.0).floor() as f32 * (k < 2) as i32 as f32)
            })
            .collect();
        let text: String = corners.iter().map(|[x, y, z]| format!("v {x} {y} {z}\n")).collect();
        let indices: String = (1..=corners.len()).map(|at| format!(" {at}")).collect();
        match parse_obj(format!("{text}f{indices}").as_bytes(), Normals::Smooth) {
            Ok(read) => {
                assert_eq!(read.mesh.triangles.len() + read.flat_triangles, corners.len() - 2)
            }
            Err((line, fault)) => {
                assert_eq!((line, fault), (None, ObjFault::NothingLeft(corners.len() - 2)));
            }
        }
    }
}
