//! What a rendering cost, in a line and as JSON.

use std::collections::BTreeMap;

use phenomenon_compiler::diagnostics::grouped;
use phenomenon_compiler::engine::Evaluations;
use phenomenon_runtime::render::{Region, Settings, Statistics};
use serde_json::{Map, json};

use crate::arguments::EngineChoice;

/// What a rendering cost.
#[derive(Debug)]
pub struct Cost {
    pub engine: EngineChoice,
    pub settings: Settings,
    /// The part of the picture that was rendered, if not all of it.
    pub region: Option<Region>,
    pub statistics: Statistics,
    /// Points shaded, by the engine that shaded them.
    pub points: Vec<(&'static str, u64)>,
    /// Evaluations of nodes, by engine.
    pub evaluations: BTreeMap<&'static str, Evaluations>,
    pub check_milliseconds: f64,
    pub compile_milliseconds: f64,
    pub render_milliseconds: f64,
}

impl Cost {
    /// One line.
    pub fn summary(&self) -> String {
        let Settings { width, height, samples, .. } = self.settings;
        let part = self.region.map_or(String::new(), |region| {
            let Region { x, y, width, height } = region;
            format!("{width}x{height} at {x},{y} of ")
        });
        let plural = if samples == 1 { "" } else { "s" };
        format!(
            "{part}{width}x{height}, {samples} sample{plural}, engine {}, {:.2} s ({:.2} s shading), {} rays",
            self.engine.name(),
            self.render_milliseconds / 1e3,
            self.statistics.shading_milliseconds / 1e3,
            grouped(self.statistics.rays.traced()),
        )
    }

    /// `{"rays":{…},"points":{…},"evaluations":{…},"milliseconds":{…}}`
    pub fn json(&self) -> String {
        let points: Map<_, _> =
            self.points.iter().map(|(engine, count)| ((*engine).into(), (*count).into())).collect();
        let counts = self.evaluations.iter().map(|(engine, Evaluations { wanted, done })| {
            ((*engine).into(), json!({ "wanted": wanted, "done": done }))
        });
        let evaluations: Map<_, _> = counts.collect();
        let object = json!({
            "rays": self.statistics.rays,
            "points": points,
            "evaluations": evaluations,
            "milliseconds": {
                "check": self.check_milliseconds,
                "compile": self.compile_milliseconds,
                "render": self.render_milliseconds,
                "shading": self.statistics.shading_milliseconds,
            },
            "threads": self.statistics.threads,
        });
        format!("{object:#}\n")
    }
}
