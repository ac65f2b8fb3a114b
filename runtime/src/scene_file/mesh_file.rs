//! One mesh file: what is known of it, or why it cannot be used.

use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::diagnostics::Code;

use crate::film::srgb_decoded;
use crate::geometry::{Mesh, Normals, ObjError, read_obj};

/// A mesh that was read.
#[derive(Clone, Debug)]
pub(super) struct ReadMesh {
    pub(super) mesh: Arc<Mesh>,
    pub(super) flat_triangles: usize,
}

/// Why a mesh cannot be used.
#[derive(Clone, Debug)]
pub(super) struct MeshRefusal {
    pub(super) code: Code,
    pub(super) message: String,
    pub(super) help: &'static str,
}

impl ReadMesh {
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
            uvs: if self.mesh.uvs.is_empty() { Vec::new() } else { vec![[0.0; 2]; 8] },
            ..Mesh::default()
        };
        Self { mesh: Arc::new(mesh), ..self }
    }
}

/// Reads a mesh file.
pub(super) fn read_mesh(path: &Path, normals: Normals) -> Result<ReadMesh, MeshRefusal> {
    match read_obj(path, normals) {
        Ok(mut read) => {
            // What writes colours into OBJ files writes them encoded for the screen.
            let colors = read.mesh.colors.as_flattened_mut();
            colors.iter_mut().for_each(|color| *color = srgb_decoded(*color));
            Ok(ReadMesh { mesh: Arc::new(read.mesh), flat_triangles: read.flat_triangles })
        }
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
            Err(MeshRefusal { code, message: error.to_string(), help })
        }
    }
}
