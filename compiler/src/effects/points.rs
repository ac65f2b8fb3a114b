//! The points that ask.

use std::ops::Range;

use crate::state::State;

/// Points of a batch: all of it, or some by their numbers. Nothing is copied to ask about them.
#[derive(Clone, Copy, Debug)]
pub struct Points<'a> {
    states: &'a [State],
    /// None for all of the states.
    numbers: Option<&'a [u32]>,
}

impl<'a> Points<'a> {
    /// The states with these numbers, in that order.
    pub fn numbered(states: &'a [State], numbers: &'a [u32]) -> Self {
        Self { states, numbers: Some(numbers) }
    }

    /// How many there are.
    pub fn len(self) -> usize {
        self.numbers.map_or(self.states.len(), <[u32]>::len)
    }

    /// Whether there are none.
    pub fn is_empty(self) -> bool {
        self.len() == 0
    }

    /// The batch they are of.
    pub fn states(self) -> &'a [State] {
        self.states
    }

    /// The number of one of them in the batch.
    ///
    /// # Panics
    /// If there are not so many.
    #[inline]
    pub fn number(self, at: usize) -> u32 {
        match self.numbers {
            Some(numbers) => numbers[at],
            None => at as u32,
        }
    }

    /// One of them.
    ///
    /// # Panics
    /// If there are not so many.
    #[inline]
    pub fn get(self, at: usize) -> &'a State {
        &self.states[self.number(at) as usize]
    }

    /// All of them, in order.
    #[inline]
    pub fn iter(self) -> impl ExactSizeIterator<Item = &'a State> {
        (0..self.len()).map(move |at| self.get(at))
    }

    /// A stretch of them.
    ///
    /// # Panics
    /// If it goes past their end.
    #[must_use]
    pub fn part(self, range: Range<usize>) -> Self {
        match self.numbers {
            Some(numbers) => Self { numbers: Some(&numbers[range]), ..self },
            None => Self { states: &self.states[range], ..self },
        }
    }
}

impl<'a> From<&'a [State]> for Points<'a> {
    fn from(states: &'a [State]) -> Self {
        Self { states, numbers: None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_all_of_a_batch_or_some_by_number() {
        let states: Vec<State> = (0..6).map(|path| State { path, ..State::default() }).collect();
        let paths = |points: Points<'_>| points.iter().map(|state| state.path).collect::<Vec<_>>();
        let all = Points::from(&states[..]);
        assert_eq!((all.len(), all.number(4)), (6, 4));
        assert_eq!(paths(all.part(2..5)), [2, 3, 4]);
        let some = Points::numbered(&states, &[5, 0, 3, 3]);
        assert_eq!(paths(some), [5, 0, 3, 3]);
        assert_eq!((paths(some.part(1..3)), some.part(1..3).number(1)), (vec![0, 3], 3));
        assert!(some.part(2..2).is_empty() && !some.is_empty());
    }
}
