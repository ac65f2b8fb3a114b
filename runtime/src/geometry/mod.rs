//! Shapes, how rays meet them, and what is known about the points they meet.

mod mesh;
mod obj;
mod primitive;
mod shape;
mod spawn;
mod sphere;
mod transform;
mod triangle;

pub use mesh::{Mesh, MeshError};
pub use obj::{Normals, OBJ_BYTES_LIMIT, ObjError, read_obj};
pub use primitive::{PreparedRay, Primitive, RawHit, double, single};
pub use shape::{Instance, Shape, Surface};
pub use spawn::spawn_origin;
pub use sphere::Sphere;
pub use transform::Transform;

/// Largest magnitude of a world coordinate. Squares and products of coordinates up to here stay
/// finite wherever the renderer forms them.
pub const COORDINATE_LIMIT: f32 = 1e12;

/// Half an ulp of 1 in f32: the relative error of rounding a result of f64 arithmetic.
const HALF_ULP: f64 = 1.0 / (1u64 << 24) as f64;

/// Relative error, with room, of a few f64 operations on coordinates.
const DOUBLE_ERROR: f64 = 1.0 / (1u64 << 49) as f64;

/// Bound on the error of a coordinate computed in f64 from terms up to `magnitude` and rounded to
/// `rounded`.
#[inline(always)]
fn coordinate_error(rounded: f64, magnitude: f64) -> f32 {
    let bound = rounded.abs() * HALF_ULP + magnitude * DOUBLE_ERROR;
    // The bound itself is rounded up, and never 0: at 0 one subnormal step is the error.
    (bound as f32).next_up()
}
