//! One engine at one workload, and the clock.

use std::time::Duration;

use cpu_time::ThreadTime;
use phenomenon_compiler::effects::NoScene;
use phenomenon_compiler::engine::{Shade, Shaded};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::State;

use super::column::Column;
use super::statistics::{median, spread};
use super::workloads::Workload;

/// How long a turn takes: long beside the clock's steps, short beside the minutes of a machine.
const TURN: Duration = Duration::from_millis(10);

/// What is shaded, and where the results go.
pub struct Points {
    states: Vec<State>,
    results: Vec<Shaded>,
}

impl Points {
    /// The points of a workload.
    pub fn new(workload: Workload) -> Self {
        let states = workload.states();
        Self { results: vec![Shaded::default(); states.len()], states }
    }

    /// Shades all of them once, linked once as a renderer does it.
    fn shade(&mut self, shader: &dyn Shade, batch: usize) {
        let links = shader.link(&mut NoScene);
        for (points, results) in self.states.chunks(batch).zip(self.results.chunks_mut(batch)) {
            shader.shade_linked(RootKind::Material, points, &links, &mut NoScene, results);
        }
    }
}

/// One of those that are compared.
pub struct Contender {
    /// Who it is.
    pub column: Column,
    shader: Box<dyn Shade>,
    /// Passes over all points in a turn.
    passes: u32,
    /// Nanoseconds a point, turn by turn.
    turns: Vec<f64>,
}

impl Contender {
    /// Runs it until it is warm, which says how many passes a turn has.
    pub fn new(column: Column, shader: Box<dyn Shade>, batch: usize, points: &mut Points) -> Self {
        // Codes of all ray types are made, and memory is taken.
        points.shade(shader.as_ref(), batch);
        let start = ThreadTime::now();
        let mut passes = 0;
        // Where the clock does not move, a turn is some 10,000 passes and not endless.
        while start.elapsed() < TURN && passes < MOST_PASSES {
            points.shade(shader.as_ref(), batch);
            passes += 1;
        }
        Self { column, shader, passes, turns: Vec::new() }
    }

    /// Measures it once.
    pub fn take_turn(&mut self, batch: usize, points: &mut Points) {
        let start = ThreadTime::now();
        for _ in 0..self.passes {
            points.shade(self.shader.as_ref(), batch);
        }
        let shaded = f64::from(self.passes) * points.states.len() as f64;
        self.turns.push(start.elapsed().as_secs_f64() * 1e9 / shaded);
    }

    /// Nanoseconds a point: the median of all turns.
    pub fn nanoseconds(&self) -> f64 {
        median(self.turns.iter().copied())
    }

    /// How far the turns lie apart, as a share of the median.
    pub fn spread(&self) -> f64 {
        spread(self.turns.iter().copied())
    }

    /// The median of the ratios to what another took in the same turn.
    pub fn ratio(&self, to: &Self) -> f64 {
        median(self.turns.iter().zip(&to.turns).map(|(own, other)| own / other))
    }
}

/// Most passes of a turn.
const MOST_PASSES: u32 = 10_000;
