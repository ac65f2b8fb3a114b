//! What laziness saves: requests and evaluations of nodes, beside those of a graph that leaves nothing out.

use std::sync::Arc;

use phenomenon_compiler::engine::{Engine, Options, Shader};
use phenomenon_compiler::specialise::Asking;

use super::materials::Stage;
use crate::failure::Failure;

/// What a point of a material costs on average.
#[derive(Clone, Copy, Debug)]
pub struct Demand {
    /// Rays it casts, probes and looks at the environment among them.
    pub rays: f64,
    /// Colours of light samples, each with a shadow ray.
    pub lights: f64,
    /// Evaluations of nodes.
    pub evaluations: f64,
}

/// What a material demands lazily, and if nothing is left out.
#[derive(Clone, Copy, Debug)]
pub struct Saved {
    /// What matters to the result.
    pub lazy: Demand,
    /// All there is.
    pub eager: Demand,
}

impl Saved {
    /// Counts at the points of a stage.
    ///
    /// # Errors
    /// The graph cannot be compiled.
    pub fn of(stage: &mut Stage) -> Result<Self, Failure> {
        Ok(Self { lazy: demand(stage, Asking::Guarded)?, eager: demand(stage, Asking::All)? })
    }
}

fn demand(stage: &mut Stage, asking: Asking) -> Result<Demand, Failure> {
    let options = Options { engine: Engine::Walk, count: true, asking, ..Options::default() };
    let shader = Shader::new(Arc::clone(&stage.graph), &[], options);
    let shader = shader.map_err(|error| Failure::new(error, ""))?;
    let asked = stage.record(&shader);
    let evaluations: u64 = shader.evaluations().iter().map(|(_, count)| count.wanted).sum();
    let points = stage.states().len() as f64;
    Ok(Demand {
        rays: asked.rays as f64 / points,
        lights: asked.lights as f64 / points,
        evaluations: evaluations as f64 / points,
    })
}
