//! The regions of a schedule, over a batch of points.

use cranelift_entity::EntityRef;

use crate::effects::Renderer;
use crate::engine::Evaluations;
use crate::engine::links::Linked;
use crate::engine::runner::Runner;
use crate::engine::shade::Shaded;
use crate::schedule::{Item, RegionId, Schedule};
use crate::specialise::{Context, Specialised};
use crate::state::{Field, Objects, State};
use crate::storage::{FileShape, LANES, Lanes, Source};

use super::memory::{Frame, Memory, UniformWords};

/// Bytes of slots a batch may fill; larger programs run fewer points at once.
const MAX_FILE_BYTES: usize = 64 << 20;

/// A schedule with the way to run its segments.
pub struct Program<'a> {
    /// The schedule.
    pub schedule: &'a Schedule,
    /// Uniform words.
    pub uniforms: UniformWords<'a>,
    /// How segments are run.
    pub runner: Runner<'a>,
    /// Most points at once.
    pub batch: usize,
    /// What it was scheduled from, where evaluations of nodes are counted.
    pub counted: Option<&'a Specialised>,
}

impl Program<'_> {
    /// The shape of its file: the schedule's slots, and what the runner needs besides.
    fn shape(&self) -> FileShape {
        FileShape { uniforms: self.uniforms.words.len(), slots: self.runner.slots(self.schedule) }
    }

    /// Shades `points` and writes one result each; tells how many evaluations that took, if they are counted.
    pub(in crate::engine) fn run(
        &self,
        points: &[State],
        links: Linked<'_>,
        renderer: &mut dyn Renderer,
        results: &mut [Shaded],
        memory: &mut Memory,
    ) -> Evaluations {
        memory.tally.counted = Evaluations::default();
        let shape = self.shape();
        let chunk = self.most_points(shape, points.len());
        let (mut points, mut results) = (points, results);
        while !points.is_empty() {
            let at = chunk.min(points.len());
            let (now, later) = points.split_at(at);
            let (written, unwritten) = results.split_at_mut(at);
            self.run_batch(shape, now, links, &mut *renderer, written, memory);
            (points, results) = (later, unwritten);
        }
        memory.tally.counted
    }

    /// Most points that are run at once, of so many.
    fn most_points(&self, shape: FileShape, points: usize) -> usize {
        if points <= LANES.min(self.batch) {
            return LANES;
        }
        let block_bytes = shape.slots.max(1) * size_of::<Lanes>();
        let most = self.batch.div_ceil(LANES).min(MAX_FILE_BYTES / block_bytes).max(1) * LANES;
        most.min(self.batch.max(1))
    }

    fn run_batch(
        &self,
        shape: FileShape,
        points: &[State],
        links: Linked<'_>,
        renderer: &mut dyn Renderer,
        results: &mut [Shaded],
        memory: &mut Memory,
    ) {
        let blocks = points.len().div_ceil(LANES);
        memory.fit(self.uniforms, shape, blocks);
        if let (Some(segment), None) = (self.schedule.only_segment(), self.counted) {
            let mut run = Run { program: self, shape, points, blocks, links, renderer, memory };
            run.load();
            let Memory { lanes, runs, .. } = &mut *run.memory;
            runs.all(blocks);
            self.runner.segment(self.schedule, segment, shape, lanes, runs);
            run.store(results);
            return;
        }
        memory.begin(self.schedule, blocks);
        memory.tally.fit(self.counted, blocks);
        let mut run = Run { program: self, shape, points, blocks, links, renderer, memory };
        run.load();
        run.choose_all();
        run.regions();
        run.settle_points();
        run.store(results);
    }
}

/// A program with a batch of points.
pub(super) struct Run<'a> {
    pub(super) program: &'a Program<'a>,
    pub(super) shape: FileShape,
    pub(super) points: &'a [State],
    pub(super) blocks: usize,
    pub(super) links: Linked<'a>,
    pub(super) renderer: &'a mut dyn Renderer,
    pub(super) memory: &'a mut Memory,
}

impl Run<'_> {
    /// Position in the file of a source for the block.
    #[inline]
    fn at(&self, source: Source, block: usize) -> usize {
        self.shape.at(source, block)
    }

    #[inline]
    pub(super) fn word(&self, source: Source, point: usize) -> u32 {
        self.memory.lanes[self.at(source, point / LANES)].0[point % LANES]
    }

    /// Writes the words of a point to slots next to one another.
    #[inline]
    pub(super) fn set_all(&mut self, first: u32, point: usize, words: &[u32]) {
        let at = self.shape.slot(first, point / LANES);
        for (lanes, word) in self.memory.lanes[at..at + words.len()].iter_mut().zip(words) {
            lanes.0[point % LANES] = *word;
        }
    }

    /// Reads the words of a point from slots next to one another.
    #[inline]
    pub(super) fn read_all(&self, first: u32, point: usize, words: &mut [u32]) {
        let at = self.shape.slot(first, point / LANES);
        for (word, lanes) in words.iter_mut().zip(&self.memory.lanes[at..]) {
            *word = lanes.0[point % LANES];
        }
    }

    /// Words of points, as many for each as there are sources; source by source, for where a source lies is
    /// the same for all points.
    pub(super) fn gather_words(&self, sources: &[Source], points: &[usize], words: &mut Vec<u32>) {
        words.clear();
        words.resize(sources.len() * points.len(), 0);
        if sources.is_empty() {
            return;
        }
        for (nth, &source) in sources.iter().enumerate() {
            let rows = points.iter().zip(words.chunks_exact_mut(sources.len()));
            match source {
                Source::Slot(slot) => rows.for_each(|(&point, row)| {
                    let at = self.shape.slot(slot, point / LANES);
                    row[nth] = self.memory.lanes[at].0[point % LANES];
                }),
                Source::Uniform(_) | Source::Constant { .. } => {
                    let word = self.word(source, 0);
                    rows.for_each(|(_, row)| row[nth] = word);
                }
            }
        }
    }

    /// Where the mask of a region stands for the block.
    #[inline]
    pub(super) fn mask(&self, region: RegionId, block: usize) -> usize {
        region.index() * self.blocks + block
    }

    /// Writes the state fields in use, block by block.
    fn load(&mut self) {
        let objects = self.renderer.objects();
        for (block, states) in self.points.chunks(LANES).enumerate() {
            for &(field, first) in &self.program.schedule.fields {
                let at = self.shape.slot(first, block);
                let width = field.value_type().width();
                let words = &mut self.memory.lanes[at..at + width];
                if let [state] = states {
                    all_of_one(objects, field, state, words);
                    continue;
                }
                match field.of_point() {
                    true => field.gather(states, words),
                    false => objects.gather(field, states, words),
                }
                if states.len() < LANES {
                    follow_the_last(words, states.len());
                }
            }
        }
    }

    /// Sets the mask of all points.
    fn choose_all(&mut self) {
        for (block, states) in self.points.chunks(LANES).enumerate() {
            let mask = self.mask(RegionId::ROOT, block);
            self.memory.todo[mask] = (0xff_u32 >> (LANES - states.len())) as u8;
        }
    }

    /// Reads the results, block by block.
    fn store(&self, results: &mut [Shaded]) {
        for (block, results) in results.chunks_mut(LANES).enumerate() {
            let at = self.shape.slot(self.program.schedule.root, block);
            let root = &self.memory.lanes[at..at + 5];
            for (lane, result) in results.iter_mut().enumerate() {
                let word = |at: usize| root[at].0[lane];
                let color = [word(0), word(1), word(2), word(3)].map(f32::from_bits);
                *result = Shaded { color, ok: word(4) != 0 };
            }
        }
    }

    fn regions(&mut self) {
        self.memory.stack.clear();
        self.memory.stack.push(Frame::Region { region: RegionId::ROOT, item: 0 });
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
                    let (first, shape) = (self.mask(region, 0), self.shape);
                    let Memory { lanes, runs, todo, .. } = &mut *self.memory;
                    runs.of(&todo[first..first + self.blocks]);
                    program.runner.segment(program.schedule, *at, shape, lanes, runs);
                    self.count_segment(*at);
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
                    self.count_chosen();
                    if !self.memory.chosen.is_empty() {
                        self.request(request);
                    }
                }
                Item::Loop(at) => {
                    let count = self.start(*at, region);
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
            let mut mask = self.memory.todo[self.mask(from, block)];
            if let Some(guard) = guard {
                mask &= bits(&self.memory.lanes[self.at(guard, block)]);
            }
            let at = self.mask(region, block);
            mask &= !self.memory.done[at];
            self.memory.done[at] |= mask;
            self.memory.todo[at] = mask;
            any |= mask != 0;
        }
        any
    }

    /// Lists the points a region is being run for.
    pub(super) fn choose(&mut self, region: RegionId) {
        let masks = &self.memory.todo[self.mask(region, 0)..][..self.blocks];
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
    pub(super) fn scoped(&self, point: usize, context: &Context) -> State {
        let mut state = self.points[point];
        for (field, sources) in context {
            let mut words = [0; Field::MOST_WORDS];
            for (word, source) in words.iter_mut().zip(sources) {
                *word = self.word(*source, point);
            }
            field.write(&mut state, &words);
        }
        state
    }
}

/// All lanes do as the only point does, each word written at once: a row written lane by lane would be waited
/// for when it is read.
fn all_of_one(objects: Objects<'_>, field: Field, state: &State, lanes: &mut [Lanes]) {
    if field.spread(state, lanes) {
        return;
    }
    let mut words = [0; Field::MOST_WORDS];
    objects.read(field, state, &mut words);
    for (lanes, word) in lanes.iter_mut().zip(words) {
        *lanes = Lanes([word; LANES]);
    }
}

/// Lanes of no point do as the last of the `points` does, so that they want nothing besides.
fn follow_the_last(words: &mut [Lanes], points: usize) {
    for Lanes(word) in words {
        let (of_points, rest) = word.split_at_mut(points);
        rest.fill(of_points.last().copied().unwrap_or_default());
    }
}

/// The lanes whose mask word is set.
fn bits(lanes: &Lanes) -> u8 {
    lanes.0.iter().enumerate().fold(0, |bits, (lane, word)| bits | ((word >> 31) as u8) << lane)
}
