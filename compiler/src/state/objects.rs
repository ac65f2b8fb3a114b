//! The objects of a scene, their surfaces and its camera: where points look up what their states do not
//! hold.

use std::fmt;

use super::camera::Camera;
use super::field::{Field, Holder};
use super::known::Known;
use super::object::Object;
use super::place::Place;
use super::ray_type::RayType;
use super::shading_point::State;
use super::surface::{Surface, Surfaces};
use crate::storage::Lanes;

/// What points look up.
#[derive(Clone, Copy)]
pub struct Objects<'a> {
    /// The objects, by their numbers in [`Hit::instance`](super::Hit::instance).
    pub objects: &'a [Object],
    /// Their surfaces.
    pub surfaces: &'a dyn Surfaces,
    /// Where the scene is seen from.
    pub camera: &'a Camera,
}

/// No object, no surface, and a camera at the origin.
impl Default for Objects<'_> {
    fn default() -> Self {
        Self { objects: &[], surfaces: &Surface::NONE, camera: &Camera::AT_ORIGIN }
    }
}

impl fmt::Debug for Objects<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { objects, camera, .. } = self;
        let mut shown = formatter.debug_struct("Objects");
        shown.field("objects", objects).field("camera", camera).finish_non_exhaustive()
    }
}

impl<'a> Objects<'a> {
    /// What is looked up at a place of no scene.
    pub fn of_place(place: &'a Place) -> Self {
        let Place { object, surface, camera, .. } = place;
        Self { objects: std::slice::from_ref(object), surfaces: surface, camera }
    }

    /// What is known of a point. What a ray sees that leaves the scene is on no object.
    #[inline]
    fn known(self, state: &'a State) -> Known<'a> {
        let Self { objects, surfaces, camera } = self;
        if state.ray_type == RayType::Environment {
            return Known { state, object: &Object::NONE, surfaces: &Surface::NONE, camera };
        }
        let object = objects.get(state.hit.instance as usize).unwrap_or(&Object::NONE);
        Known { state, object, surfaces, camera }
    }

    /// Writes the words of a field.
    #[inline]
    pub fn read(self, field: Field, state: &State, words: &mut [u32]) {
        match field.holder() {
            Holder::State | Holder::Loop(_) => field.read(state, words),
            Holder::Object | Holder::Surface | Holder::Camera => {
                field.look_up(&Objects::known(self, state), words);
            }
        }
    }

    /// Writes the words of a field of up to eight points, each in a lane of its own.
    // A call: what states hold themselves is read without its frame.
    #[inline(never)]
    pub fn gather(self, field: Field, states: &[State], lanes: &mut [Lanes]) {
        if matches!(field.holder(), Holder::State | Holder::Loop(_)) {
            return field.gather(states, lanes);
        }
        for (lane, state) in states.iter().enumerate() {
            let mut words = [0; Field::MOST_WORDS];
            field.look_up(&Objects::known(self, state), &mut words);
            for (lanes, word) in lanes.iter_mut().zip(words) {
                lanes.0[lane] = word;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::state::Hit;
    use crate::storage::LANES;

    fn on(instance: u32) -> State {
        State { hit: Hit { instance, ..Hit::default() }, ..State::default() }
    }

    #[test]
    fn fields_of_objects_are_looked_up_by_the_points() {
        let objects: Vec<Object> = (0..3).map(Object::at).collect();
        let beyond = State { ray_type: RayType::Environment, ..on(1) };
        let states = [on(2), on(0), on(3), beyond];
        let all = Objects { objects: &objects, ..Objects::default() };
        let ids = states.map(|state| {
            let mut words = [7];
            all.read(Field::ObjectId, &state, &mut words);
            words[0]
        });
        assert_eq!(ids, [3, 1, 0, 0]);
        let mut lanes = [Lanes([7; LANES])];
        all.gather(Field::ObjectRandom, &states, &mut lanes);
        let random = [objects[2].random, objects[0].random, 0.0, 0.0].map(f32::to_bits);
        assert_eq!((&lanes[0].0[..4], lanes[0].0[4]), (&random[..], 7));
        // What a point has itself is read as ever.
        let mut words = [0; 3];
        all.read(Field::Normal, &states[0], &mut words);
        assert_eq!(words, [0.0, 0.0, 1.0].map(f32::to_bits));
    }

    #[test]
    fn all_that_is_put_into_a_place_is_looked_up_there() {
        for &field in Field::ALL.iter().filter(|field| field.of_loop().is_none()) {
            let mut words = vec![u32::MAX; field.value_type().width()];
            if field == Field::RayType {
                words[0] = RayType::Shadow as u32;
            }
            let mut place = Place::default();
            field.put(&mut place, &words);
            let mut read = vec![7; words.len()];
            Objects::of_place(&place).read(field, &place.state, &mut read);
            assert_eq!(read, words, "{field:?}");
            let states = [place.state; 2];
            let mut lanes = [Lanes([7; LANES]); Field::MOST_WORDS];
            Objects::of_place(&place).gather(field, &states, &mut lanes[..words.len()]);
            for (lanes, word) in lanes.iter().zip(words) {
                assert_eq!(lanes.0[..3], [word, word, 7], "{field:?}");
            }
        }
    }
}
