//! The mesh files of a scene.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::document::{Reader, Value};

use crate::geometry::{Mesh, Normals, ObjError, read_obj};

/// The mesh files read so far: objects that share a file read it once and keep it once.
#[derive(Default)]
pub(super) struct Meshes {
    known: HashMap<(PathBuf, Normals), Result<Known, Refusal>>,
}

#[derive(Clone)]
struct Known {
    mesh: Arc<Mesh>,
    flat_triangles: usize,
}

#[derive(Clone)]
struct Refusal {
    code: Code,
    message: String,
    help: &'static str,
}

impl Meshes {
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
        let known = self.known.entry((identity, normals)).or_insert_with(|| read(path, normals));
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

fn read(path: &Path, normals: Normals) -> Result<Known, Refusal> {
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
