//! Requests of a point.

use super::code::{Request, Step};
use super::memory::Memory;
use super::run::Walk;
use crate::engine::requests::Question;
use crate::specialise::Subject;
use crate::state::State;

impl Walk<'_> {
    /// Asks the renderer, or takes what is known of a light sample.
    pub(super) fn request(&mut self, request: &Request, step: &Step, state: &State) {
        let code = self.code;
        let answer = step.output as usize..(step.output + step.outputs) as usize;
        let (sample, token) = match request.subject {
            Subject::Light { of, .. } => {
                let position = &self.memory.loops[of];
                let kept = |(table, epoch)| (table, position.turn(), self.memory.pass[epoch]);
                (request.kept.map(kept), Some(position.token))
            }
            Subject::Point | Subject::Texture(..) => (None, None),
        };
        if let Some((table, turn, pass)) = sample {
            let Memory { tables, words, .. } = &mut *self.memory;
            if let Some(known) = tables[table].known(turn, pass, answer.len()) {
                return words[answer].copy_from_slice(known);
            }
        }
        let site = self.memory.key(request.site, &request.loops);
        let question = Question::of(request.effect, request.subject, site, self.links);
        let Some(question) = question else { return };
        let Memory { asking, words, tables, .. } = &mut *self.memory;
        asking.clear();
        asking.numbers.push(0);
        asking.scoped.extend(request.scope.applied(code, words, state));
        asking.tokens.extend(token);
        let arguments = step.words.of(&code.places).iter();
        asking.arguments.extend(arguments.map(|place| words[*place as usize]));
        asking.ask(question, std::slice::from_ref(state), self.renderer);
        words[answer].copy_from_slice(&asking.answers);
        if let Some((table, turn, pass)) = sample {
            tables[table].keep(turn, pass, &asking.answers);
        }
    }
}
