//! What a rendering cost.

use std::ops::AddAssign;

use serde::Serialize;

/// Rays by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct RayCounts {
    /// From the camera.
    pub eye: u64,
    /// Traced by `trace_reflection`.
    pub reflection: u64,
    /// Traced by `trace_refraction`.
    pub refraction: u64,
    /// Traced by `trace_transparent`.
    pub transparent: u64,
    /// Intersected by `trace_probe`.
    pub probe: u64,
    /// From a point towards a light.
    pub shadow: u64,
    /// Looked up in the environment: asked for, missed, or past the trace depth.
    pub environment: u64,
}

impl RayCounts {
    /// All rays that were intersected with the scene.
    pub fn traced(&self) -> u64 {
        let Self { eye, reflection, refraction, transparent, probe, shadow, environment: _ } = self;
        eye + reflection + refraction + transparent + probe + shadow
    }
}

impl AddAssign for RayCounts {
    fn add_assign(&mut self, other: Self) {
        self.eye += other.eye;
        self.reflection += other.reflection;
        self.refraction += other.refraction;
        self.transparent += other.transparent;
        self.probe += other.probe;
        self.shadow += other.shadow;
        self.environment += other.environment;
    }
}

/// What a rendering cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Statistics {
    /// Rays by kind.
    pub rays: RayCounts,
    /// Points shaded: materials, shadows and environment shaders, with the directions in which an environment light looked at
    /// its graph, if it was this rendering that asked for the light of the scene first.
    pub points: u64,
    /// Wall time of the rendering, in milliseconds.
    pub whole_milliseconds: f64,
    /// The part of it spent inside shaders, without what they asked of the renderer; measured on
    /// a part of the batches.
    pub shading_milliseconds: f64,
    /// Threads it ran on.
    pub threads: usize,
}
