//! What shaders look up of surfaces, counted.

use std::cell::Cell;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use phenomenon_compiler::state::{Footprint, State, Surfaces};

use super::costs::Costs;
use super::entry::Entry;
use crate::scene::Scene;

/// The surfaces of a scene, for one thread.
pub(super) struct CountedSurfaces<'s> {
    scene: &'s Scene,
    /// Where the time that is taken is told to the clock, in nanoseconds; none where none is taken.
    told: Option<Arc<AtomicU64>>,
    derivatives: Tally,
    colors: Tally,
    second: Tally,
    footprints: Tally,
}

#[derive(Default)]
struct Tally {
    count: Cell<u64>,
    passed: Cell<Duration>,
}

impl Tally {
    #[inline]
    fn of<T>(&self, told: &Option<Arc<AtomicU64>>, looked_up: impl FnOnce() -> T) -> T {
        self.count.set(self.count.get() + 1);
        let Some(told) = told else { return looked_up() };
        let start = Instant::now();
        let found = looked_up();
        let passed = start.elapsed();
        self.passed.set(self.passed.get() + passed);
        told.fetch_add(passed.as_nanos() as u64, Ordering::Relaxed);
        found
    }
}

impl<'s> CountedSurfaces<'s> {
    pub(super) fn of(scene: &'s Scene) -> Self {
        let tally = Tally::default;
        let (derivatives, colors, second, footprints) = (tally(), tally(), tally(), tally());
        Self { scene, told: None, derivatives, colors, second, footprints }
    }

    /// Takes the time of what is looked up, and tells it to a clock, so that it counts once.
    pub(super) fn time_to(&mut self, told: &Arc<AtomicU64>) {
        self.told = Some(Arc::clone(told));
    }

    /// Adds what was looked up so far.
    pub(super) fn add_to(&self, costs: &mut Costs) {
        for (entry, tally) in [
            (Entry::Derivatives, &self.derivatives),
            (Entry::VertexColors, &self.colors),
            (Entry::SecondCoordinates, &self.second),
            (Entry::Footprints, &self.footprints),
        ] {
            let cost = costs.of_mut(entry);
            cost.count += tally.count.get();
            cost.milliseconds += tally.passed.get().as_secs_f64() * 1e3;
        }
    }
}

impl Surfaces for CountedSurfaces<'_> {
    fn derivative_u(&self, state: &State) -> [f32; 3] {
        self.derivatives.of(&self.told, || self.scene.derivative_u(state))
    }

    fn derivative_v(&self, state: &State) -> [f32; 3] {
        self.derivatives.of(&self.told, || self.scene.derivative_v(state))
    }

    fn vertex_color(&self, state: &State) -> [f32; 4] {
        self.colors.of(&self.told, || self.scene.vertex_color(state))
    }

    fn second_uv(&self, state: &State) -> [f32; 2] {
        self.second.of(&self.told, || self.scene.second_uv(state))
    }

    fn footprint(&self, state: &State) -> Footprint {
        self.footprints.of(&self.told, || self.scene.footprint(state))
    }
}
