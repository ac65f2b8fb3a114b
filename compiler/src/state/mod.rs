//! The state of a shading point: what mental ray's `miState` holds, what loops add to it, and
//! what is known of the object.

mod field;
mod field_set;
mod held;
mod iterated;
mod loops;
mod object;
mod objects;
mod ray_type;
mod reduction;
mod shading_point;

pub use field::Field;
pub use field_set::FieldSet;
pub use iterated::{Iterated, MOST_TURNS};
pub use object::Object;
pub use objects::Objects;
pub use ray_type::RayType;
pub use reduction::Reduction;
pub use shading_point::{Hit, State};
