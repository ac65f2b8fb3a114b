//! Loops of a point, turn by turn.

use super::code::{Loop, Step};
use super::memory::{LoopPosition, Memory};
use super::run::{Next, Walk};
use crate::engine::turns::{Turn, turns_of};
use crate::specialise::{EpochId, Turns, iteration_key};
use crate::state::{Reduction, State};

impl Walk<'_> {
    /// Takes what the last turn of a loop yielded, if there was one, and starts the next that the point
    /// takes part in.
    pub(super) fn iterate(&mut self, of: &Loop, step: &Step, state: &State) -> Next {
        let code = self.code;
        let mut position = self.memory.loops[of.epoch];
        if position.running {
            self.reduce(of, step, |words, value| of.reduction.take(of.value_type, words, value));
        } else {
            self.reduce(of, step, |words, _| of.reduction.start(of.value_type, words));
            let count = match of.turns {
                Turns::Lights { list } => {
                    let list = self.links.light_list(list);
                    list.map_or(0, |list| self.renderer.light_count(list))
                }
                Turns::Samples { .. } => turns_of(self.memory.words[of.count]),
            };
            position = LoopPosition { count, running: true, ..LoopPosition::default() };
        }
        let Memory { turning, words, .. } = &mut *self.memory;
        turning.clear();
        match of.turns {
            Turns::Lights { .. } => {
                turning.numbers.push(0);
                turning.scoped.extend(of.scope.applied(code, words, state));
            }
            Turns::Samples { .. } => turning.paths.push((state.path, position.count)),
        }
        while position.next < position.count {
            let turn = self.turn(of, position.next);
            let Memory { turning, words, .. } = &mut *self.memory;
            turning.turn(turn, std::slice::from_ref(state), self.renderer);
            position.next += 1;
            if turning.reached[0] {
                position.token = turning.tokens[0];
                words[of.fields..][..turning.words.len()].copy_from_slice(&turning.words);
                self.memory.loops[of.epoch] = position;
                self.pass_anew(&of.renewed);
                // A body that does not look at the turn belongs to an outer epoch: once is enough.
                let evaluated = |body| self.is_done(body, code.steps[body].epoch);
                return Next::Turn(of.body.filter(|body| !evaluated(*body)));
            }
        }
        self.reduce(of, step, |words, _| {
            of.reduction.finish(of.value_type, position.count, words);
        });
        self.memory.loops[of.epoch] = LoopPosition::default();
        Next::Over
    }

    /// What is asked for a turn of a loop.
    fn turn(&self, of: &Loop, number: usize) -> Turn {
        match &of.turns {
            Turns::Lights { list } => Turn::OfLights(self.links.light_list(*list), number),
            Turns::Samples { site, loops, .. } => {
                Turn::OfSamples(number, iteration_key(self.memory.key(*site, loops), number))
            }
        }
    }

    /// Changes what the turns of a loop became, given it and the body's value.
    fn reduce(&mut self, of: &Loop, step: &Step, change: impl Fn(&mut [u32], &[u32])) {
        let words = &mut self.memory.words;
        let places = of.words.of(&self.code.places);
        let mut value = [0; Reduction::MOST_WORDS];
        for (word, place) in value.iter_mut().zip(places) {
            *word = words[*place as usize];
        }
        let so_far = &mut words[step.output as usize..][..step.outputs as usize];
        change(so_far, &value[..places.len()]);
    }

    /// Everything in these epochs is to be evaluated anew.
    fn pass_anew(&mut self, epochs: &[EpochId]) {
        let Memory { passes, pass, .. } = &mut *self.memory;
        *passes += 1;
        for &epoch in epochs {
            pass[epoch] = *passes;
        }
    }
}
