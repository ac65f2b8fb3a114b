//! What the turns of a loop provide, for both ways of running a graph.

use super::requests::asking;
use crate::effects::{LightList, LightSample, Renderer};
use crate::specialise::drawn;
use crate::state::{MOST_TURNS, State};

/// A turn of a loop, for all points alike.
#[derive(Clone, Copy, Debug)]
pub(super) enum Turn {
    /// A light sample: its list, if it is known, and its number there.
    OfLights(Option<LightList>, usize),
    /// A sample: its number, and the key of its random numbers.
    OfSamples(usize, u64),
}

/// The points of a loop and what a turn provides to each; kept between loops so that nothing is
/// allocated.
#[derive(Debug, Default)]
pub(super) struct Turning {
    /// The points of a loop over lights: their numbers in the batch.
    pub numbers: Vec<u32>,
    /// Of each of them, its state with the changes of scopes; empty where none changed what matters.
    pub scoped: Vec<State>,
    /// Of each point of a loop over samples, the key of its path and how many it takes.
    pub paths: Vec<(u64, usize)>,
    /// Words of the fields that are provided, point by point.
    pub words: Vec<u32>,
    /// Per point, whether it takes part in the turn.
    pub reached: Vec<bool>,
    /// Per point, the token of the light sample.
    pub tokens: Vec<u64>,
    samples: Vec<LightSample>,
}

/// How many turns a count stands for.
pub(super) fn turns_of(count: u32) -> usize {
    (count as i32).clamp(0, MOST_TURNS) as usize
}

impl Turning {
    /// Makes it ready for other points.
    pub(super) fn clear(&mut self) {
        self.numbers.clear();
        self.scoped.clear();
        self.paths.clear();
    }

    /// Finds what a turn provides to points of a batch.
    pub(super) fn turn(&mut self, turn: Turn, batch: &[State], renderer: &mut dyn Renderer) {
        self.words.clear();
        self.reached.clear();
        self.tokens.clear();
        match turn {
            Turn::OfLights(list, number) => self.light(list, number, batch, renderer),
            Turn::OfSamples(number, key) => self.sample(number, key),
        }
    }

    fn light(
        &mut self,
        list: Option<LightList>,
        number: usize,
        batch: &[State],
        renderer: &mut dyn Renderer,
    ) {
        let points = asking(batch, &self.numbers, &self.scoped);
        self.samples.clear();
        self.samples.resize(points.len(), LightSample::default());
        if let Some(list) = list {
            renderer.light_samples(list, number, points, &mut self.samples);
        }
        self.words.resize(5 * self.samples.len(), 0);
        let (rows, _) = self.words.as_chunks_mut::<5>();
        for (row, sample) in rows.iter_mut().zip(&self.samples) {
            let [x, y, z] = sample.direction;
            *row = [x, y, z, sample.distance, sample.density].map(f32::to_bits);
        }
        self.reached.extend(self.samples.iter().map(|sample| sample.reachable));
        self.tokens.extend(self.samples.iter().map(|sample| sample.token));
    }

    fn sample(&mut self, number: usize, key: u64) {
        for &(path, count) in &self.paths {
            let [u, v] = drawn(path, key);
            self.words.extend([number as u32, u.to_bits(), v.to_bits()]);
            self.reached.push(number < count);
            self.tokens.push(0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_loop_is_endless() {
        assert_eq!([0, 3, u32::MAX, i32::MAX as u32].map(turns_of), [0, 3, 0, 1 << 16]);
    }
}
