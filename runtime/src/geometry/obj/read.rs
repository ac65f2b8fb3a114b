//! Reading OBJ files.

use std::io::Read;
use std::path::Path;

use phenomenon_compiler::document::open_file;

use super::attributes::Attributes;
use super::faces::Assembly;
use super::fault::{ObjError, ObjFault};
use super::statements::Statements;
use crate::geometry::limits::OBJ_BYTES_LIMIT;
use crate::geometry::mesh::{Mesh, MeshError};

/// Which normals a mesh is shaded with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Normals {
    /// The file's; faces without are smoothed.
    #[default]
    Smooth,
    /// The triangles' own.
    Flat,
}

/// A mesh read from an OBJ file.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjMesh {
    /// The mesh.
    pub mesh: Mesh,
    /// How many triangles were left out because they have no area: no ray can meet them.
    pub flat_triangles: usize,
}

/// Reads all faces of an OBJ file as one mesh, cut into triangles. `docs/scene-format.md` says
/// which statements are read.
///
/// # Errors
/// A file that cannot be read, or whose mesh cannot be used; which line is at fault.
pub fn read_obj(path: &Path, normals: Normals) -> Result<ObjMesh, ObjError> {
    let unreadable = |source| ObjError::Unreadable { path: path.to_owned(), source };
    let (file, size) = open_file(path).map_err(unreadable)?;
    let too_large = |bytes| ObjError::TooLarge { path: path.to_owned(), bytes };
    if size > OBJ_BYTES_LIMIT {
        return Err(too_large(size));
    }
    let mut bytes = Vec::new();
    let room = bytes.try_reserve_exact(size as usize + 1);
    room.map_err(|_| unreadable(std::io::ErrorKind::OutOfMemory.into()))?;
    // It may have grown meanwhile.
    file.take(OBJ_BYTES_LIMIT + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > OBJ_BYTES_LIMIT {
        return Err(too_large(bytes.len() as u64));
    }
    parse_obj(&bytes, normals).map_err(|(line, fault)| ObjError::Malformed {
        path: path.to_owned(),
        line,
        fault,
    })
}

/// Makes a mesh of the text of an OBJ file of at most [`OBJ_BYTES_LIMIT`] bytes.
///
/// # Errors
/// What is wrong, and in which line (from 1) unless it is the whole.
pub fn parse_obj(bytes: &[u8], normals: Normals) -> Result<ObjMesh, (Option<usize>, ObjFault)> {
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return Err((Some(1), ObjFault::Utf16));
    }
    // The faces come last, so that none has to be kept: they may name what stands below them.
    let mut statements = Statements::new(bytes);
    let attributes = Attributes::read(&mut statements);
    let attributes = attributes.map_err(|fault| (Some(statements.line()), fault))?;
    let mut assembly = Assembly::new(&attributes, normals == Normals::Smooth);
    let mut statements = Statements::new(bytes);
    let read = assembly.read(&mut statements);
    read.map_err(|fault| (Some(statements.line()), fault))?;
    let (mesh, flat_triangles) = assembly.finish().map_err(|error| (None, error.into()))?;
    match (mesh.validate(), flat_triangles, attributes.stranger) {
        (Ok(()), ..) => Ok(ObjMesh { mesh, flat_triangles }),
        (Err(MeshError::Empty), 1.., _) => Err((None, ObjFault::NothingLeft(flat_triangles))),
        (Err(MeshError::Empty), 0, Some((line, word))) => {
            Err((Some(line), ObjFault::NoStatement(word)))
        }
        (Err(error), ..) => Err((None, error.into())),
    }
}
