//! The state of a shading point: what mental ray's `miState` holds, what loops add to it, and
//! what is known of the object, the surface and the camera.

mod camera;
mod field;
mod field_set;
mod footprint;
mod held;
mod iterated;
mod known;
mod loops;
mod object;
mod objects;
mod place;
mod ray_type;
mod reduction;
mod shading_point;
mod surface;

pub use camera::Camera;
pub use field::{Field, Holder};
pub use field_set::FieldSet;
pub use footprint::{Cone, Footprint};
pub use iterated::{Iterated, MOST_TURNS};
pub use known::Known;
pub use object::{IDENTITY, Object};
pub use objects::Objects;
pub use place::Place;
pub use ray_type::RayType;
pub use reduction::Reduction;
pub use shading_point::{Hit, State};
pub use surface::{Surface, Surfaces};
