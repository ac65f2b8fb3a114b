//! The tree walk: one point at a time, inputs evaluated when a body demands them, each result kept
//! until its epoch is passed anew. What mi_eval and its cache do, and the oracle of the other
//! engines.
//!
//! Instances stand on an explicit stack, so that no chain is too deep. The cache is indexed, and
//! stamped rather than emptied: nothing is hashed or allocated for a point, but by portable forms, which
//! look up what their bodies recorded.

use cranelift_entity::{EntityRef, PrimaryMap, SecondaryMap};

use crate::effects::{LightList, Renderer, TextureId};
use crate::kernels::BodyForms;
use crate::specialise::{
    Context, EpochId, Instance, InstanceId, InstanceKind, LightListId, LightTableId, Specialised,
    Subject, TexturePosition, Turns,
};
use crate::state::{Field, Reduction, State};
use crate::storage::Source;
use crate::values::Type;

use super::options::Simd;
use super::requests::{Asking, Question, iteration_key};
use super::shade::Shaded;
use super::turns::{Turn, Turning, turns_of};

/// Walks `graph` for each point, with the words its parameters are bound to.
pub fn walk(
    graph: &Specialised,
    uniforms: &[u32],
    simd: Simd,
    points: &[State],
    renderer: &mut dyn Renderer,
    results: &mut [Shaded],
    memory: &mut Memory,
) {
    let lists = graph.light_lists.values().map(|names| renderer.light_list(names)).collect();
    let textures = graph.textures.values().map(|texture| renderer.texture(texture)).collect();
    memory.fit(graph);
    memory.words[..uniforms.len()].copy_from_slice(uniforms);
    let uniforms = uniforms.len();
    let mut walk =
        Walk { graph, simd, lists: &lists, textures: &textures, uniforms, renderer, memory };
    for (point, result) in points.iter().zip(results) {
        *result = walk.point(point);
    }
}

/// What a walk works in; kept between walks so that nothing is allocated per point.
#[derive(Debug, Default)]
pub struct Memory {
    /// Uniform words, then slots, then one for the outcome of a guard.
    words: Vec<u32>,
    /// Per instance, the pass through its epoch in which it was evaluated.
    done: SecondaryMap<InstanceId, u64>,
    /// Per epoch, the current pass.
    pass: SecondaryMap<EpochId, u64>,
    passes: u64,
    /// Per epoch that is a loop: where it stands.
    loops: SecondaryMap<EpochId, LoopPosition>,
    tables: SecondaryMap<LightTableId, Kept>,
    stack: Vec<Frame>,
    inputs: Vec<u32>,
    asking: Asking,
    turning: Turning,
}

#[derive(Clone, Copy, Debug, Default)]
struct LoopPosition {
    next: usize,
    count: usize,
    running: bool,
    /// Of the light sample.
    token: u64,
}

/// Answers about the samples of a light list, and for each the pass in which it was asked for.
#[derive(Clone, Debug, Default)]
struct Kept {
    passes: Vec<u64>,
    words: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct Frame {
    instance: InstanceId,
    /// The next of its demands.
    next: usize,
}

impl Memory {
    fn fit(&mut self, graph: &Specialised) {
        // The last word is for what a guard yields.
        let words = graph.uniforms.values().len() + graph.slots as usize + 1;
        self.words.resize(words.max(self.words.len()), 0);
        // Stamps another graph left behind do not count: every pass number is used once.
        grow(&mut self.done, graph.instances.len());
        grow(&mut self.pass, graph.epochs.0.len());
    }
}

/// Makes room for the first `count` keys; what is there stays.
fn grow<K: EntityRef>(map: &mut SecondaryMap<K, u64>, count: usize) {
    map.resize(count.max(map.as_values_slice().len()));
}

struct Walk<'a> {
    graph: &'a Specialised,
    simd: Simd,
    lists: &'a PrimaryMap<LightListId, LightList>,
    textures: &'a PrimaryMap<TexturePosition, TextureId>,
    uniforms: usize,
    renderer: &'a mut dyn Renderer,
    memory: &'a mut Memory,
}

impl Walk<'_> {
    fn point(&mut self, state: &State) -> Shaded {
        let graph = self.graph;
        self.memory.passes += 1;
        let Memory { pass, passes, .. } = &mut *self.memory;
        pass.values_mut().for_each(|pass| *pass = *passes);
        for &(field, first) in &graph.fields {
            let at = self.uniforms + first as usize;
            field.read(state, &mut self.memory.words[at..at + field.value_type().width()]);
        }
        let root = graph.root();
        self.memory.stack.push(Frame { instance: root, next: 0 });
        while let Some(frame) = self.memory.stack.pop() {
            self.step(frame, state);
        }
        let output = self.uniforms + graph.instances[root].output as usize;
        let word = |at: usize| f32::from_bits(self.memory.words[output + at]);
        Shaded {
            color: [word(0), word(1), word(2), word(3)],
            ok: self.memory.words[output + 4] != 0,
        }
    }

    fn is_done(&self, instance: InstanceId) -> bool {
        let epoch = self.graph.instances[instance].epoch;
        self.memory.done[instance] == self.memory.pass[epoch]
    }

    fn mark_done(&mut self, instance: InstanceId) {
        let epoch = self.graph.instances[instance].epoch;
        self.memory.done[instance] = self.memory.pass[epoch];
    }

    /// Goes on with an instance until something it demands must be evaluated first, or it is done.
    fn step(&mut self, mut frame: Frame, state: &State) {
        let graph = self.graph;
        let instance = &graph.instances[frame.instance];
        while let Some(demand) = instance.demands.get(frame.next) {
            frame.next += 1;
            if self.is_done(demand.source) {
                continue;
            }
            let holds = match &demand.guard {
                Some(guard) => {
                    let outcome = self.uniforms + graph.slots as usize;
                    self.run(&guard.code, &guard.words, outcome, 1);
                    self.memory.words[outcome] != 0
                }
                None => true,
            };
            if holds {
                self.memory.stack.push(frame);
                self.memory.stack.push(Frame { instance: demand.source, next: 0 });
                return;
            }
        }
        match &instance.kind {
            InstanceKind::Plain(code) => self.plain(instance, code),
            InstanceKind::Request { .. } => self.request(instance, state),
            InstanceKind::Loop { .. } => {
                if self.iterate(instance, frame, state) {
                    return;
                }
            }
        }
        self.mark_done(frame.instance);
    }

    /// Runs a body, and writes its words from a position on.
    fn run(&mut self, code: &BodyForms, sources: &[Source], at: usize, outputs: usize) {
        let mut inputs = std::mem::take(&mut self.memory.inputs);
        inputs.clear();
        inputs.extend(sources.iter().map(|source| self.word(*source)));
        let outputs = &mut self.memory.words[at..at + outputs];
        match self.simd {
            Simd::Native => (code.scalar)(&inputs, outputs),
            Simd::Portable => code.scalar_portable(&inputs, outputs),
        }
        self.memory.inputs = inputs;
    }

    #[inline]
    fn word(&self, source: Source) -> u32 {
        match source {
            Source::Constant { bits, .. } => bits,
            Source::Uniform(at) => self.memory.words[at as usize],
            Source::Slot(slot) => self.memory.words[self.uniforms + slot as usize],
        }
    }

    fn set(&mut self, slot: u32, word: u32) {
        self.memory.words[self.uniforms + slot as usize] = word;
    }

    fn plain(&mut self, instance: &Instance, code: &BodyForms) {
        let at = self.uniforms + instance.output as usize;
        self.run(code, &instance.words, at, instance.outputs as usize);
    }

    /// The state with the fields that scopes changed.
    fn scoped(&self, state: &State, context: &Context) -> State {
        let mut scoped = *state;
        for (field, sources) in context {
            let mut words = [0; Field::MOST_WORDS];
            for (word, source) in words.iter_mut().zip(sources) {
                *word = self.word(*source);
            }
            field.write(&mut scoped, &words);
        }
        scoped
    }

    /// A request's key: its site, and the iterations of the loops round it.
    fn key(&self, site: u64, loops: &[EpochId]) -> u64 {
        loops.iter().fold(site, |key, &epoch| {
            iteration_key(key, self.memory.loops[epoch].next.wrapping_sub(1))
        })
    }

    /// Asks the renderer, or takes what is known of a light sample.
    fn request(&mut self, instance: &Instance, state: &State) {
        let InstanceKind::Request { effect, context, site, loops, subject } = &instance.kind else {
            return;
        };
        let width = instance.outputs as usize;
        let first = self.uniforms + instance.output as usize;
        let kept = self.kept(*subject);
        if let Some((table, turn, pass)) = kept {
            let Memory { tables, words, .. } = &mut *self.memory;
            if let Some(known) = tables[table].known(turn, pass, width) {
                return words[first..first + width].copy_from_slice(known);
            }
        }
        let site = self.key(*site, loops);
        let Some(question) = Question::of(*effect, *subject, site, self.textures) else { return };
        let mut asking = std::mem::take(&mut self.memory.asking);
        asking.clear();
        if !effect.reads().is_empty() {
            asking.states.push(self.scoped(state, context));
        }
        if let Subject::Light { of, .. } = subject {
            asking.tokens.push(self.memory.loops[*of].token);
        }
        asking.arguments.extend(instance.words.iter().map(|source| self.word(*source)));
        asking.ask(question, self.renderer);
        self.memory.words[first..first + width].copy_from_slice(&asking.answers);
        if let Some((table, turn, pass)) = kept {
            self.memory.tables[table].keep(turn, pass, &asking.answers);
        }
        self.memory.asking = asking;
    }

    /// Where an answer about a light sample is kept: its table, the turn of its loop, and the pass in
    /// which it holds.
    fn kept(&self, subject: Subject<EpochId>) -> Option<(LightTableId, usize, u64)> {
        let Subject::Light { of, table } = subject else { return None };
        let turn = self.memory.loops[of].next.wrapping_sub(1);
        Some((table, turn, self.memory.pass[self.graph.tables[table].epoch]))
    }

    /// Starts the next turn of a loop that the point takes part in. False when the loop is over and
    /// its value stored.
    fn iterate(&mut self, instance: &Instance, frame: Frame, state: &State) -> bool {
        let InstanceKind::Loop { epoch, turns, fields, body, context, .. } = &instance.kind else {
            return false;
        };
        let mut position = self.memory.loops[*epoch];
        if position.running {
            self.reduce(instance, |reduction, of, words, value| reduction.take(of, words, value));
        } else {
            self.reduce(instance, |reduction, of, words, _| reduction.start(of, words));
            let count = match turns {
                Turns::Lights { list } => self.renderer.light_count(self.lists[*list]),
                Turns::Samples { count, .. } => turns_of(self.word(*count)),
            };
            position = LoopPosition { count, running: true, ..LoopPosition::default() };
        }
        let mut turning = std::mem::take(&mut self.memory.turning);
        turning.clear();
        match turns {
            Turns::Lights { .. } => turning.states.push(self.scoped(state, context)),
            Turns::Samples { .. } => turning.paths.push((state.path, position.count)),
        }
        let mut goes_on = false;
        while position.next < position.count && !goes_on {
            turning.turn(self.turn(turns, position.next), self.renderer);
            position.next += 1;
            goes_on = turning.reached[0];
        }
        if goes_on {
            position.token = turning.tokens[0];
            self.memory.loops[*epoch] = position;
            self.pass_anew(*epoch);
            for (slot, word) in (*fields..).zip(&turning.words) {
                self.set(slot, *word);
            }
            self.memory.stack.push(frame);
            // A body that does not look at the turn belongs to an outer epoch: once is enough.
            if let Some(body) = body.filter(|body| !self.is_done(*body)) {
                self.memory.stack.push(Frame { instance: body, next: 0 });
            }
        } else {
            let turns = position.count;
            self.reduce(instance, |reduction, of, words, _| reduction.finish(of, turns, words));
            self.memory.loops[*epoch] = LoopPosition::default();
        }
        self.memory.turning = turning;
        goes_on
    }

    /// What is asked for a turn of a loop.
    fn turn(&self, turns: &Turns<EpochId>, number: usize) -> Turn {
        match turns {
            Turns::Lights { list } => Turn::OfLights(self.lists[*list], number),
            Turns::Samples { site, loops, .. } => {
                Turn::OfSamples(number, iteration_key(self.key(*site, loops), number))
            }
        }
    }

    /// Changes what the turns of a loop became, given it and the body's value.
    fn reduce(
        &mut self,
        instance: &Instance,
        change: impl Fn(Reduction, Type, &mut [u32], &[u32]),
    ) {
        let InstanceKind::Loop { reduction, value_type, words, .. } = &instance.kind else {
            return;
        };
        let mut value = [0; Reduction::MOST_WORDS];
        for (word, source) in value.iter_mut().zip(words) {
            *word = self.word(*source);
        }
        let first = self.uniforms + instance.output as usize;
        let so_far = &mut self.memory.words[first..first + instance.outputs as usize];
        change(*reduction, *value_type, so_far, &value[..words.len()]);
    }

    /// Everything in the epoch, and in those inside it, is to be evaluated anew.
    fn pass_anew(&mut self, epoch: EpochId) {
        self.memory.passes += 1;
        for inner in self.graph.epochs.0.keys().skip(epoch.index()) {
            if self.graph.epochs.within(inner, epoch) {
                self.memory.pass[inner] = self.memory.passes;
            }
        }
    }
}

impl Kept {
    /// The answer about a turn, if it was asked for in this pass.
    fn known(&self, turn: usize, pass: u64, width: usize) -> Option<&[u32]> {
        let is_known = self.passes.get(turn) == Some(&pass);
        is_known.then(|| &self.words[turn * width..][..width])
    }

    fn keep(&mut self, turn: usize, pass: u64, words: &[u32]) {
        let turns = self.passes.len().max(turn + 1);
        self.passes.resize(turns, 0);
        self.words.resize(turns * words.len(), 0);
        self.passes[turn] = pass;
        self.words[turn * words.len()..][..words.len()].copy_from_slice(words);
    }
}
