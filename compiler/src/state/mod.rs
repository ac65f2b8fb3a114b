//! The state of a shading point: what mental ray's `miState` holds, and what loops add to it.

mod field;
mod field_set;
mod held;
mod iterated;
mod loops;
mod ray_type;
mod reduction;
mod shading_point;

pub use field::Field;
pub use field_set::FieldSet;
pub use iterated::{Iterated, MOST_TURNS};
pub use ray_type::RayType;
pub use reduction::Reduction;
pub use shading_point::{Hit, State};
