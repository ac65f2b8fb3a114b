//! Lights and environments.

mod arrival;
mod disc;
mod environment;
mod light;
mod rectangle;
mod sphere;
mod spot;

pub use arrival::LightSource;
pub use disc::Disc;
pub use environment::{Environment, EnvironmentImage};
pub use light::{LIGHT_LIMIT, Light, LightKind, LightSight};
pub use rectangle::Rectangle;
pub use sphere::Sphere;
pub use spot::Spot;
