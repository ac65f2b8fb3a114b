//! Tiles on threads.

use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use phenomenon_compiler::effects::{Answer, Ray};
use phenomenon_compiler::state::{Cone, Hit, State};
use rayon::prelude::*;

use super::context::Context;
use super::costs::Costs;
use super::statistics::{RayCounts, Statistics};
use crate::film::{Film, SizeError};
use crate::sampling::{path_key, pixel_position};
use crate::scene::Scene;

/// Camera rays traced at once: several batches, so that each material gets a long queue.
const CAMERA_QUEUE: usize = 512;

/// Stack of a rendering thread in bytes; shaders and requests nest on it.
const STACK_BYTES: usize = 64 << 20;

/// Most samples of a pixel.
pub const SAMPLE_LIMIT: u32 = 1 << 20;

/// A part of a picture, in pixels of the whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Region {
    /// Its first column.
    pub x: u32,
    /// Its first row, from the top.
    pub y: u32,
    /// Its columns.
    pub width: u32,
    /// Its rows.
    pub height: u32,
}

/// How a scene is rendered. Only the size, the samples and the seed change the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Samples of every pixel.
    pub samples: u32,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Threads; 0 takes as many as the machine has.
    pub threads: usize,
    /// Most points shaded at once.
    pub batch: usize,
    /// Side of a tile in pixels.
    pub tile: u32,
    /// Whether the time of every queue is taken, and of all that is looked up: for [`Rendered::costs`].
    pub every_queue_timed: bool,
    /// Most rays that a thread traces; a picture that takes more is given up.
    pub ray_limit: Option<u64>,
}

impl Region {
    /// All of a picture.
    fn whole(settings: &Settings) -> Self {
        Self { x: 0, y: 0, width: settings.width, height: settings.height }
    }

    /// Fails unless it has pixels, all of them in the picture.
    fn require_within(self, settings: &Settings) -> Result<(), RenderError> {
        let Region { x, y, width, height } = self;
        let (of_width, of_height) = (settings.width, settings.height);
        let inside = |at: u32, side: u32, of: u32| {
            side > 0 && at.checked_add(side).is_some_and(|end| end <= of)
        };
        if inside(x, width, of_width) && inside(y, height, of_height) {
            return Ok(());
        }
        Err(RenderError::Region { x, y, width, height, of_width, of_height })
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            width: 512,
            height: 512,
            samples: 16,
            seed: 0,
            threads: 0,
            batch: 256,
            tile: 16,
            every_queue_timed: false,
            ray_limit: None,
        }
    }
}

/// Why nothing could be rendered.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// The picture cannot have this size.
    #[error(transparent)]
    Size(#[from] SizeError),
    /// The region has no pixels, or some outside of the picture.
    #[error(
        "no region of {width} x {height} pixels at {x},{y} lies in a picture of {of_width} x {of_height}"
    )]
    Region {
        /// Its first column.
        x: u32,
        /// Its first row.
        y: u32,
        /// Its columns.
        width: u32,
        /// Its rows.
        height: u32,
        /// Columns of the picture.
        of_width: u32,
        /// Rows of the picture.
        of_height: u32,
    },
    /// The number of samples is out of range.
    #[error("{0} samples per pixel are not possible: 1 to {SAMPLE_LIMIT} are")]
    Samples(u32),
    /// The picture takes more rays than it may.
    #[error("the picture takes more than {0} rays")]
    Rays(u64),
    /// The threads could not be started.
    #[error("cannot start {threads} rendering threads of {} MiB of stack: {cause}", STACK_BYTES >> 20)]
    Threads {
        /// How many.
        threads: usize,
        /// What the system says.
        cause: rayon::ThreadPoolBuildError,
    },
}

/// A picture and what it cost.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// The picture.
    pub film: Film,
    /// What it cost.
    pub statistics: Statistics,
    /// What of it each effect cost.
    pub costs: Costs,
}

/// Renders a scene. `progress` is called with the tiles done and their number, from any thread.
pub fn render(
    scene: &Scene,
    settings: &Settings,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Rendered, RenderError> {
    // A picture without pixels has no region, and a message of its own.
    Film::new(settings.width, settings.height)?;
    render_region(scene, settings, Region::whole(settings), progress)
}

/// Renders a part of the picture that [`render`] renders: the film has its size, and the pixels are
/// those of the whole, to the bit.
///
/// # Errors
/// As for [`render`], and where the part is not within the picture.
pub fn render_region(
    scene: &Scene,
    settings: &Settings,
    part: Region,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Rendered, RenderError> {
    part.require_within(settings)?;
    let film = Film::new(part.width, part.height)?;
    if !(1..=SAMPLE_LIMIT).contains(&settings.samples) {
        return Err(RenderError::Samples(settings.samples));
    }
    let pool = threads(settings.threads)?;
    let start = Instant::now();
    let tiles = tiles(settings.tile, part);
    let work = Work { film: Mutex::new((film, 0)), contexts: Mutex::new(Vec::new()) };
    pool.install(|| {
        tiles.par_iter().with_max_len(1).for_each(|tile| {
            let mut painter =
                locked(&work.contexts).pop().unwrap_or_else(|| Painter::for_scene(scene, settings));
            painter.paint(settings, tile);
            let mut film = locked(&work.film);
            painter.copy_to(&mut film.0, part, tile);
            film.1 += 1;
            let done = film.1;
            drop(film);
            locked(&work.contexts).push(painter);
            progress(done, tiles.len());
        });
    });
    let whole = start.elapsed();
    let (film, _) = work.film.into_inner().unwrap_or_else(PoisonError::into_inner);
    let painters = work.contexts.into_inner().unwrap_or_else(PoisonError::into_inner);
    let statistics = statistics(&painters, whole, pool.current_num_threads());
    if let Some(limit) = settings.ray_limit
        && painters.iter().any(|painter| painter.context.is_over_limit())
    {
        return Err(RenderError::Rays(limit));
    }
    let mut costs = Costs::default();
    painters.iter().for_each(|painter| costs += &painter.context.costs());
    Ok(Rendered { film, statistics, costs })
}

/// So many threads; 0 stands for one per core.
fn threads(wanted: usize) -> Result<rayon::ThreadPool, RenderError> {
    let threads = match wanted {
        0 => std::thread::available_parallelism().map_or(1, std::num::NonZero::get),
        wanted => wanted,
    };
    let builder = rayon::ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK_BYTES);
    builder.build().map_err(|cause| RenderError::Threads { threads, cause })
}

struct Work<'s> {
    /// The picture and the number of tiles in it.
    film: Mutex<(Film, usize)>,
    contexts: Mutex<Vec<Painter<'s>>>,
}

fn locked<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn statistics(painters: &[Painter<'_>], whole: Duration, threads: usize) -> Statistics {
    let mut rays = RayCounts::default();
    let (mut points, mut shading, mut measured) = (0, Duration::ZERO, Duration::ZERO);
    for Painter { context, .. } in painters {
        rays += context.counts;
        points += context.points;
        shading += context.clock.shading;
        measured += context.clock.whole;
    }
    let whole_milliseconds = whole.as_secs_f64() * 1e3;
    let part = shading.as_secs_f64() / measured.as_secs_f64().max(1e-9);
    let shading_milliseconds = whole_milliseconds * part;
    Statistics { rays, points, whole_milliseconds, shading_milliseconds, threads }
}

/// Columns and rows of the whole picture, ends excluded.
struct Tile {
    columns: (u32, u32),
    rows: (u32, u32),
}

fn tiles(side: u32, part: Region) -> Vec<Tile> {
    let side = side.max(1);
    let spans = |first: u32, length: u32| {
        let end = first + length;
        (first..end).step_by(side as usize).map(move |at| (at, at.saturating_add(side).min(end)))
    };
    spans(part.y, part.height)
        .flat_map(|rows| spans(part.x, part.width).map(move |columns| Tile { columns, rows }))
        .collect()
}

/// Paints tiles, one after the other, and keeps what it needs for that.
struct Painter<'s> {
    context: Context<'s>,
    /// Sums of the samples. A sum of 2^20 numbers of 24 bits needs 44: in 64 bits none is lost.
    pixels: Vec<[f64; 4]>,
    /// Of each ray, what its whole path shares.
    states: Vec<State>,
    rays: Vec<Ray>,
    answers: Vec<Answer>,
    /// Pixel of the tile that each ray belongs to.
    owners: Vec<usize>,
}

impl<'s> Painter<'s> {
    fn for_scene(scene: &'s Scene, settings: &Settings) -> Self {
        let mut context = Context::new(scene, settings.batch);
        context.ray_limit = settings.ray_limit.unwrap_or(u64::MAX);
        if settings.every_queue_timed {
            context.time_all();
        }
        let (states, rays, answers) = (Vec::new(), Vec::new(), Vec::new());
        Self { context, pixels: Vec::new(), states, rays, answers, owners: Vec::new() }
    }

    fn paint(&mut self, settings: &Settings, tile: &Tile) {
        self.pixels.clear();
        for row in tile.rows.0..tile.rows.1 {
            for column in tile.columns.0..tile.columns.1 {
                self.pixels.push([0.0; 4]);
                for sample in 0..settings.samples {
                    self.owners.push(self.pixels.len() - 1);
                    let state = camera_state(self.context.scene, settings, column, row, sample);
                    let State { origin, direction, .. } = state;
                    let point = self.states.len() as u32;
                    self.states.push(state);
                    self.rays.push(Ray { point, origin, direction, site: 0 });
                    if self.rays.len() == CAMERA_QUEUE {
                        self.flush();
                    }
                }
            }
        }
        self.flush();
        for pixel in &mut self.pixels {
            *pixel = pixel.map(|sum| sum / f64::from(settings.samples));
        }
    }

    /// Traces the queue and adds its answers to their pixels, in the order of the samples.
    fn flush(&mut self) {
        self.answers.clear();
        self.answers.resize(self.rays.len(), Answer::default());
        self.context.clock.start_queue();
        self.context.trace_camera_rays(&self.states, &self.rays, &mut self.answers);
        self.context.clock.end_queue();
        for (owner, answer) in self.owners.iter().zip(&self.answers) {
            if answer.ok {
                let pixel = &mut self.pixels[*owner];
                for (sum, color) in pixel.iter_mut().zip(answer.color) {
                    *sum += f64::from(color);
                }
            }
        }
        self.states.clear();
        self.rays.clear();
        self.owners.clear();
    }

    /// Rounds the means to 32 bits, once.
    fn copy_to(&self, film: &mut Film, part: Region, tile: &Tile) {
        let mut pixels = self.pixels.iter();
        for row in tile.rows.0..tile.rows.1 {
            for (column, pixel) in (tile.columns.0..tile.columns.1).zip(&mut pixels) {
                film.set(column - part.x, row - part.y, pixel.map(|mean| mean as f32));
            }
        }
    }
}

/// What the path of a sample starts with.
fn camera_state(scene: &Scene, settings: &Settings, column: u32, row: u32, sample: u32) -> State {
    let [x, y] = pixel_position(settings.seed, column, row, sample, settings.samples);
    let raster = [column as f32 + x, row as f32 + y];
    let (origin, direction) = scene.camera.ray(raster, settings.width, settings.height);
    let spread = match scene.called_for.footprints {
        true => scene.camera.spread(direction, settings.height) * sharpness(settings.samples),
        false => 0.0,
    };
    State {
        origin,
        direction,
        point: origin,
        dist: 0.0,
        raster,
        path: path_key(settings.seed, column, row, sample),
        hit: Hit { cone: Cone { width: 0.0, spread }, ..Hit::default() },
        ..State::default()
    }
}

/// What a sample sees of a pixel's width: together the samples see all of it, so each may be sharper. At least an
/// eighth, for the places of samples are not that even.
fn sharpness(samples: u32) -> f32 {
    (1.0 / f64::from(samples).sqrt()).max(0.125) as f32
}
