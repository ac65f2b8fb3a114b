//! How much of the time goes into shaders, and how much into what they ask for.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use super::entry::Entry;

/// One in so many camera queues is measured, unless all are.
const PERIOD: u64 = 8;

/// Who is running.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Who {
    Renderer,
    Shader,
}

/// Who is running, and what for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Running {
    who: Who,
    /// None for camera rays and the shading of what they meet.
    entry: Option<Entry>,
}

/// Splits time between the renderer and its shaders, which call each other, and among what they do it for. Reading
/// the time costs as much as tracing a short ray, so only a part of the queues is measured.
#[derive(Debug)]
pub(super) struct Clock {
    /// Whether every queue is measured.
    pub(super) every_queue: bool,
    queues: u64,
    since: Option<Instant>,
    running: Running,
    pub(super) shading: Duration,
    pub(super) whole: Duration,
    /// What went into each entry, by the innermost one.
    pub(super) entries: [Duration; Entry::COUNT],
    /// Nanoseconds since the last switch that counts elsewhere, as what was looked up does.
    pub(super) elsewhere: Arc<AtomicU64>,
}

impl Clock {
    pub(super) fn new() -> Self {
        Self {
            every_queue: false,
            queues: 0,
            since: None,
            running: Running { who: Who::Renderer, entry: None },
            shading: Duration::ZERO,
            whole: Duration::ZERO,
            entries: [Duration::ZERO; Entry::COUNT],
            elsewhere: Arc::default(),
        }
    }

    /// A camera queue begins. What the first one took is forgotten once there is another, unless every queue counts:
    /// shaders may make their code in it.
    pub(super) fn start_queue(&mut self) {
        self.running = Running { who: Who::Renderer, entry: None };
        if self.queues == 1 && !self.every_queue {
            (self.shading, self.whole) = (Duration::ZERO, Duration::ZERO);
        }
        let measured = self.every_queue || self.queues == 0 || self.queues % PERIOD == 1;
        self.since = measured.then(Instant::now);
        self.queues += 1;
    }

    /// A camera queue ends.
    pub(super) fn end_queue(&mut self) {
        self.renderer(None);
        self.since = None;
    }

    /// Passes control to the renderer; returns who had it.
    #[inline]
    pub(super) fn renderer(&mut self, entry: Option<Entry>) -> Running {
        self.switch(Running { who: Who::Renderer, entry })
    }

    /// Passes control to a shader, which shades for what is going on; returns who had it.
    #[inline]
    pub(super) fn shader(&mut self) -> Running {
        self.switch(Running { who: Who::Shader, ..self.running })
    }

    /// Passes control; returns who had it.
    #[inline]
    pub(super) fn switch(&mut self, to: Running) -> Running {
        let before = self.running;
        if let Some(since) = self.since {
            let now = Instant::now();
            let passed = now - since;
            self.whole += passed;
            if before.who == Who::Shader {
                self.shading += passed;
            }
            let elsewhere = Duration::from_nanos(self.elsewhere.swap(0, Ordering::Relaxed));
            if let Some(entry) = before.entry {
                self.entries[entry as usize] += passed.saturating_sub(elsewhere);
            }
            self.since = Some(now);
        }
        self.running = to;
        before
    }
}
