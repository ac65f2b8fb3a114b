//! The mesh files of a scene.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::document::{Reader, Value};

use super::assets::Assets;
use crate::geometry::{Mesh, Normals, ObjError, read_obj};

/// The mesh files of one scene: objects that share a file read it once and keep it once.
pub(super) struct Meshes<'a> {
    assets: &'a Assets,
    known: HashMap<(PathBuf, Normals), Result<Known, Refusal>>,
}

/// A mesh that was read.
#[derive(Clone, Debug)]
pub(super) struct Known {
    mesh: Arc<Mesh>,
    flat_triangles: usize,
}

/// Why a mesh cannot be used.
#[derive(Clone, Debug)]
pub(super) struct Refusal {
    code: Code,
    message: String,
    help: &'static str,
}

impl Known {
    /// The box round the mesh in its place: wherever that can stand, the mesh can.
    pub(super) fn boxed(self) -> Self {
        let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for position in &self.mesh.positions {
            for axis in 0..3 {
                low[axis] = low[axis].min(position[axis]);
                high[axis] = high[axis].max(position[axis]);
            }
        }
        let corner = |at: usize| {
            [0, 1, 2].map(|axis| if at >> axis & 1 == 0 { low[axis] } else { high[axis] })
        };
        let mesh = Mesh {
            positions: (0..8).map(corner).collect(),
            triangles: vec![[0, 1, 2], [3, 4, 5], [5, 6, 7]],
            ..Mesh::default()
        };
        Self { mesh: Arc::new(mesh), ..self }
    }
}

impl<'a> Meshes<'a> {
    /// Those that come from `assets`.
    pub(super) fn of(assets: &'a Assets) -> Self {
        Self { assets, known: HashMap::new() }
    }

    /// The mesh of the file that is named at `value`.
    pub(super) fn read(
        &mut self,
        reader: &mut Reader<'_>,
        value: &Value,
        path: &Path,
        normals: Normals,
    ) -> Option<Arc<Mesh>> {
        // A file may be named in several ways.
        let identity = std::fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        let assets = self.assets;
        let known = self.known.entry((identity, normals));
        let known = known.or_insert_with(|| assets.mesh(path, normals));
        match known.clone() {
            Ok(Known { mesh, flat_triangles }) => {
                if flat_triangles > 0 {
                    let count = match flat_triangles {
                        1 => "1 triangle of the mesh has".to_owned(),
                        count => format!("{count} triangles of the mesh have"),
                    };
                    let message = format!("{count} no area, and no ray can meet them: left out");
                    let help = "nothing is lost; remove them from the file to hear no more of it";
                    reader.report(Code::FLAT_TRIANGLES, value, message, help);
                }
                Some(mesh)
            }
            Err(Refusal { code, message, help }) => {
                reader.report(code, value, message, help);
                None
            }
        }
    }
}

/// Reads a mesh file.
pub(super) fn read(path: &Path, normals: Normals) -> Result<Known, Refusal> {
    match read_obj(path, normals) {
        Ok(read) => Ok(Known { mesh: Arc::new(read.mesh), flat_triangles: read.flat_triangles }),
        Err(error) => {
            let (code, help) = match error {
                ObjError::Unreadable { .. } => (
                    Code::UNREADABLE_FILE,
                    "give an OBJ file; its path starts at the scene's folder",
                ),
                ObjError::TooLarge { .. } => {
                    (Code::FILE_TOO_LARGE, "save it in parts, each an object of the scene")
                }
                ObjError::Malformed { .. } => {
                    (Code::UNUSABLE_FILE, "mend the OBJ file, or save it anew where it was made")
                }
            };
            Err(Refusal { code, message: error.to_string(), help })
        }
    }
}
