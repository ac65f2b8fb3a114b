//! Lights and environments.

mod environment;
mod light;

pub use environment::{Environment, EnvironmentImage};
pub use light::{Light, LightKind, LightSight};
