//! A second set of surface coordinates. OBJ files hold one set, so the second is that of another file of the
//! same mesh.

use super::mesh::{Mesh, MeshError, push};

/// Why the surface coordinates of one mesh are no second set for another.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SecondSetError {
    /// It has other triangles.
    #[error("it has {count} triangles, and the mesh has {triangles}")]
    Count {
        /// How many it has.
        count: usize,
        /// How many the mesh has.
        triangles: usize,
    },
    /// A triangle lies elsewhere.
    #[error("its triangle {triangle} has other corners than that of the mesh")]
    Corners {
        /// The triangle, from 1.
        triangle: usize,
    },
    /// It has no surface coordinates.
    #[error("it has no surface coordinates (`vt`)")]
    NoCoordinates,
    /// There is no memory for the two.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

impl Mesh {
    /// The mesh with the surface coordinates of another as its second set. The other has the same
    /// triangles, corner by corner in the same places; what else it has does not count.
    ///
    /// # Errors
    /// It has other triangles, or no surface coordinates.
    pub fn with_second_set(&self, other: &Mesh) -> Result<Mesh, SecondSetError> {
        let (count, triangles) = (other.triangles.len(), self.triangles.len());
        if count != triangles {
            return Err(SecondSetError::Count { count, triangles });
        }
        if other.uvs.is_empty() {
            return Err(SecondSetError::NoCoordinates);
        }
        let mut mesh = self.copied()?;
        mesh.second_uvs = Vec::new();
        for at in 0..triangles {
            if self.vertices(at) != other.vertices(at) {
                return Err(SecondSetError::Corners { triangle: at + 1 });
            }
            let corners = other.triangles[at].map(|vertex| other.uvs[vertex as usize]);
            push(&mut mesh.second_uvs, corners)?;
        }
        Ok(mesh)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Transform;

    #[test]
    fn the_coordinates_of_another_mesh_become_the_second_set() {
        let mesh = Mesh::rectangle(2.0, 2.0);
        let mut other = mesh.clone();
        other.uvs = vec![[0.5, 0.0], [0.0, 0.5], [1.0, 0.5], [0.5, 1.0]];
        let both = mesh.with_second_set(&other).unwrap();
        assert_eq!(both.second_uvs[0], [[0.5, 0.0], [0.0, 0.5], [1.0, 0.5]]);
        assert_eq!(both.uvs, mesh.uvs);
        // Where a triangle is turned round, its corners keep their coordinates.
        let mirror = Transform::new([-1.0, 1.0, 1.0], [0.0; 3], [0.0; 3]);
        let turned = both.transformed(&mirror).unwrap();
        assert_eq!(turned.second_uvs[0], [[0.5, 0.0], [1.0, 0.5], [0.0, 0.5]]);
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        let mesh = Mesh::rectangle(2.0, 2.0);
        let refused = |change: fn(&mut Mesh)| {
            let mut other = mesh.clone();
            change(&mut other);
            mesh.with_second_set(&other).unwrap_err()
        };
        let count = SecondSetError::Count { count: 1, triangles: 2 };
        assert_eq!(refused(|other| other.triangles.truncate(1)), count);
        let corners = SecondSetError::Corners { triangle: 2 };
        assert_eq!(refused(|other| other.positions[3][1] = 1.0), corners);
        assert_eq!(refused(|other| other.uvs.clear()), SecondSetError::NoCoordinates);
    }
}
