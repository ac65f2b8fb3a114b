//! Shapes, how rays meet them, and what is known about the points they meet.

mod mesh;
mod obj;
mod polygon;
mod primitive;
mod shape;
mod sphere;
mod terminator;
mod transform;
mod triangle;

pub use mesh::{Mesh, MeshError};
pub use obj::{Normals, OBJ_BYTES_LIMIT, ObjError, ObjFault, ObjMesh, parse_obj, read_obj};
pub use polygon::CONCAVE_CORNERS_LIMIT;
pub use primitive::{PreparedRay, Primitive, RawHit, double, single};
pub use shape::{Instance, Shape, Surface};
pub use sphere::Sphere;
pub use terminator::ShadowTerminator;
pub use transform::Transform;

/// Largest magnitude of a world coordinate. Squares and products of coordinates up to here stay
/// finite wherever the renderer forms them.
pub const COORDINATE_LIMIT: f32 = 1e12;
