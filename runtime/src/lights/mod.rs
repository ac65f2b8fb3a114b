//! Lights and environments.

mod environment;
mod light;

pub use environment::{Environment, EnvironmentImage};
pub use light::{LIGHT_LIMIT, Light, LightKind, LightSight};
