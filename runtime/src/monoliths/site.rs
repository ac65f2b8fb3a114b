//! Where hand-written shaders ask and draw: at the sites of the graph's nodes.

use phenomenon_compiler::specialise::{drawn, iteration_key, site};
use phenomenon_compiler::state::{MOST_TURNS, State};

/// How many turns a loop over samples takes that is asked for `count`.
#[inline]
pub fn turns(count: i32) -> usize {
    count.clamp(0, MOST_TURNS) as usize
}

/// The key of a request or of a loop over samples. Random numbers, those of other shaders below a ray too,
/// depend on it alone, so whoever asks at the sites of a graph draws the numbers of the graph.
#[derive(Clone, Copy, Debug)]
pub struct Site(u64);

impl Site {
    /// The site of a node, by the names of the loops it belongs to and its own, joined by `/`: of the node
    /// `mirror`, evaluated for each sample of the loop `around`, it is `around/mirror`. The nodes of an inner
    /// phenomenon have its node's name before theirs.
    pub const fn of(path: &str) -> Self {
        Self(site(path))
    }

    /// The site in one turn of the loop round it.
    #[inline]
    pub fn turn(self, number: usize) -> Self {
        Self(iteration_key(self.0, number))
    }

    /// The two numbers, from 0 to below 1, that a loop over samples at this site draws for one of them.
    #[inline]
    pub fn numbers(self, point: &State, sample: usize) -> [f32; 2] {
        drawn(point.path, self.turn(sample).0)
    }

    /// The key as it goes to the renderer.
    pub fn key(self) -> u64 {
        self.0
    }
}
