//! Triangle meshes.

use std::collections::{HashMap, TryReserveError};

use glam::DVec3;

use super::limits::COORDINATE_LIMIT;
use super::polygon::is_flat;
use super::transform::Transform;
use super::vector::{double, single, unit};

/// A triangle mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Vertex positions.
    pub positions: Vec<[f32; 3]>,
    /// Vertex normals, one per position, or none: flat shading.
    pub normals: Vec<[f32; 3]>,
    /// Surface coordinates, one per position, or none: barycentric weights.
    pub uvs: Vec<[f32; 2]>,
    /// Scene-linear colours, one per position, or none: white.
    pub colors: Vec<[f32; 3]>,
    /// A second set of surface coordinates, those of each triangle's corners, or none: the first set.
    pub second_uvs: Vec<[[f32; 2]; 3]>,
    /// Vertices of the triangles, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// What is wrong with a mesh.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// It has no triangle.
    #[error("the mesh has no triangles")]
    Empty,
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle} uses vertex {vertex}, but the mesh has {count} vertices")]
    IndexOutOfRange {
        /// The triangle, from 0.
        triangle: usize,
        /// The vertex it names, from 0.
        vertex: u32,
        /// How many there are.
        count: usize,
    },
    /// A position is not finite or too far out.
    #[error(
        "vertex {vertex} lies at {position:?}; coordinates must be finite and at most 1e12 in magnitude"
    )]
    BadPosition {
        /// The vertex, from 0.
        vertex: usize,
        /// Where it lies.
        position: [f32; 3],
    },
    /// Normals, surface coordinates or colours do not match the vertices.
    #[error("the mesh has {count} {what} for {vertices} vertices")]
    CountMismatch {
        /// `normals`, `surface coordinates` or `colours`.
        what: &'static str,
        /// How many there are.
        count: usize,
        /// How many there should be.
        vertices: usize,
    },
    /// The second set of surface coordinates is not for its triangles.
    #[error(
        "the mesh has second surface coordinates for {count} triangles, and {triangles} triangles"
    )]
    SecondSet {
        /// For how many triangles it is.
        count: usize,
        /// How many there are.
        triangles: usize,
    },
    /// A normal, a surface coordinate or a colour is not finite.
    #[error("vertex {vertex} has {what} that are not finite")]
    NotFinite {
        /// `normals`, `surface coordinates` or `colours`.
        what: &'static str,
        /// The vertex, from 0.
        vertex: usize,
    },
    /// The transform flattens the mesh or is not finite.
    #[error("the transform is not finite or flattens the object")]
    IrregularTransform,
    /// Where it is placed, 32 bits leave no triangle an area.
    #[error("so far from the origin the object has no area left in 32 bits")]
    RoundedFlat,
    /// There is no memory for it.
    #[error("there is not enough memory for the mesh")]
    OutOfMemory,
}

impl From<TryReserveError> for MeshError {
    fn from(_: TryReserveError) -> Self {
        MeshError::OutOfMemory
    }
}

/// Adds to a list whose length a file decides.
pub(super) fn push<T>(list: &mut Vec<T>, element: T) -> Result<(), MeshError> {
    list.try_reserve(1)?;
    list.push(element);
    Ok(())
}

/// A copy of a list whose length a file decides.
fn copied<T: Copy>(list: &[T]) -> Result<Vec<T>, MeshError> {
    let mut copy = Vec::new();
    copy.try_reserve_exact(list.len())?;
    copy.extend_from_slice(list);
    Ok(copy)
}

fn finite(numbers: &[f32]) -> bool {
    numbers.iter().all(|x| x.is_finite())
}

impl Mesh {
    /// Checks that every index, number and count is usable.
    pub fn validate(&self) -> Result<(), MeshError> {
        if self.triangles.is_empty() {
            return Err(MeshError::Empty);
        }
        let vertices = self.positions.len();
        for (what, count) in [
            ("normals", self.normals.len()),
            ("surface coordinates", self.uvs.len()),
            ("colours", self.colors.len()),
        ] {
            if count != 0 && count != vertices {
                return Err(MeshError::CountMismatch { what, count, vertices });
            }
        }
        let (count, triangles) = (self.second_uvs.len(), self.triangles.len());
        if count != 0 && count != triangles {
            return Err(MeshError::SecondSet { count, triangles });
        }
        for (triangle, indices) in self.triangles.iter().enumerate() {
            if let Some(&vertex) = indices.iter().find(|&&vertex| vertex as usize >= vertices) {
                return Err(MeshError::IndexOutOfRange { triangle, vertex, count: vertices });
            }
        }
        let at = |triangle: usize| self.triangles[triangle][0] as usize;
        let second = self.second_uvs.iter().position(|of| !finite(of.as_flattened())).map(at);
        for (what, found) in [
            ("normals", self.normals.iter().position(|of| !finite(of))),
            ("surface coordinates", self.uvs.iter().position(|of| !finite(of)).or(second)),
            ("colours", self.colors.iter().position(|of| !finite(of))),
        ] {
            if let Some(vertex) = found {
                return Err(MeshError::NotFinite { what, vertex });
            }
        }
        let outside = |x: &f32| x.is_nan() || x.abs() > COORDINATE_LIMIT;
        match self.positions.iter().position(|position| position.iter().any(outside)) {
            Some(vertex) => {
                Err(MeshError::BadPosition { vertex, position: self.positions[vertex] })
            }
            None => Ok(()),
        }
    }

    /// A copy, if there is memory for it.
    pub(super) fn copied(&self) -> Result<Mesh, MeshError> {
        Ok(Mesh {
            positions: copied(&self.positions)?,
            normals: copied(&self.normals)?,
            uvs: copied(&self.uvs)?,
            colors: copied(&self.colors)?,
            second_uvs: copied(&self.second_uvs)?,
            triangles: copied(&self.triangles)?,
        })
    }

    /// The mesh in world space. Triangles keep their outside when the transform mirrors; where the
    /// mesh has normals, they decide which side is outside.
    pub fn transformed(&self, transform: &Transform) -> Result<Mesh, MeshError> {
        self.validate()?;
        if !transform.is_regular() {
            return Err(MeshError::IrregularTransform);
        }
        let mut mesh = self.copied()?;
        for position in &mut mesh.positions {
            *position = single(transform.point(double(*position)));
        }
        for normal in &mut mesh.normals {
            *normal = unit(transform.normal(double(*normal))).map_or([0.0; 3], single);
        }
        if transform.mirrors() {
            (0..mesh.triangles.len()).for_each(|number| mesh.turn(number));
        }
        mesh.validate()?;
        if (0..mesh.triangles.len()).all(|number| is_flat(mesh.vertices(number))) {
            return Err(MeshError::RoundedFlat);
        }
        mesh.turn_to_normals();
        Ok(mesh)
    }

    /// Sets each vertex's normal to the mean of its triangles' normals weighted by their angles
    /// there; vertices at equal positions share one.
    ///
    /// # Errors
    /// There is no memory for them.
    pub fn smooth(&mut self) -> Result<(), MeshError> {
        self.smooth_where(|_| true)
    }

    /// The same by those triangles alone that `counts`; vertices of no such triangle have no normal.
    pub(super) fn smooth_where(
        &mut self,
        counts: impl Fn(&[u32; 3]) -> bool,
    ) -> Result<(), MeshError> {
        let mut sums: HashMap<[u32; 3], DVec3> = HashMap::new();
        // Adding 0 makes one key of 0 and -0.
        let key = |position: [f32; 3]| position.map(|x| (x + 0.0).to_bits());
        for triangle in self.triangles.iter().filter(|triangle| counts(triangle)) {
            let corners = triangle.map(|vertex| double(self.positions[vertex as usize]));
            let Some(normal) = unit((corners[1] - corners[0]).cross(corners[2] - corners[0]))
            else {
                continue;
            };
            for at in 0..3 {
                let first = corners[(at + 1) % 3] - corners[at];
                let second = corners[(at + 2) % 3] - corners[at];
                let angle = first.cross(second).length().atan2(first.dot(second));
                sums.try_reserve(1)?;
                *sums.entry(key(self.positions[triangle[at] as usize])).or_default() +=
                    normal * angle;
            }
        }
        let normal = |position: &[f32; 3]| {
            sums.get(&key(*position)).and_then(|sum| unit(*sum)).map_or([0.0; 3], single)
        };
        let mut normals = Vec::new();
        normals.try_reserve_exact(self.positions.len())?;
        normals.extend(self.positions.iter().map(normal));
        self.normals = normals;
        Ok(())
    }

    /// Swaps the winding of triangles that face against their vertices' normals.
    fn turn_to_normals(&mut self) {
        if self.normals.is_empty() {
            return;
        }
        for number in 0..self.triangles.len() {
            let triangle = self.triangles[number];
            let [a, b, c] = triangle.map(|vertex| double(self.positions[vertex as usize]));
            let mean: DVec3 = triangle.iter().map(|&v| double(self.normals[v as usize])).sum();
            if (b - a).cross(c - a).dot(mean) < 0.0 {
                self.turn(number);
            }
        }
    }

    /// Swaps the winding of a triangle.
    fn turn(&mut self, number: usize) {
        self.triangles[number].swap(1, 2);
        if let Some(uvs) = self.second_uvs.get_mut(number) {
            uvs.swap(1, 2);
        }
    }

    /// Vertices of triangle `number`.
    pub fn vertices(&self, number: usize) -> [[f32; 3]; 3] {
        self.triangles[number].map(|vertex| self.positions[vertex as usize])
    }

    /// The unit shading normal at a place of triangle `number` with these barycentric weights, in the hemisphere of
    /// the geometric one.
    #[inline]
    pub(super) fn normal(&self, number: u32, weights: [f64; 3], normal_geom: DVec3) -> DVec3 {
        if self.normals.is_empty() {
            return normal_geom;
        }
        let indices = self.triangles[number as usize];
        let of = |at: usize| double(self.normals[indices[at] as usize]) * weights[at];
        let normal = unit(of(0) + of(1) + of(2)).unwrap_or(normal_geom);
        if normal.dot(normal_geom) < 0.0 { -normal } else { normal }
    }

    /// The surface coordinates at a place of triangle `number` with these barycentric weights; the weights themselves
    /// where the mesh has none.
    #[inline]
    pub(super) fn coordinates(&self, number: u32, weights: [f64; 3]) -> [f32; 2] {
        if self.uvs.is_empty() {
            return [weights[1] as f32, weights[2] as f32];
        }
        let indices = self.triangles[number as usize];
        [0, 1].map(|axis| {
            let of = |at: usize| f64::from(self.uvs[indices[at] as usize][axis]) * weights[at];
            (of(0) + of(1) + of(2)) as f32
        })
    }

    /// A rectangle in the plane y = 0, `width` along x and `depth` along z, round the origin, its
    /// outside up. A picture on it is upright from above where -z is up.
    pub fn rectangle(width: f32, depth: f32) -> Mesh {
        let (x, z) = (width * 0.5, depth * 0.5);
        Mesh {
            positions: vec![[-x, 0.0, -z], [-x, 0.0, z], [x, 0.0, z], [x, 0.0, -z]],
            normals: Vec::new(),
            uvs: vec![[0.0, 1.0], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0]],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            ..Mesh::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn broken_meshes_are_named() {
        let mut mesh = Mesh::rectangle(1.0, 1.0);
        mesh.positions[2][1] = f32::NAN;
        assert!(matches!(mesh.validate(), Err(MeshError::BadPosition { vertex: 2, .. })));
        mesh.positions[2][1] = 2e12;
        assert!(matches!(mesh.validate(), Err(MeshError::BadPosition { vertex: 2, .. })));
        let mut mesh = Mesh::rectangle(1.0, 1.0);
        mesh.triangles[1][0] = 4;
        assert_eq!(
            mesh.validate(),
            Err(MeshError::IndexOutOfRange { triangle: 1, vertex: 4, count: 4 })
        );
        mesh.triangles.clear();
        assert_eq!(mesh.validate(), Err(MeshError::Empty));
        let mut mesh = Mesh::rectangle(1.0, 1.0);
        mesh.uvs[3][1] = f32::INFINITY;
        assert!(matches!(mesh.validate(), Err(MeshError::NotFinite { vertex: 3, .. })));
        mesh.uvs.clear();
        mesh.normals = vec![[0.0, f32::NAN, 0.0]; 4];
        assert!(matches!(mesh.validate(), Err(MeshError::NotFinite { vertex: 0, .. })));
        let mut mesh = Mesh::rectangle(1.0, 1.0);
        mesh.uvs.pop();
        assert!(matches!(mesh.validate(), Err(MeshError::CountMismatch { count: 3, .. })));
    }

    #[test]
    fn a_mirrored_rectangle_keeps_its_outside() {
        let mirror = Transform::new([-1.0, 1.0, 1.0], [0.0; 3], [0.0; 3]);
        let mesh = Mesh::rectangle(2.0, 2.0).transformed(&mirror).unwrap();
        for number in 0..2 {
            let [a, b, c] = mesh.vertices(number).map(double);
            assert!((b - a).cross(c - a).y > 0.0);
        }
    }

    #[test]
    fn normals_decide_which_side_is_outside() {
        let mut mesh = Mesh::rectangle(2.0, 2.0);
        mesh.normals = vec![[0.0, -1.0, 0.0]; 4];
        let mesh = mesh.transformed(&Transform::default()).unwrap();
        let [a, b, c] = mesh.vertices(0).map(double);
        assert!((b - a).cross(c - a).y < 0.0);
    }

    #[test]
    fn smoothing_joins_vertices_at_equal_positions() {
        let mut mesh = Mesh {
            positions: vec![
                [0.0, 0.0, 0.0],
                [1.0, 0.0, 0.0],
                [0.0, 1.0, 0.0],
                [-0.0, 0.0, 0.0],
                [0.0, 1.0, 0.0],
                [0.0, 0.0, 1.0],
            ],
            triangles: vec![[0, 1, 2], [3, 4, 5]],
            ..Mesh::default()
        };
        mesh.smooth().unwrap();
        assert_eq!(mesh.normals[0], mesh.normals[3]);
        assert_eq!(mesh.normals[2], mesh.normals[4]);
        assert_eq!(mesh.normals[1], [0.0, 0.0, 1.0]);
        assert_eq!(mesh.normals[5], [1.0, 0.0, 0.0]);
    }
}
