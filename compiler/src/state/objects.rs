//! The objects of a scene, and how points look up what is theirs.

use super::field::Field;
use super::object::Object;
use super::ray_type::RayType;
use super::shading_point::State;
use crate::storage::Lanes;

/// The objects of a scene, by their numbers in [`Hit::instance`](super::Hit::instance).
#[derive(Clone, Copy, Debug, Default)]
pub struct Objects<'a>(pub &'a [Object]);

impl Objects<'_> {
    /// The object a point is on; the default one where there is none, as for what a ray sees that leaves
    /// the scene.
    #[inline]
    fn of(self, state: &State) -> Object {
        let on_surface = state.ray_type != RayType::Environment;
        let object = self.0.get(state.hit.instance as usize).filter(|_| on_surface);
        object.copied().unwrap_or_default()
    }

    /// Writes the words of a field of a point or of its object.
    #[inline]
    pub fn read(self, field: Field, state: &State, words: &mut [u32]) {
        match field.of_object() {
            true => field.read_of(&self.of(state), words),
            false => field.read(state, words),
        }
    }

    /// Writes the words of a field of up to eight points or of their objects, each in a lane of its own.
    #[inline]
    pub fn gather(self, field: Field, states: &[State], lanes: &mut [Lanes]) {
        if !field.of_object() {
            return field.gather(states, lanes);
        }
        for (lane, state) in states.iter().enumerate() {
            let mut words = [0; Field::MOST_WORDS];
            field.read_of(&self.of(state), &mut words);
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
        let ids = states.map(|state| {
            let mut words = [7];
            Objects(&objects).read(Field::ObjectId, &state, &mut words);
            words[0]
        });
        assert_eq!(ids, [3, 1, 0, 0]);
        let mut lanes = [Lanes([7; LANES])];
        Objects(&objects).gather(Field::ObjectRandom, &states, &mut lanes);
        let random = [objects[2].random, objects[0].random, 0.0, 0.0].map(f32::to_bits);
        assert_eq!((&lanes[0].0[..4], lanes[0].0[4]), (&random[..], 7));
        // What a point has itself is read as ever.
        let mut words = [0; 3];
        Objects(&objects).read(Field::Normal, &states[0], &mut words);
        assert_eq!(words, [0.0, 0.0, 1.0].map(f32::to_bits));
    }
}
