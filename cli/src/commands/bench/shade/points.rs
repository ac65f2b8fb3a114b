//! What is shaded, and where the results go.

use std::ops::Range;

use phenomenon_compiler::effects::{NoScene, Renderer};
use phenomenon_compiler::engine::{Shade, Shaded};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::State;

use super::materials::Recorded;

/// What is shaded in calls of some points, and where the results go.
pub struct Points {
    states: Vec<State>,
    calls: Vec<Range<usize>>,
    answers: Answers,
    results: Vec<Shaded>,
}

/// Who answers what shaders ask.
pub enum Answers {
    /// Nothing is asked.
    None(NoScene),
    /// A table.
    Recorded(Recorded),
}

impl Points {
    /// Points in calls of so many, or fewer where the type of ray changes.
    pub fn new(states: Vec<State>, batch: usize, answers: Answers) -> Self {
        let calls = calls(&states, batch);
        Self { results: vec![Shaded::default(); states.len()], states, calls, answers }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.states.len()
    }

    /// Shades all of them once, linked once as a renderer does it.
    pub fn shade(&mut self, shader: &dyn Shade) {
        let Self { states, calls, answers, results } = self;
        match answers {
            Answers::None(renderer) => pass(shader, states, calls, renderer, results),
            Answers::Recorded(renderer) => pass(shader, states, calls, renderer, results),
        }
    }

    /// How much was asked that nobody knew an answer to.
    pub fn unknown(&self) -> u64 {
        match &self.answers {
            Answers::None(_) => 0,
            Answers::Recorded(recorded) => recorded.unknown,
        }
    }
}

/// Shades all points, call by call.
pub fn pass(
    shader: &dyn Shade,
    states: &[State],
    calls: &[Range<usize>],
    renderer: &mut dyn Renderer,
    results: &mut [Shaded],
) {
    let links = shader.link(renderer);
    for call in calls {
        let (points, results) = (&states[call.clone()], &mut results[call.clone()]);
        shader.shade_linked(RootKind::Material, points, &links, renderer, results);
    }
}

/// Calls of so many points, or fewer where the type of ray changes.
pub fn calls(states: &[State], batch: usize) -> Vec<Range<usize>> {
    let (mut calls, mut first) = (Vec::new(), 0);
    for of_type in states.chunk_by(|a, b| a.ray_type == b.ray_type) {
        for call in of_type.chunks(batch) {
            calls.push(first..first + call.len());
            first += call.len();
        }
    }
    calls
}

#[cfg(test)]
mod tests {
    use phenomenon_compiler::state::RayType;

    use super::*;

    #[test]
    fn calls_end_where_the_type_of_ray_changes() {
        let of = |ray_type| State { ray_type, ..State::default() };
        let mut states = vec![of(RayType::Eye); 5];
        states.extend([of(RayType::Reflection); 2]);
        assert_eq!(calls(&states, 4), [0..4, 4..5, 5..7]);
        assert_eq!(calls(&states, 256), [0..5, 5..7]);
        assert_eq!(calls(&states[..2], 1), [0..1, 1..2]);
    }
}
