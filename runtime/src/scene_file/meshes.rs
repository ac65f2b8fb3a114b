//! The mesh files of one scene.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::document::{Reader, Value};

use super::assets::Assets;
use super::mesh_file::{MeshRefusal, ReadMesh};
use crate::geometry::{Mesh, Normals};

/// The mesh files of one scene: objects that share a file read it once and keep it once.
pub(super) struct Meshes<'a> {
    assets: &'a Assets,
    known: HashMap<(PathBuf, Normals), Result<ReadMesh, MeshRefusal>>,
}

impl<'a> Meshes<'a> {
    /// Those that come from `assets`.
    pub(super) fn of(assets: &'a Assets) -> Self {
        Self { assets, known: HashMap::new() }
    }

    /// A mesh with the surface coordinates of the file that is named at `value` as its second set.
    pub(super) fn with_second_set(
        &mut self,
        reader: &mut Reader<'_>,
        value: &Value,
        path: &Path,
        normals: Normals,
        mesh: &Mesh,
    ) -> Option<Arc<Mesh>> {
        let other = self.read(reader, value, path, normals)?;
        match mesh.with_second_set(&other) {
            Ok(mesh) => Some(Arc::new(mesh)),
            Err(error) => {
                let message = format!("the second set does not fit the mesh: {error}");
                let help = "save the same mesh again, with its other surface coordinates";
                reader.report(Code::UNUSABLE_OBJECT, value, message, help);
                None
            }
        }
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
            Ok(ReadMesh { mesh, flat_triangles }) => {
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
            Err(MeshRefusal { code, message, help }) => {
                reader.report(code, value, message, help);
                None
            }
        }
    }
}
