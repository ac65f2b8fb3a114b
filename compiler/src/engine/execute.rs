//! Runs a schedule over a batch of points: the one executor batch and jit share. They differ in how
//! a segment is run.

use crate::effects::{LightList, LightSample, Renderer, TextureId};
use crate::schedule::{Item, Loop, RegionId, Request, Schedule};
use crate::specialise::{Context, Subject};
use crate::state::State;

use super::requests::{Asking, Question, iteration_key};
use super::runner::Runner;
use super::shade::Shaded;
use crate::storage::{FileShape, LANES, Lanes, Source};

/// Bytes of slots a batch may fill; larger programs run fewer points at once.
const MAX_FILE_BYTES: usize = 64 << 20;

/// A schedule with the way to run its segments.
pub struct Program<'a> {
    /// The schedule.
    pub schedule: &'a Schedule,
    /// Uniform words.
    pub uniforms: &'a [u32],
    /// How segments are run.
    pub runner: Runner<'a>,
    /// Most points at once.
    pub batch: usize,
}

/// What the executor works in; kept between batches.
#[derive(Debug, Default)]
pub struct Memory {
    lanes: Vec<Lanes>,
    /// Per region and block, the lanes it is being run for.
    todo: Vec<u8>,
    /// Per region and block, the lanes it was run for.
    done: Vec<u8>,
    /// Per table and iteration, answers kept.
    tables: Vec<Vec<Table>>,
    /// Per loop, its iteration.
    iterations: Vec<usize>,
    /// Per loop and point, the token of the light sample.
    tokens: Vec<Vec<u64>>,
    stack: Vec<Frame>,
    chosen: Vec<usize>,
    states: Vec<State>,
    asking: Asking,
    samples: Vec<LightSample>,
}

/// Answers about one light sample.
#[derive(Clone, Debug, Default)]
struct Table {
    /// Per block, the lanes whose answers are known.
    known: Vec<u8>,
    /// Per point, the words of its answer.
    words: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
enum Frame {
    Region { region: RegionId, item: usize },
    Loop { at: usize, within: RegionId, count: usize },
}

impl Program<'_> {
    /// The shape of its file: the schedule's slots, and what the runner needs besides.
    fn shape(&self) -> FileShape {
        FileShape { uniforms: self.uniforms.len(), slots: self.runner.slots(self.schedule) }
    }

    /// Shades `points` and writes one result each.
    pub fn run(
        &self,
        points: &[State],
        renderer: &mut dyn Renderer,
        results: &mut [Shaded],
        memory: &mut Memory,
    ) {
        let shape = self.shape();
        let block_bytes = shape.slots.max(1) * size_of::<Lanes>();
        let most = self.batch.div_ceil(LANES).min(MAX_FILE_BYTES / block_bytes).max(1) * LANES;
        let chunk = most.min(self.batch.max(1));
        let lists: Vec<LightList> =
            self.schedule.light_lists.iter().map(|names| renderer.light_list(names)).collect();
        let textures: Vec<TextureId> =
            self.schedule.textures.iter().map(|texture| renderer.texture(texture)).collect();
        for (points, results) in points.chunks(chunk).zip(results.chunks_mut(chunk)) {
            let blocks = points.len().div_ceil(LANES);
            memory.fit(self, shape, blocks);
            let mut run = Run {
                program: self,
                shape,
                points,
                blocks,
                lists: &lists,
                textures: &textures,
                renderer,
                memory,
            };
            run.load();
            run.regions();
            run.store(results);
        }
    }
}

impl Memory {
    fn fit(&mut self, program: &Program<'_>, shape: FileShape, blocks: usize) {
        let schedule = program.schedule;
        self.lanes.resize(shape.words(blocks).max(self.lanes.len()), Lanes::default());
        for (lane, word) in self.lanes.iter_mut().zip(program.uniforms) {
            *lane = Lanes([*word; LANES]);
        }
        let masks = schedule.regions.len() * blocks;
        self.todo.clear();
        self.todo.resize(masks, 0);
        self.done.clear();
        self.done.resize(masks, 0);
        self.iterations.clear();
        self.iterations.resize(schedule.loops.len(), 0);
        self.tokens.resize_with(schedule.loops.len().max(self.tokens.len()), Vec::new);
        self.tables.resize_with(schedule.tables.len().max(self.tables.len()), Vec::new);
        self.tables.iter_mut().for_each(|table| empty(table));
    }
}

/// Forgets the answers of a table.
fn empty(table: &mut [Table]) {
    for sample in table {
        sample.known.fill(0);
    }
}

struct Run<'a> {
    program: &'a Program<'a>,
    shape: FileShape,
    points: &'a [State],
    blocks: usize,
    lists: &'a [LightList],
    textures: &'a [TextureId],
    renderer: &'a mut dyn Renderer,
    memory: &'a mut Memory,
}

impl Run<'_> {
    /// Position in the file of a source for the block.
    #[inline]
    fn at(&self, source: Source, block: usize) -> usize {
        match source {
            Source::Uniform(at) | Source::Constant { at, .. } => at as usize,
            Source::Slot(slot) => self.shape.slot(slot, block),
        }
    }

    #[inline]
    fn word(&self, source: Source, point: usize) -> u32 {
        self.memory.lanes[self.at(source, point / LANES)].0[point % LANES]
    }

    #[inline]
    fn set(&mut self, slot: u32, point: usize, word: u32) {
        let at = self.shape.slot(slot, point / LANES);
        self.memory.lanes[at].0[point % LANES] = word;
    }

    /// Writes the state fields in use, and the mask of all points.
    fn load(&mut self) {
        for &(field, first) in &self.program.schedule.fields {
            let width = field.value_type().width();
            for (point, state) in self.points.iter().enumerate() {
                let words = field.read(state);
                for (slot, word) in (first..).zip(&words[..width]) {
                    self.set(slot, point, *word);
                }
            }
        }
        for block in 0..self.blocks {
            let lanes = (self.points.len() - block * LANES).min(LANES);
            self.memory.todo[block] = (0xff_u32 >> (LANES - lanes)) as u8;
        }
    }

    fn store(&self, results: &mut [Shaded]) {
        let root = self.program.schedule.root;
        for (point, result) in results.iter_mut().enumerate() {
            let word = |at| self.word(Source::Slot(root + at), point);
            *result = Shaded {
                color: [word(0), word(1), word(2), word(3)].map(f32::from_bits),
                ok: word(4) != 0,
            };
        }
    }

    fn regions(&mut self) {
        self.memory.stack.clear();
        self.memory.stack.push(Frame::Region { region: 0, item: 0 });
        while let Some(frame) = self.memory.stack.pop() {
            match frame {
                Frame::Region { region, item } => self.region(region, item),
                Frame::Loop { at, within, count } => self.iterate(at, within, count),
            }
        }
    }

    /// Goes on with a region until another one is to be run first.
    fn region(&mut self, region: RegionId, mut item: usize) {
        let program = self.program;
        while let Some(next) = program.schedule.regions[region].items.get(item) {
            item += 1;
            match next {
                Item::Segment(at) => {
                    let (shape, blocks) = (self.shape, self.blocks);
                    let lanes = &mut self.memory.lanes;
                    program.runner.segment(program.schedule, *at, shape, lanes, blocks);
                }
                Item::Force { region: forced, guard } => {
                    if self.force(region, *forced, *guard) {
                        self.memory.stack.push(Frame::Region { region, item });
                        self.memory.stack.push(Frame::Region { region: *forced, item: 0 });
                        return;
                    }
                }
                Item::Request(at) => {
                    let request = &program.schedule.requests[*at];
                    self.choose(region);
                    if !self.memory.chosen.is_empty() {
                        self.request(request);
                    }
                }
                Item::Loop(at) => {
                    let of = &program.schedule.loops[*at];
                    let count = self.renderer.light_count(self.lists[of.list]);
                    self.start(of, region);
                    self.memory.iterations[*at] = 0;
                    self.memory.stack.push(Frame::Region { region, item });
                    self.memory.stack.push(Frame::Loop { at: *at, within: region, count });
                    return;
                }
            }
        }
    }

    /// Sets what a region is to be run for; false if nothing is left to do.
    fn force(&mut self, from: RegionId, region: RegionId, guard: Option<Source>) -> bool {
        let mut any = false;
        for block in 0..self.blocks {
            let mut mask = self.memory.todo[from * self.blocks + block];
            if let Some(guard) = guard {
                mask &= bits(&self.memory.lanes[self.at(guard, block)]);
            }
            let at = region * self.blocks + block;
            mask &= !self.memory.done[at];
            self.memory.done[at] |= mask;
            self.memory.todo[at] = mask;
            any |= mask != 0;
        }
        any
    }

    /// Lists the points a region is being run for.
    fn choose(&mut self, region: RegionId) {
        let masks = &self.memory.todo[region * self.blocks..][..self.blocks];
        self.memory.chosen.clear();
        for (block, &mask) in masks.iter().enumerate() {
            let mut rest = mask;
            while rest != 0 {
                self.memory.chosen.push(block * LANES + rest.trailing_zeros() as usize);
                rest &= rest - 1;
            }
        }
    }

    /// The state of a point with the fields that scopes changed.
    fn scoped(&self, point: usize, context: &Context) -> State {
        let mut state = self.points[point];
        for (field, sources) in context {
            let mut words = [0; 4];
            for (word, source) in words.iter_mut().zip(sources) {
                *word = self.word(*source, point);
            }
            field.write(&mut state, words);
        }
        state
    }

    /// Asks the renderer for the chosen points; about a light sample, for those of which the answer is
    /// not known yet.
    fn request(&mut self, request: &Request) {
        let site = request.loops.iter().fold(request.site, |key, &at| {
            iteration_key(key, self.memory.iterations[at].wrapping_sub(1))
        });
        let (effect, subject) = (request.effect, request.subject);
        let Some(question) = Question::of(effect, subject, site, self.textures) else { return };
        let mut chosen = std::mem::take(&mut self.memory.chosen);
        if let Subject::Light { of, table } = subject {
            self.take_known(request, of, table, &mut chosen);
        }
        if !chosen.is_empty() {
            self.ask(request, question, &chosen);
        }
        self.memory.chosen = chosen;
    }

    /// Asks the renderer for points and writes the answers.
    fn ask(&mut self, request: &Request, question: Question, points: &[usize]) {
        let mut asking = std::mem::take(&mut self.memory.asking);
        asking.clear();
        if !request.effect.reads().is_empty() {
            let scoped = |&point: &usize| self.scoped(point, &request.context);
            asking.states.extend(points.iter().map(scoped));
        }
        if let Subject::Light { of, .. } = request.subject {
            asking.tokens.extend(points.iter().map(|&point| self.memory.tokens[of][point]));
        }
        for &point in points {
            asking.arguments.extend(request.words.iter().map(|source| self.word(*source, point)));
        }
        asking.ask(question, self.renderer);
        let width = request.outputs as usize;
        for (&point, words) in points.iter().zip(asking.answers.chunks_exact(width)) {
            for (slot, word) in (request.output..).zip(words) {
                self.set(slot, point, *word);
            }
        }
        if let Subject::Light { of, table } = request.subject {
            let turn = self.memory.iterations[of].wrapping_sub(1);
            let kept = &mut self.memory.tables[table][turn];
            for (&point, words) in points.iter().zip(asking.answers.chunks_exact(width)) {
                kept.known[point / LANES] |= 1 << (point % LANES);
                kept.words[point * width..][..width].copy_from_slice(words);
            }
        }
        self.memory.asking = asking;
    }

    /// Writes what is known of the light sample, and leaves the points of which nothing is.
    fn take_known(&mut self, request: &Request, of: usize, table: usize, points: &mut Vec<usize>) {
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
                for (slot, word) in (request.output..).zip(&kept.words[point * width..][..width]) {
                    self.set(slot, point, *word);
                }
            }
            !is_known
        });
        self.memory.tables[table][turn] = kept;
    }

    /// Clears the sum where the loop is to be run.
    fn start(&mut self, of: &Loop, within: RegionId) {
        self.choose(within);
        let chosen = std::mem::take(&mut self.memory.chosen);
        for &point in &chosen {
            for (slot, x) in (of.output..).zip([0.0_f32, 0.0, 0.0, 1.0]) {
                self.set(slot, point, x.to_bits());
            }
        }
        self.memory.chosen = chosen;
    }

    /// Adds what the last iteration yielded, if there was one, and starts the next.
    fn iterate(&mut self, at: usize, within: RegionId, count: usize) {
        let of = &self.program.schedule.loops[at];
        if self.memory.iterations[at] > 0 {
            self.choose(of.region);
            let chosen = std::mem::take(&mut self.memory.chosen);
            for &point in &chosen {
                for (slot, source) in (of.output..).zip(&of.words) {
                    let sum = f32::from_bits(self.word(Source::Slot(slot), point));
                    let sum = sum + f32::from_bits(self.word(*source, point));
                    self.set(slot, point, sum.to_bits());
                }
            }
            self.memory.chosen = chosen;
        }
        while self.memory.iterations[at] < count {
            let iteration = self.memory.iterations[at];
            self.memory.iterations[at] += 1;
            if self.sample(at, within, iteration) {
                self.renew(of);
                self.memory.stack.push(Frame::Loop { at, within, count });
                self.memory.stack.push(Frame::Region { region: of.region, item: 0 });
                return;
            }
        }
    }

    /// Writes the light sample of an iteration, and the mask of the points it can reach; false if
    /// it reaches none.
    fn sample(&mut self, at: usize, within: RegionId, iteration: usize) -> bool {
        let of = &self.program.schedule.loops[at];
        self.choose(within);
        let chosen = std::mem::take(&mut self.memory.chosen);
        let mut states = std::mem::take(&mut self.memory.states);
        states.clear();
        states.extend(chosen.iter().map(|&point| self.scoped(point, &of.context)));
        let mut samples = std::mem::take(&mut self.memory.samples);
        samples.clear();
        samples.resize(states.len(), LightSample::default());
        let list = self.lists[of.list];
        self.renderer.light_samples(list, iteration, &states, &mut samples);
        self.memory.todo[of.region * self.blocks..][..self.blocks].fill(0);
        self.memory.tokens[at].resize(self.blocks * LANES, 0);
        let mut any = false;
        for (&point, sample) in chosen.iter().zip(&samples) {
            if !sample.reachable {
                continue;
            }
            any = true;
            self.memory.tokens[at][point] = sample.token;
            self.memory.todo[of.region * self.blocks + point / LANES] |= 1 << (point % LANES);
            for (slot, x) in (of.fields..).zip(sample.direction) {
                self.set(slot, point, x.to_bits());
            }
            self.set(of.fields + 3, point, sample.distance.to_bits());
        }
        self.memory.chosen = chosen;
        self.memory.states = states;
        self.memory.samples = samples;
        any
    }

    /// Forgets what was evaluated in the last iteration.
    fn renew(&mut self, of: &Loop) {
        for &region in &of.renewed {
            self.memory.done[region * self.blocks..][..self.blocks].fill(0);
        }
        for &table in &of.emptied {
            empty(&mut self.memory.tables[table]);
        }
    }
}

/// The lanes whose mask word is set.
fn bits(lanes: &Lanes) -> u8 {
    lanes.0.iter().enumerate().fold(0, |bits, (lane, word)| bits | ((word >> 31) as u8) << lane)
}
