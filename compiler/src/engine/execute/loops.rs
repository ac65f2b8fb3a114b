//! Loops of a batch, turn by turn.

use crate::engine::turns::{Turn, Turning, turns_of};
use crate::schedule::{Loop, LoopId, RegionId};
use crate::specialise::{Turns, iteration_key};
use crate::state::Reduction;
use crate::storage::LANES;

use super::memory::{Frame, empty};
use super::run::Run;

impl Run<'_> {
    /// Makes a loop ready for the points it is to be run for; tells how many turns there are at most.
    pub(super) fn start(&mut self, at: LoopId, within: RegionId) -> usize {
        let of = &self.program.schedule.loops[at];
        self.memory.iterations[at] = 0;
        self.choose(within);
        self.count_chosen();
        let chosen = std::mem::take(&mut self.memory.chosen);
        let mut words = [0; Reduction::MOST_WORDS];
        let words = &mut words[..of.value_type.width()];
        of.reduction.start(of.value_type, words);
        for &point in &chosen {
            self.set_all(of.output, point, words);
        }
        let count = match &of.turns {
            Turns::Lights { list } => {
                let list = self.links.light_list(*list);
                list.map_or(0, |list| self.renderer.light_count(list))
            }
            Turns::Samples { count, .. } => {
                chosen.iter().map(|&point| turns_of(self.word(*count, point))).max().unwrap_or(0)
            }
        };
        self.memory.chosen = chosen;
        count
    }

    /// Takes what the last turn yielded, if there was one, and starts the next.
    pub(super) fn iterate(&mut self, at: LoopId, within: RegionId, count: usize) {
        let of = &self.program.schedule.loops[at];
        if self.memory.iterations[at] > 0 {
            self.settle_turn(of);
            self.reduce(of, of.region, |of, words, value, _| {
                of.reduction.take(of.value_type, words, value);
            });
        }
        while self.memory.iterations[at] < count {
            let number = self.memory.iterations[at];
            self.memory.iterations[at] += 1;
            if self.turn(at, within, number) {
                self.renew(of);
                self.memory.stack.push(Frame::Loop { at, within, count });
                self.memory.stack.push(Frame::Region { region: of.region, item: 0 });
                return;
            }
        }
        if of.reduction.has_end() {
            self.reduce(of, within, |of, words, _, own| {
                of.reduction.finish(of.value_type, own.unwrap_or(count), words);
            });
        }
    }

    /// Changes what the turns became, for all points of a region: given it, the body's value, and how
    /// many turns the point takes if that is its own matter.
    fn reduce(
        &mut self,
        of: &Loop,
        region: RegionId,
        change: impl Fn(&Loop, &mut [u32], &[u32], Option<usize>),
    ) {
        self.choose(region);
        let chosen = std::mem::take(&mut self.memory.chosen);
        let width = of.value_type.width();
        let mut values = std::mem::take(&mut self.memory.values);
        self.gather_words(&of.words, &chosen, &mut values);
        let mut words = [0; Reduction::MOST_WORDS];
        let words = &mut words[..width];
        for (&point, value) in chosen.iter().zip(values.chunks_exact(width)) {
            self.read_all(of.output, point, words);
            let own = match of.turns {
                Turns::Lights { .. } => None,
                Turns::Samples { count, .. } => Some(turns_of(self.word(count, point))),
            };
            change(of, words, value, own);
            self.set_all(of.output, point, words);
        }
        self.memory.values = values;
        self.memory.chosen = chosen;
    }

    /// Writes what a turn provides, and the mask of the points that take part; false if none does.
    fn turn(&mut self, at: LoopId, within: RegionId, number: usize) -> bool {
        let of = &self.program.schedule.loops[at];
        self.choose(within);
        let chosen = std::mem::take(&mut self.memory.chosen);
        let mut turning = self.memory.turning.take().unwrap_or_default();
        let turn = self.gather(of, number, &chosen, &mut turning);
        turning.turn(turn, self.points, self.renderer);
        let first = self.mask(of.region, 0);
        self.memory.todo[first..first + self.blocks].fill(0);
        self.memory.tokens[at].resize(self.blocks * LANES, 0);
        let width = turning.words.len() / chosen.len().max(1);
        let mut any = false;
        for (k, &point) in chosen.iter().enumerate().filter(|(k, _)| turning.reached[*k]) {
            any = true;
            self.memory.tokens[at][point] = turning.tokens[k];
            self.memory.todo[first + point / LANES] |= 1 << (point % LANES);
            self.set_all(of.fields, point, &turning.words[k * width..][..width]);
        }
        self.memory.chosen = chosen;
        self.memory.turning = Some(turning);
        any
    }

    /// What a turn is to be found for: the points as the loop needs them.
    fn gather(&self, of: &Loop, number: usize, points: &[usize], turning: &mut Turning) -> Turn {
        turning.clear();
        match &of.turns {
            Turns::Lights { list } => {
                turning.numbers.extend(points.iter().map(|&point| point as u32));
                if !of.context.is_empty() {
                    let scoped = |&point: &usize| self.scoped(point, &of.context);
                    turning.scoped.extend(points.iter().map(scoped));
                }
                Turn::OfLights(self.links.light_list(*list), number)
            }
            Turns::Samples { count, site, loops } => {
                let path =
                    |&point: &usize| (self.points[point].path, turns_of(self.word(*count, point)));
                turning.paths.extend(points.iter().map(path));
                Turn::OfSamples(number, iteration_key(self.key(*site, loops), number))
            }
        }
    }

    /// Forgets what was evaluated in the last turn.
    fn renew(&mut self, of: &Loop) {
        for &region in &of.renewed {
            let first = self.mask(region, 0);
            self.memory.done[first..first + self.blocks].fill(0);
        }
        for &table in &of.emptied {
            empty(&mut self.memory.tables[table]);
        }
    }

    /// A key with the turns of the loops round its site.
    pub(super) fn key(&self, site: u64, loops: &[LoopId]) -> u64 {
        loops
            .iter()
            .fold(site, |key, &at| iteration_key(key, self.memory.iterations[at].wrapping_sub(1)))
    }
}
