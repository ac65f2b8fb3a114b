//! Lights and environments.

mod arrival;
mod brightness;
mod directions;
mod disc;
mod environment;
mod light;
mod rectangle;
mod sphere;
mod spot;

pub use arrival::LightSource;
pub(crate) use brightness::{looks, seen};
pub use directions::DirectionTable;
pub use disc::Disc;
pub use environment::{Environment, EnvironmentImage};
pub(crate) use light::tinted;
pub use light::{LIGHT_LIMIT, Light, LightKind, LightSight};
pub use rectangle::Rectangle;
pub use sphere::Sphere;
pub use spot::Spot;
