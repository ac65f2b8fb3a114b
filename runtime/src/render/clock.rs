//! How much of the time goes into shaders.

use std::time::{Duration, Instant};

/// One in so many camera queues is measured.
const PERIOD: u64 = 8;

/// Who is running.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Who {
    Renderer,
    Shader,
}

/// Splits time between the renderer and its shaders, which call each other. Reading the time costs
/// as much as tracing a short ray, so only a part of the queues is measured.
#[derive(Debug)]
pub(super) struct Clock {
    queues: u64,
    running: Option<Instant>,
    who: Who,
    pub(super) shading: Duration,
    pub(super) whole: Duration,
}

impl Clock {
    pub(super) fn new() -> Self {
        let zero = Duration::ZERO;
        Self { queues: 0, running: None, who: Who::Renderer, shading: zero, whole: zero }
    }

    /// A camera queue begins. What the first one took is forgotten once there is another: shaders may make
    /// their code in it.
    pub(super) fn start_queue(&mut self) {
        self.who = Who::Renderer;
        if self.queues == 1 {
            (self.shading, self.whole) = (Duration::ZERO, Duration::ZERO);
        }
        let measured = self.queues == 0 || self.queues % PERIOD == 1;
        self.running = measured.then(Instant::now);
        self.queues += 1;
    }

    /// A camera queue ends.
    pub(super) fn end_queue(&mut self) {
        self.switch(Who::Renderer);
        self.running = None;
    }

    /// Passes control; returns who had it.
    #[inline]
    pub(super) fn switch(&mut self, who: Who) -> Who {
        let before = self.who;
        if let Some(since) = self.running {
            let now = Instant::now();
            let passed = now - since;
            self.whole += passed;
            if before == Who::Shader {
                self.shading += passed;
            }
            self.running = Some(now);
        }
        self.who = who;
        before
    }
}
