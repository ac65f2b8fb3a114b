//! The tree finds what a search of every primitive finds.

use phenomenon_runtime::bvh::{PrimitiveId, Tree};
use phenomenon_runtime::geometry::{PreparedRay, Primitive, RawHit, Sphere};

use crate::shaders::Numbers;

fn nearest_of_all(
    primitives: &[(PrimitiveId, Primitive)],
    ray: &PreparedRay,
) -> Option<(f64, PrimitiveId)> {
    let hits = primitives
        .iter()
        .filter_map(|(id, primitive)| primitive.nearest(ray, 0).map(|hit| (hit.t, *id)));
    hits.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))
}

fn mixed_primitives(
    numbers: &mut Numbers,
    count: u32,
    spread: f64,
) -> Vec<(PrimitiveId, Primitive)> {
    (0..count)
        .map(|number| {
            let center = [0, 1, 2].map(|_| ((numbers.next() - 0.5) * spread) as f32);
            // Sizes over four decades.
            let size = spread as f32 * 0.2 * 10f32.powf(-4.0 * numbers.next() as f32);
            let mut corner = || [0, 1, 2].map(|k| center[k] + size * (numbers.next() as f32 - 0.5));
            let primitive = match number % 3 {
                0 => Primitive::Sphere(Sphere { center, radius: size }),
                _ => Primitive::Triangle([corner(), corner(), corner()]),
            };
            (PrimitiveId { object: number % 5, primitive: number / 5 }, primitive)
        })
        .collect()
}

#[test]
fn nearest_and_every_hit_agree_with_a_search_of_all() {
    for (seed, spread) in [(1, 10.0), (2, 1e-5), (3, 1e7)] {
        let mut numbers = Numbers(seed);
        let primitives = mixed_primitives(&mut numbers, 700, spread);
        let tree = Tree::build(&primitives).unwrap();
        assert_eq!(tree.len(), 700);
        let mut hits = 0;
        for shot in 0..3000 {
            let far = if shot % 3 == 0 { 100.0 } else { 1.0 };
            let origin = [0, 1, 2].map(|_| ((numbers.next() - 0.5) * spread * far) as f32);
            let target = [0, 1, 2].map(|_| ((numbers.next() - 0.5) * spread) as f32);
            let towards = [0, 1, 2].map(|k| f64::from(target[k]) - f64::from(origin[k]));
            let length = towards.iter().map(|x| x * x).sum::<f64>().sqrt();
            let mut direction = towards.map(|x| (x / length) as f32);
            if shot % 10 == 0 {
                direction = [0.0, if shot % 20 == 0 { 1.0 } else { -1.0 }, -0.0];
            }
            let ray = PreparedRay::new(origin, direction);
            let found = tree.nearest(&ray, f64::INFINITY).map(|hit| (hit.t, tree.id(hit.slot)));
            assert_eq!(found, nearest_of_all(&primitives, &ray), "seed {seed} shot {shot}");
            hits += usize::from(found.is_some());
            let mut every: Vec<(u64, PrimitiveId)> = Vec::new();
            tree.every(&ray, f64::INFINITY, |hit| {
                every.push((hit.t.to_bits(), tree.id(hit.slot)));
                true
            });
            let mut all: Vec<(u64, PrimitiveId)> = Vec::new();
            for (id, primitive) in &primitives {
                primitive.every(&ray, 0, |hit: RawHit| all.push((hit.t.to_bits(), *id)));
            }
            every.sort();
            all.sort();
            assert_eq!(every, all, "seed {seed} shot {shot}");
        }
        assert!(hits > 300, "only {hits} hits");
    }
}

#[test]
fn of_equal_distances_the_lowest_number_counts() {
    let triangle = Primitive::Triangle([[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]]);
    for order in [[(3, 0), (1, 7), (1, 2), (2, 0)], [(1, 2), (2, 0), (3, 0), (1, 7)]] {
        let primitives: Vec<_> = order
            .iter()
            .map(|&(object, primitive)| (PrimitiveId { object, primitive }, triangle))
            .collect();
        let tree = Tree::build(&primitives).unwrap();
        let ray = PreparedRay::new([0.0, 0.0, 1.0], [0.0, 0.0, -1.0]);
        let hit = tree.nearest(&ray, f64::INFINITY).unwrap();
        assert_eq!(tree.id(hit.slot), PrimitiveId { object: 1, primitive: 2 });
        // The limit itself still counts, less does not.
        assert!(tree.nearest(&ray, 1.0).is_some());
        assert!(tree.nearest(&ray, 1f64.next_down()).is_none());
    }
}

#[test]
fn an_empty_tree_and_a_tree_of_one() {
    let ray = PreparedRay::new([0.0, 0.0, 5.0], [0.0, 0.0, -1.0]);
    assert!(Tree::build(&[]).unwrap().nearest(&ray, f64::INFINITY).is_none());
    let id = PrimitiveId { object: 0, primitive: 0 };
    let sphere = Primitive::Sphere(Sphere { center: [0.0; 3], radius: 1.0 });
    let tree = Tree::build(&[(id, sphere)]).unwrap();
    assert_eq!(tree.nearest(&ray, f64::INFINITY).unwrap().t, 4.0);
}

#[test]
fn boxes_much_nearer_than_any_epsilon_are_not_lost() {
    let id = PrimitiveId { object: 0, primitive: 0 };
    let sphere = Primitive::Sphere(Sphere { center: [0.0; 3], radius: 1e-9 });
    let tree = Tree::build(&[(id, sphere)]).unwrap();
    let ray = PreparedRay::new([0.0, 0.0, 3e-9], [0.0, 0.0, -1.0]);
    let hit = tree.nearest(&ray, f64::INFINITY).unwrap();
    assert!((hit.t - 2e-9).abs() < 1e-15, "{}", hit.t);
}
