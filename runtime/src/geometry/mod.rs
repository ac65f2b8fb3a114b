//! Shapes, how rays meet them, and what is known about the points they meet.

mod barycentric;
mod derivatives;
mod footprint;
mod limits;
mod mesh;
mod obj;
mod polygon;
mod primitive;
mod ray;
mod second_set;
mod shape;
mod sheared;
mod sphere;
mod terminator;
mod transform;
mod triangle;
mod vector;

pub use footprint::footprint;
pub use limits::{COORDINATE_LIMIT, OBJ_BYTES_LIMIT};
pub use mesh::{Mesh, MeshError};
pub use obj::{Normals, ObjError, ObjFault, ObjMesh, parse_obj, read_obj};
pub use polygon::CONCAVE_CORNERS_LIMIT;
pub use primitive::{Primitive, RawHit};
pub use ray::PreparedRay;
pub use second_set::SecondSetError;
pub use shape::{Shape, Surface};
pub use sphere::Sphere;
pub use terminator::ShadowTerminator;
pub use transform::Transform;
pub use vector::{double, single};
