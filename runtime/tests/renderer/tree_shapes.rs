//! Trees over what makes trees deep or slow find what a search of every primitive finds.

use phenomenon_runtime::bvh::{PrimitiveId, Tree};
use phenomenon_runtime::geometry::{PreparedRay, Primitive, RawHit, Sphere};

use crate::shaders::Numbers;

type Listed = Vec<(PrimitiveId, Primitive)>;

fn listed(count: usize, of: impl Fn(usize) -> Primitive) -> Listed {
    let id = |at: usize| PrimitiveId { object: (at % 3) as u32, primitive: (at / 3) as u32 };
    (0..count).map(|at| (id(at), of(at))).collect()
}

fn triangle(corners: [[f32; 3]; 3]) -> Primitive {
    Primitive::Triangle(corners)
}

/// A triangle that faces z, round a point.
fn facing(center: [f32; 3], size: f32) -> Primitive {
    let [x, y, z] = center;
    triangle([[x - size, y - size, z], [x + size, y - size, z], [x, y + size, z]])
}

fn shapes(count: usize) -> Vec<(&'static str, Listed)> {
    let power = |at: usize| 10f32.powf(12.0 * at as f32 / count as f32 - 6.0);
    let turn = |at: usize| {
        let (y, x) = (std::f32::consts::TAU * at as f32 / count as f32).sin_cos();
        [x, y, 0.0]
    };
    let sphere = |center: [f32; 3], radius: f32| Primitive::Sphere(Sphere { center, radius });
    vec![
        ("points", listed(count, |_| triangle([[0.25; 3]; 3]))),
        ("equal", listed(count, |_| facing([0.0; 3], 1.0))),
        (
            "equal behind points",
            listed(count, |at| {
                if at % 2 == 0 { triangle([[0.0; 3]; 3]) } else { facing([0.0; 3], 1.0) }
            }),
        ),
        ("concentric", listed(count, |at| sphere([0.0; 3], power(at)))),
        ("growing", listed(count, |at| facing([power(at), 0.0, -power(at)], power(at)))),
        ("stacked", listed(count, |at| facing([0.0, 0.0, at as f32], 1.0))),
        ("row", listed(count, |at| sphere([at as f32 * 2.0, 0.0, 0.0], 1.0))),
        // The fan of a prism's cap: all share a corner.
        ("cap", listed(count, |at| triangle([[1.0, 0.0, 0.0], turn(at), turn(at + 1)]))),
    ]
}

fn compare(name: &str, primitives: &Listed, shots: usize) -> usize {
    let tree = Tree::build(primitives).unwrap();
    assert_eq!(tree.len(), primitives.len());
    let (low, high) = tree.bounds().unwrap();
    let mut numbers = Numbers(7);
    let mut found_any = 0;
    for shot in 0..shots {
        // Half of them towards the middle, where the small ones are.
        let scale = if shot % 2 == 0 { 1.0 } else { 10f64.powf(-7.0 * numbers.next()) };
        let mut inside = |k: usize| {
            let (low, high) = (f64::from(low[k]), f64::from(high[k]));
            ((low + (high - low) * numbers.next()) * scale) as f32
        };
        let target: [f32; 3] = [0, 1, 2].map(&mut inside);
        let origin = match shot % 3 {
            0 => [target[0], target[1], high[2] + (high[2] - low[2]) + 1.0],
            _ => [0, 1, 2].map(inside),
        };
        let towards = [0, 1, 2].map(|k| f64::from(target[k]) - f64::from(origin[k]));
        let length = towards.iter().map(|x| x * x).sum::<f64>().sqrt();
        if length == 0.0 {
            continue;
        }
        let ray = PreparedRay::new(origin, towards.map(|x| (x / length) as f32));
        let mut every: Vec<(u64, PrimitiveId)> = Vec::new();
        tree.every(&ray, f64::INFINITY, |hit| {
            every.push((hit.t.to_bits(), tree.id(hit.slot)));
            true
        });
        let mut all: Vec<(u64, PrimitiveId)> = Vec::new();
        for (id, primitive) in primitives {
            primitive.every(&ray, 0, |hit: RawHit| all.push((hit.t.to_bits(), *id)));
        }
        every.sort();
        all.sort();
        assert_eq!(every, all, "{name}, shot {shot}");
        let nearest =
            tree.nearest(&ray, f64::INFINITY).map(|hit| (hit.t.to_bits(), tree.id(hit.slot)));
        // Positive numbers are ordered as their bits are.
        assert_eq!(nearest, all.first().copied(), "{name}, shot {shot}");
        found_any += usize::from(nearest.is_some());
    }
    found_any
}

#[test]
fn what_makes_trees_deep_is_searched_without_loss() {
    for count in [1, 3, 4, 65, 300, 2000] {
        for (name, primitives) in shapes(count) {
            let found = compare(&format!("{name} of {count}"), &primitives, 300);
            assert!(found > 0 || name == "points" || count < 65, "{name} of {count} is never met");
        }
    }
}

#[test]
fn a_hundred_thousand_equal_or_nested_shapes_are_built_and_searched() {
    for (name, primitives) in shapes(100_000) {
        compare(name, &primitives, 12);
    }
}
