//! Runs a schedule over a batch of points: the one executor batch and jit share. They differ in how
//! a segment is run.

use crate::effects::{Answer, Effect, LightList, LightSample, Ray, Renderer, TextureId};
use crate::schedule::{Item, Loop, RegionId, Request, Schedule};
use crate::specialise::Context;
use crate::state::State;

use super::requests::{answer_words, iteration_key, ray, texture_words};
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
    /// Per table and iteration, colours kept.
    tables: Vec<Vec<Table>>,
    /// Per loop, its iteration.
    iterations: Vec<usize>,
    stack: Vec<Frame>,
    chosen: Vec<usize>,
    states: Vec<State>,
    rays: Vec<Ray>,
    answers: Vec<Answer>,
    samples: Vec<LightSample>,
    colors: Vec<[f32; 3]>,
}

/// Colours of one light sample, per block.
#[derive(Clone, Debug, Default)]
struct Table {
    known: Vec<u8>,
    colors: Vec<[Lanes; 3]>,
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
        self.tables.resize_with(schedule.tables.len().max(self.tables.len()), Vec::new);
        self.tables.iter_mut().for_each(|table| empty(table));
    }
}

/// Forgets the colours of a table.
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

    fn request(&mut self, request: &Request) {
        match request.effect {
            Effect::LightColor => return self.light_color(request),
            Effect::ReadTexture => return self.read_texture(request),
            _ => {}
        }
        let site = request.loops.iter().fold(request.site, |key, &at| {
            iteration_key(key, self.memory.iterations[at].wrapping_sub(1))
        });
        let mut rays = std::mem::take(&mut self.memory.rays);
        let chosen = std::mem::take(&mut self.memory.chosen);
        rays.clear();
        rays.extend(chosen.iter().map(|&point| {
            let mut words = [0; 6];
            for (word, source) in words.iter_mut().zip(&request.words) {
                *word = self.word(*source, point);
            }
            ray(request.effect, self.scoped(point, &request.context), words, site)
        }));
        let mut answers = std::mem::take(&mut self.memory.answers);
        answers.clear();
        answers.resize(rays.len(), Answer::default());
        self.renderer.trace(request.effect, &rays, &mut answers);
        for (&point, answer) in chosen.iter().zip(&answers) {
            for (slot, word) in (request.output..).zip(answer_words(answer)) {
                self.set(slot, point, word);
            }
        }
        self.memory.rays = rays;
        self.memory.chosen = chosen;
        self.memory.answers = answers;
    }

    fn read_texture(&mut self, request: &Request) {
        let Some(texture) = request.texture.map(|at| self.textures[at]) else { return };
        let chosen = std::mem::take(&mut self.memory.chosen);
        let coordinate = |at: usize, point| f32::from_bits(self.word(request.words[at], point));
        let coordinates: Vec<[f32; 2]> =
            chosen.iter().map(|&point| [coordinate(0, point), coordinate(1, point)]).collect();
        let mut colors = vec![None; coordinates.len()];
        self.renderer.read_texture(texture, &coordinates, &mut colors);
        for (&point, color) in chosen.iter().zip(&colors) {
            for (slot, word) in (request.output..).zip(texture_words(*color)) {
                self.set(slot, point, word);
            }
        }
        self.memory.chosen = chosen;
    }

    /// Asks for the colours of a light sample that are not known yet, and hands out all.
    fn light_color(&mut self, request: &Request) {
        let (Some(table), Some(&at)) = (request.table, request.loops.last()) else {
            // The checker refuses it outside a loop; without one it is black, as in the walk.
            for at in 0..self.memory.chosen.len() {
                let point = self.memory.chosen[at];
                for (slot, x) in (request.output..).zip([0.0_f32, 0.0, 0.0, 1.0]) {
                    self.set(slot, point, x.to_bits());
                }
            }
            return;
        };
        let iteration = self.memory.iterations[at].wrapping_sub(1);
        let list = self.lists[self.program.schedule.tables[table].list];
        let kept = &mut self.memory.tables[table];
        if kept.len() <= iteration {
            kept.resize(iteration + 1, Table::default());
        }
        let kept = &mut kept[iteration];
        kept.known.resize(self.blocks.max(kept.known.len()), 0);
        kept.colors.resize(self.blocks.max(kept.colors.len()), [Lanes::default(); 3]);
        let chosen = std::mem::take(&mut self.memory.chosen);
        let is_known = |point: usize| kept.known[point / LANES] >> (point % LANES) & 1 == 1;
        let asked: Vec<usize> = chosen.iter().copied().filter(|&point| !is_known(point)).collect();
        let mut states = std::mem::take(&mut self.memory.states);
        states.clear();
        states.extend(asked.iter().map(|&point| self.scoped(point, &request.context)));
        let mut colors = std::mem::take(&mut self.memory.colors);
        colors.clear();
        colors.resize(states.len(), [0.0; 3]);
        if !states.is_empty() {
            self.renderer.light_colors(list, iteration, &states, &mut colors);
        }
        let kept = &mut self.memory.tables[table][iteration];
        for (&point, color) in asked.iter().zip(&colors) {
            let (block, lane) = (point / LANES, point % LANES);
            kept.known[block] |= 1 << lane;
            for (lanes, x) in kept.colors[block].iter_mut().zip(color) {
                lanes.0[lane] = x.to_bits();
            }
        }
        for &point in &chosen {
            let color = self.memory.tables[table][iteration].colors[point / LANES];
            for (slot, lanes) in (request.output..).zip(color) {
                self.set(slot, point, lanes.0[point % LANES]);
            }
            self.set(request.output + 3, point, 1.0_f32.to_bits());
        }
        self.memory.chosen = chosen;
        self.memory.states = states;
        self.memory.colors = colors;
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
            if self.sample(of, within, iteration) {
                self.renew(of);
                self.memory.stack.push(Frame::Loop { at, within, count });
                self.memory.stack.push(Frame::Region { region: of.region, item: 0 });
                return;
            }
        }
    }

    /// Writes the light sample of an iteration, and the mask of the points it can reach; false if
    /// it reaches none.
    fn sample(&mut self, of: &Loop, within: RegionId, iteration: usize) -> bool {
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
        let mut any = false;
        for (&point, sample) in chosen.iter().zip(&samples) {
            if !sample.reachable {
                continue;
            }
            any = true;
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
