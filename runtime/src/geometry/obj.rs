//! OBJ files.

use std::path::{Path, PathBuf};

use phenomenon_compiler::document::open_file;

use super::mesh::{Mesh, MeshError};

/// Largest OBJ file that is read, in bytes.
pub const OBJ_BYTES_LIMIT: u64 = 1 << 30;

/// Which normals a mesh is shaded with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Normals {
    /// The file's; smoothed where the file has none.
    #[default]
    Smooth,
    /// The triangles' own.
    Flat,
}

/// Why an OBJ file could not be used.
#[derive(Debug, thiserror::Error)]
pub enum ObjError {
    /// It could not be opened or is no file.
    #[error("cannot read {path}: {source}", path = path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// It is too large.
    #[error("{path} has {bytes} bytes; the limit is {OBJ_BYTES_LIMIT}", path = path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// Its size.
        bytes: u64,
    },
    /// It is not an OBJ file.
    #[error("{path} is not a usable OBJ file: {source}", path = path.display())]
    Malformed {
        /// The file.
        path: PathBuf,
        /// What the reader says.
        source: tobj::LoadError,
    },
    /// What it holds is not usable.
    #[error("{path}: {source}", path = path.display())]
    BadMesh {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        source: MeshError,
    },
}

/// Reads all groups of an OBJ file as one mesh; polygons are cut into triangles, points and lines
/// left out, material libraries ignored.
pub fn read_obj(path: &Path, normals: Normals) -> Result<Mesh, ObjError> {
    let unreadable = |source| ObjError::Unreadable { path: path.to_owned(), source };
    let (file, bytes) = open_file(path).map_err(unreadable)?;
    if bytes > OBJ_BYTES_LIMIT {
        return Err(ObjError::TooLarge { path: path.to_owned(), bytes });
    }
    let mut reader = std::io::BufReader::new(file);
    let options = tobj::LoadOptions {
        triangulate: true,
        single_index: true,
        ignore_points: true,
        ignore_lines: true,
    };
    let no_materials = |_: &Path| Err(tobj::LoadError::GenericFailure);
    let (models, _) = tobj::load_obj_buf(&mut reader, &options, no_materials)
        .map_err(|source| ObjError::Malformed { path: path.to_owned(), source })?;
    let mut mesh = joined(&models);
    let checked = mesh.validate();
    checked.map_err(|source| ObjError::BadMesh { path: path.to_owned(), source })?;
    match normals {
        Normals::Flat => mesh.normals.clear(),
        Normals::Smooth if mesh.normals.is_empty() => mesh.smooth(),
        Normals::Smooth => {}
    }
    Ok(mesh)
}

/// All models as one mesh. Normals and surface coordinates are kept if every model has them.
fn joined(models: &[tobj::Model]) -> Mesh {
    let parts = || models.iter().map(|model| &model.mesh).filter(|part| !part.indices.is_empty());
    let complete =
        |of: fn(&tobj::Mesh) -> usize| parts().all(|part| of(part) == part.positions.len() / 3);
    let with_normals = complete(|part| part.normals.len() / 3);
    let with_uvs = complete(|part| part.texcoords.len() / 2);
    let mut mesh = Mesh::default();
    for part in parts() {
        let base = mesh.positions.len() as u32;
        mesh.positions.extend(part.positions.chunks_exact(3).map(|p| [p[0], p[1], p[2]]));
        if with_normals {
            mesh.normals.extend(part.normals.chunks_exact(3).map(|n| [n[0], n[1], n[2]]));
        }
        if with_uvs {
            mesh.uvs.extend(part.texcoords.chunks_exact(2).map(|t| [t[0], t[1]]));
        }
        let triangle = |i: &[u32]| [i[0], i[1], i[2]].map(|vertex| base.saturating_add(vertex));
        mesh.triangles.extend(part.indices.chunks_exact(3).map(triangle));
    }
    mesh
}
