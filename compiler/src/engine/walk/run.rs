//! The walk from step to step.

use super::code::{Body, Code, Demand, Kind, Scope, Span, Step};
use super::memory::{Frame, LoopPosition, Memory};
use crate::effects::Renderer;
use crate::engine::evaluations::Evaluations;
use crate::engine::links::Linked;
use crate::engine::shade::Shaded;
use crate::specialise::{EpochId, InstanceId, iteration_key};
use crate::state::{Field, State};

impl Code {
    /// Walks the graph for each point, with the words its parameters are bound to; tells how many
    /// evaluations that took.
    ///
    /// Steps that wait stand on an explicit stack, so that no chain is too deep. Nothing is hashed or
    /// allocated for a point.
    pub(in crate::engine) fn run(
        &self,
        uniforms: &[u32],
        points: &[State],
        links: Linked<'_>,
        renderer: &mut dyn Renderer,
        results: &mut [Shaded],
        memory: &mut Memory,
    ) -> Evaluations {
        memory.fit(self, uniforms);
        let mut walk = Walk { code: self, links, renderer, memory };
        for (point, result) in points.iter().zip(results) {
            *result = walk.point(point);
        }
        memory.evaluations
    }
}

/// A walk for one point after the other.
pub(super) struct Walk<'a> {
    pub(super) code: &'a Code,
    pub(super) links: Linked<'a>,
    pub(super) renderer: &'a mut dyn Renderer,
    pub(super) memory: &'a mut Memory,
}

/// How a loop goes on.
pub(super) enum Next {
    /// With a turn, for which this is to be evaluated first.
    Turn(Option<InstanceId>),
    /// Not at all: its value is there.
    Over,
}

impl Walk<'_> {
    fn point(&mut self, state: &State) -> Shaded {
        let code = self.code;
        let Memory { passes, pass, words, .. } = &mut *self.memory;
        *passes += 1;
        pass.values_mut().take(code.epochs).for_each(|pass| *pass = *passes);
        let objects = self.renderer.objects();
        for &(field, at) in &code.fields {
            objects.read(field, state, &mut words[at..at + field.value_type().width()]);
        }
        self.evaluate(code.root(), state);
        let output = &self.memory.words[code.steps[code.root()].output as usize..][..5];
        let [r, g, b, a] = [0, 1, 2, 3].map(|at| f32::from_bits(output[at]));
        Shaded { color: [r, g, b, a], ok: output[4] != 0 }
    }

    /// Evaluates a step, and before it whatever it demands.
    fn evaluate(&mut self, root: InstanceId, state: &State) {
        let code = self.code;
        let begin = |step: InstanceId| Frame { step, next: code.steps[step].demands.first };
        let mut frame = begin(root);
        self.memory.evaluations.wanted += 1;
        loop {
            let step = &code.steps[frame.step];
            if let Some(source) = self.demanded(step, &mut frame.next) {
                self.memory.stack.push(frame);
                frame = begin(source);
                self.memory.evaluations.wanted += 1;
                continue;
            }
            match &step.kind {
                Kind::Plain(body) => {
                    self.run(body, step.words, step.output as usize, step.outputs as usize);
                }
                Kind::Request(request) => self.request(request, step, state),
                Kind::Loop(of) => {
                    if let Next::Turn(body) = self.iterate(of, step, state) {
                        if let Some(body) = body {
                            self.memory.stack.push(frame);
                            frame = begin(body);
                            self.memory.evaluations.wanted += 1;
                        }
                        continue;
                    }
                }
            }
            self.memory.done[frame.step] = self.memory.pass[step.epoch];
            self.memory.evaluations.done += 1;
            match self.memory.stack.pop() {
                Some(waiting) => frame = waiting,
                None => return,
            }
        }
    }

    /// The next of a step's demands that must be evaluated first.
    #[inline]
    fn demanded(&mut self, step: &Step, next: &mut u32) -> Option<InstanceId> {
        let code = self.code;
        while *next < step.demands.end {
            let Demand { source, epoch, guard } = code.demands[*next as usize];
            *next += 1;
            if !self.is_done(source, epoch) && guard.is_none_or(|guard| self.holds(guard)) {
                return Some(source);
            }
        }
        None
    }

    #[inline]
    pub(super) fn is_done(&self, step: InstanceId, epoch: EpochId) -> bool {
        self.memory.done[step] == self.memory.pass[epoch]
    }

    fn holds(&mut self, guard: u32) -> bool {
        let guard = &self.code.guards[guard as usize];
        let outcome = self.code.outcome();
        self.run(&guard.body, guard.words, outcome, 1);
        self.memory.words[outcome] != 0
    }

    /// Runs a body, and writes its words from a place on.
    #[inline]
    fn run(&mut self, body: &Body, words: Span, at: usize, outputs: usize) {
        let places = words.of(&self.code.places);
        let Memory { words, inputs, .. } = &mut *self.memory;
        let inputs = &mut inputs[..places.len()];
        for (input, place) in inputs.iter_mut().zip(places) {
            *input = words[*place as usize];
        }
        let outputs = &mut words[at..at + outputs];
        match body {
            Body::Native(body) => body.run(inputs, outputs),
            Body::Portable(forms) => forms.scalar_portable(inputs, outputs),
        }
    }
}

impl Scope {
    /// The state with the fields that scopes changed; none where it is as it was.
    pub(super) fn applied(&self, code: &Code, words: &[u32], state: &State) -> Option<State> {
        if self.0.is_empty() {
            return None;
        }
        let mut scoped = *state;
        for (field, span) in &self.0 {
            let mut of_field = [0; Field::MOST_WORDS];
            for (word, place) in of_field.iter_mut().zip(span.of(&code.places)) {
                *word = words[*place as usize];
            }
            field.write(&mut scoped, &of_field);
        }
        Some(scoped)
    }
}

impl Memory {
    /// A key with the turns of the loops round its site.
    pub(super) fn key(&self, site: u64, loops: &[EpochId]) -> u64 {
        let turn = |epoch: EpochId| self.loops[epoch].turn();
        loops.iter().fold(site, |key, &epoch| iteration_key(key, turn(epoch)))
    }
}

impl LoopPosition {
    /// The number of the turn that runs.
    pub(super) fn turn(&self) -> usize {
        self.next.wrapping_sub(1)
    }
}
