use crate::emit::functions::conventions::clamp_finite;
use crate::emit::{Real, Transform, Vector};
use crate::nodes::finite::FACTOR;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// A point, vector or normal of one space as another space has it. The space of an object is that in which
    /// its file, its centre or its sides are written: what is a pattern there moves with the object. The
    /// space of the scene is that of the state. In the space of the camera x is to the right, y up, and it
    /// looks along -z. Points are moved by the origins of the spaces, vectors are not; normals stay at right
    /// angles to surfaces and are brought to unit length. From a space to itself nothing changes. Only the
    /// transforms that count are looked up.
    transform_space in spaces,
    source "mental ray manual, mi_point_to_object and its like; OSL, transform with named spaces",
    inputs {
        /// What it is.
        kind: choice = 0, of ["point", "vector", "normal"];
        /// The space it is given in.
        from: choice = 1, of ["object", "world", "camera"];
        /// The space it is wanted in.
        to: choice = 0, of ["object", "world", "camera"];
        /// What is transformed.
        value: vector = state(Field::Point), in FACTOR;
        /// From the space of the object to that of the scene.
        object_to_world: transform = state(Field::ObjectToWorld), in FACTOR, when e.mask(i.from == 0 && i.to != 0);
        /// From the space of the camera to that of the scene.
        camera_to_world: transform = state(Field::CameraToWorld), in FACTOR, when e.mask(i.from == 2 && i.to != 2);
        /// From the space of the scene to that of the object.
        world_to_object: transform = state(Field::WorldToObject), in FACTOR, when e.mask(i.to == 0 && i.from != 0);
        /// From the space of the scene to that of the camera.
        world_to_camera: transform = state(Field::WorldToCamera), in FACTOR, when e.mask(i.to == 2 && i.from != 2);
    }
    outputs {
        /// The same in the other space.
        result: vector;
    }
    body |e, i| {
        let through = |map: Transform<E::Real>, value: Vector<E::Real>| {
            let mapped = match i.kind {
                0 => map.point(value),
                1 => map.vector(value),
                _ => map.normal(value),
            };
            finite(mapped)
        };
        let in_world = match (i.from, i.to) {
            (from, to) if from == to => i.value,
            (0, _) => through(i.object_to_world, i.value),
            (2, _) => through(i.camera_to_world, i.value),
            _ => i.value,
        };
        let result = match (i.from, i.to) {
            (from, to) if from == to => i.value,
            (_, 0) => through(i.world_to_object, in_world),
            (_, 2) => through(i.world_to_camera, in_world),
            _ => in_world,
        };
        Outputs { result }
    }
}

/// Through two spaces in one go numbers may grow past the largest.
#[inline(always)]
fn finite<R: Real>(vector: Vector<R>) -> Vector<R> {
    let Vector { x, y, z } = vector;
    Vector { x: clamp_finite(x), y: clamp_finite(y), z: clamp_finite(z) }
}

#[cfg(test)]
mod tests {
    use crate::values::Literal;

    /// A quarter turn about z, twice as large, moved; and back.
    fn maps() -> [Literal; 2] {
        [
            [0.0, 2.0, 0.0, 0.0, -2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 10.0, 20.0, 30.0, 1.0],
            [0.0, -0.5, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5, 0.0, -10.0, 5.0, -15.0, 1.0],
        ]
        .map(Literal::Transform)
    }

    fn moved(kind: i32, from: i32, to: i32, value: [f32; 3]) -> Vec<f32> {
        let [there, back] = maps();
        numbers!(kind = kind, from = from, to = to, value = value, object_to_world = there, world_to_object = back => result)
    }

    #[test]
    fn points_vectors_and_normals_go_their_own_ways() {
        let value = [1.0, 2.0, 3.0];
        assert_eq!(moved(0, 0, 1, value), [6.0, 22.0, 36.0]);
        assert_eq!(moved(0, 1, 0, [6.0, 22.0, 36.0]), value);
        assert_eq!(moved(1, 0, 1, value), [-4.0, 2.0, 6.0]);
        assert_eq!(moved(2, 0, 1, [5.0, 0.0, 0.0]), [0.0, 1.0, 0.0]);
        // The camera stands at the origin.
        assert_eq!(moved(0, 0, 2, value), [6.0, 22.0, 36.0]);
        assert_eq!(moved(0, 2, 0, [6.0, 22.0, 36.0]), value);
    }

    #[test]
    fn from_a_space_to_itself_nothing_changes() {
        for kind in 0..3 {
            for space in 0..3 {
                assert_eq!(moved(kind, space, space, [3.0, -0.0, 1e-45]), [3.0, -0.0, 1e-45]);
            }
        }
    }

    #[test]
    fn only_maps_that_count_are_looked_up() {
        for (from, to) in (0..9).map(|at| (at / 3, at % 3)) {
            assert_eq!(demanded!(from = from, to = to => object_to_world), from == 0 && to != 0);
            assert_eq!(demanded!(from = from, to = to => camera_to_world), from == 2 && to != 2);
            assert_eq!(demanded!(from = from, to = to => world_to_object), to == 0 && from != 0);
            assert_eq!(demanded!(from = from, to = to => world_to_camera), to == 2 && from != 2);
        }
    }
}
