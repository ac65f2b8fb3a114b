//! OBJ files.

mod attributes;
mod faces;
mod fault;
mod read;
mod statements;

pub use fault::{ObjError, ObjFault};
pub use read::{Normals, ObjMesh, parse_obj, read_obj};
