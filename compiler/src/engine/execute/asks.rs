//! Requests of a batch.

use crate::engine::requests::Question;
use crate::schedule::{LoopId, Request};
use crate::specialise::{LightTableId, Subject};
use crate::storage::LANES;

use super::memory::Table;
use super::run::Run;

impl Run<'_> {
    /// Asks the renderer for the chosen points; about a light sample, for those of which the answer is
    /// not known yet.
    pub(super) fn request(&mut self, request: &Request) {
        let site = self.key(request.site, &request.loops);
        let (effect, subject) = (request.effect, request.subject);
        let Some(question) = Question::of(effect, subject, site, self.links) else { return };
        let mut chosen = std::mem::take(&mut self.memory.chosen);
        if let (Subject::Light { of, table }, true) = (subject, request.again) {
            self.take_known(request, of, table, &mut chosen);
        }
        if !chosen.is_empty() {
            self.ask(request, question, &chosen);
        }
        self.memory.chosen = chosen;
    }

    /// Asks the renderer for points and writes the answers.
    fn ask(&mut self, request: &Request, question: Question, points: &[usize]) {
        let mut asking = self.memory.asking.take().unwrap_or_default();
        asking.clear();
        asking.numbers.extend(points.iter().map(|&point| point as u32));
        if !request.context.is_empty() {
            let scoped = |&point: &usize| self.scoped(point, &request.context);
            asking.scoped.extend(points.iter().map(scoped));
        }
        if let Subject::Light { of, .. } = request.subject {
            asking.tokens.extend(points.iter().map(|&point| self.memory.tokens[of][point]));
        }
        self.gather_words(&request.words, points, &mut asking.arguments);
        asking.ask(question, self.points, self.renderer);
        let width = request.outputs as usize;
        for (&point, words) in points.iter().zip(asking.answers.chunks_exact(width)) {
            self.set_all(request.output, point, words);
        }
        if let (Subject::Light { of, table }, true) = (request.subject, request.again) {
            let turn = self.memory.iterations[of].wrapping_sub(1);
            let kept = &mut self.memory.tables[table][turn];
            for (&point, words) in points.iter().zip(asking.answers.chunks_exact(width)) {
                kept.known[point / LANES] |= 1 << (point % LANES);
                kept.words[point * width..][..width].copy_from_slice(words);
            }
        }
        self.memory.asking = Some(asking);
    }

    /// Writes what is known of the light sample, and leaves the points of which nothing is.
    fn take_known(
        &mut self,
        request: &Request,
        of: LoopId,
        table: LightTableId,
        points: &mut Vec<usize>,
    ) {
        let width = request.outputs as usize;
        let turn = self.memory.iterations[of].wrapping_sub(1);
        let kept = &mut self.memory.tables[table];
        if kept.len() <= turn {
            kept.resize(turn + 1, Table::default());
        }
        let mut kept = std::mem::take(&mut kept[turn]);
        kept.known.resize(self.blocks.max(kept.known.len()), 0);
        kept.words.resize((self.blocks * LANES * width).max(kept.words.len()), 0);
        points.retain(|&point| {
            let is_known = kept.known[point / LANES] >> (point % LANES) & 1 == 1;
            if is_known {
                self.set_all(request.output, point, &kept.words[point * width..][..width]);
            }
            !is_known
        });
        self.memory.tables[table][turn] = kept;
    }
}
