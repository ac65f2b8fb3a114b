//! What shaders look up of surfaces, counted.

use std::cell::Cell;
use std::time::{Duration, Instant};

use phenomenon_compiler::state::{Footprint, State, Surfaces};

use super::costs::Costs;
use super::entry::Entry;
use crate::scene::Scene;

/// The surfaces of a scene, for one thread.
pub(super) struct CountedSurfaces<'s> {
    scene: &'s Scene,
    /// Whether the time is taken as well.
    pub(super) timed: bool,
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
    fn of<T>(&self, timed: bool, looked_up: impl FnOnce() -> T) -> T {
        self.count.set(self.count.get() + 1);
        if !timed {
            return looked_up();
        }
        let start = Instant::now();
        let found = looked_up();
        self.passed.set(self.passed.get() + start.elapsed());
        found
    }
}

impl<'s> CountedSurfaces<'s> {
    pub(super) fn of(scene: &'s Scene) -> Self {
        let tally = Tally::default;
        let (derivatives, colors, second, footprints) = (tally(), tally(), tally(), tally());
        Self { scene, timed: false, derivatives, colors, second, footprints }
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
        self.derivatives.of(self.timed, || self.scene.derivative_u(state))
    }

    fn derivative_v(&self, state: &State) -> [f32; 3] {
        self.derivatives.of(self.timed, || self.scene.derivative_v(state))
    }

    fn vertex_color(&self, state: &State) -> [f32; 4] {
        self.colors.of(self.timed, || self.scene.vertex_color(state))
    }

    fn second_uv(&self, state: &State) -> [f32; 2] {
        self.second.of(self.timed, || self.scene.second_uv(state))
    }

    fn footprint(&self, state: &State) -> Footprint {
        self.footprints.of(self.timed, || self.scene.footprint(state))
    }
}
