//! One engine at one subject, and the clock.

use std::time::Duration;

use cpu_time::ThreadTime;

use super::column::{Column, Shading};
use super::points::Points;
use crate::commands::bench::statistics::{median, spread};

/// How long a turn takes: long beside the clock's steps, short beside the minutes of a machine.
const TURN: Duration = Duration::from_millis(10);

/// One of those that are compared.
pub struct Contender {
    /// Who it is.
    pub column: Column,
    /// Time spent compiling its graph by itself, machine code included, in milliseconds; none where that was not
    /// measured.
    pub compile_milliseconds: Option<f64>,
    shading: Shading,
    /// Passes over all points in a turn.
    passes: u32,
    /// Nanoseconds a point, turn by turn.
    turns: Vec<f64>,
}

impl Contender {
    /// Runs it until it is warm, which says how many passes a turn has.
    pub fn new(column: Column, shading: Shading, points: &mut Points) -> Self {
        // Codes of all ray types are made, and memory is taken.
        points.shade(shading.shader());
        let start = ThreadTime::now();
        let mut passes = 0;
        // Where the clock does not move, a turn is some 10,000 passes and not endless.
        while start.elapsed() < TURN && passes < MOST_PASSES {
            points.shade(shading.shader());
            passes += 1;
        }
        Self { column, compile_milliseconds: None, shading, passes, turns: Vec::new() }
    }

    /// Measures it once.
    pub fn take_turn(&mut self, points: &mut Points) {
        let start = ThreadTime::now();
        for _ in 0..self.passes {
            points.shade(self.shading.shader());
        }
        let shaded = f64::from(self.passes) * points.count() as f64;
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
