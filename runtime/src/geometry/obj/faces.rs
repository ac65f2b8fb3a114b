//! The faces of an OBJ file, put together to a mesh.

use std::collections::HashMap;

use super::attributes::Attributes;
use super::fault::ObjFault;
use super::statements::Statements;
use crate::geometry::mesh::{Mesh, MeshError, push};
use crate::geometry::polygon::{CutError, cut, is_flat};

/// In place of an index that is not given. Files are too small to have so many of anything.
const NONE: u32 = u32::MAX;

/// A corner: a position, surface coordinates and a normal, from 0; the last two may be [`NONE`].
type Corner = [u32; 3];

/// What has come before a line, which negative indices count from.
#[derive(Clone, Copy, Debug, Default)]
struct SoFar([usize; 3]);

const WHAT: [&str; 3] = ["vertex", "texture coordinate", "normal"];

/// Puts the mesh together, face by face.
pub(super) struct Assembly<'a> {
    attributes: &'a Attributes,
    keep_normals: bool,
    vertices: HashMap<Corner, u32>,
    /// What each vertex of the mesh was made of.
    corners: Vec<Corner>,
    triangles: Vec<[u32; 3]>,
    /// Triangles without area.
    flat: usize,
    /// The corners of one face.
    face: Vec<Corner>,
}

impl<'a> Assembly<'a> {
    pub(super) fn new(attributes: &'a Attributes, keep_normals: bool) -> Self {
        Self {
            attributes,
            keep_normals,
            vertices: HashMap::new(),
            corners: Vec::new(),
            triangles: Vec::new(),
            flat: 0,
            face: Vec::new(),
        }
    }

    /// Adds every face; on failure `statements` stands in the line at fault.
    pub(super) fn read(&mut self, statements: &mut Statements<'_>) -> Result<(), ObjFault> {
        let mut so_far = SoFar::default();
        while let Some(keyword) = statements.statement() {
            match keyword {
                b"v" => so_far.0[0] += 1,
                b"vt" => so_far.0[1] += 1,
                b"vn" => so_far.0[2] += 1,
                b"f" | b"fo" => {
                    self.face.clear();
                    let mut count = 0;
                    while let Some(word) = statements.word() {
                        let corner = self.corner(word, so_far)?;
                        count += 1;
                        // Two corners in one place are one.
                        if self.face.last().is_none_or(|last| !self.same_place(last, &corner)) {
                            push(&mut self.face, corner)?;
                        }
                    }
                    if count < 3 {
                        return Err(ObjFault::TooFewCorners(count));
                    }
                    self.add_face(count)?;
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn position(&self, corner: &Corner) -> [f32; 3] {
        self.attributes.positions[corner[0] as usize]
    }

    fn same_place(&self, a: &Corner, b: &Corner) -> bool {
        a[0] == b[0] || self.position(a) == self.position(b)
    }

    /// `1`, `1/2`, `1//3` or `1/2/3`.
    fn corner(&self, word: &[u8], so_far: SoFar) -> Result<Corner, ObjFault> {
        let not_a_corner = || ObjFault::NotACorner(ObjFault::shown(word));
        if word.split(|&byte| byte == b'/').count() > WHAT.len() {
            return Err(not_a_corner());
        }
        let Attributes { positions, uvs, normals, .. } = self.attributes;
        let counts = [positions.len(), uvs.len(), normals.len()];
        let mut corner = [NONE; 3];
        for (at, part) in word.split(|&byte| byte == b'/').enumerate() {
            if at == 0 && part.is_empty() {
                return Err(not_a_corner());
            }
            if part.is_empty() {
                continue;
            }
            let index = index(part).ok_or_else(not_a_corner)?;
            let count = if index < 0 { so_far.0[at] } else { counts[at] };
            let from_start = match index {
                0 => return Err(ObjFault::IndexZero(ObjFault::shown(word))),
                1.. => Some(index - 1),
                _ => index.checked_add(count as i64),
            };
            let found = from_start.filter(|index| (0..count as i64).contains(index));
            let out_of_range = || {
                let word = ObjFault::shown(word);
                ObjFault::IndexOutOfRange { word, what: WHAT[at], count }
            };
            corner[at] = found.ok_or_else(out_of_range)? as u32;
        }
        Ok(corner)
    }

    /// Cuts the face into triangles and adds those that have an area. `count` is the number of its
    /// corners in the file.
    fn add_face(&mut self, count: usize) -> Result<(), ObjFault> {
        while let [first, .., last] = &self.face[..]
            && self.same_place(first, last)
        {
            self.face.pop();
        }
        // What only some corners have, the face has not.
        for at in [1, 2] {
            let is_left_out = at == 2 && !self.keep_normals;
            if is_left_out || self.face.iter().any(|corner| corner[at] == NONE) {
                self.face.iter_mut().for_each(|corner| corner[at] = NONE);
            }
        }
        let mut places = Vec::new();
        places.try_reserve_exact(self.face.len()).map_err(MeshError::from)?;
        places.extend(self.face.iter().map(|corner| self.position(corner)));
        let triangles = cut(&places).map_err(|error| match error {
            CutError::TooManyCorners => ObjFault::TooManyCorners(places.len()),
            CutError::OutOfMemory => MeshError::OutOfMemory.into(),
        })?;
        let before = self.triangles.len();
        for triangle in triangles {
            if is_flat(triangle.map(|at| places[at as usize])) {
                continue;
            }
            let mut vertices = [0; 3];
            for (vertex, at) in vertices.iter_mut().zip(triangle) {
                *vertex = self.vertex(self.face[at as usize])?;
            }
            push(&mut self.triangles, vertices)?;
        }
        self.flat += count - 2 - (self.triangles.len() - before);
        Ok(())
    }

    fn vertex(&mut self, corner: Corner) -> Result<u32, MeshError> {
        if let Some(&vertex) = self.vertices.get(&corner) {
            return Ok(vertex);
        }
        self.vertices.try_reserve(1)?;
        let vertex = self.corners.len() as u32;
        push(&mut self.corners, corner)?;
        self.vertices.insert(corner, vertex);
        Ok(vertex)
    }

    /// The mesh, and how many triangles were left out because they have no area.
    pub(super) fn finish(mut self) -> Result<(Mesh, usize), MeshError> {
        self.vertices = HashMap::new();
        let mut mesh = Mesh { triangles: std::mem::take(&mut self.triangles), ..Mesh::default() };
        for corner in &self.corners {
            push(&mut mesh.positions, self.attributes.positions[corner[0] as usize])?;
            if let Some(&color) = self.attributes.colors.get(corner[0] as usize) {
                push(&mut mesh.colors, color)?;
            }
        }
        self.set_normals(&mut mesh)?;
        self.set_uvs(&mut mesh)?;
        Ok((mesh, self.flat))
    }

    /// The file's normals. Faces without are smoothed as if they were a mesh of their own.
    fn set_normals(&self, mesh: &mut Mesh) -> Result<(), MeshError> {
        if !self.keep_normals {
            return Ok(());
        }
        let has_none = |vertex: u32| self.corners[vertex as usize][2] == NONE;
        mesh.smooth_where(|triangle| has_none(triangle[0]))?;
        for (normal, corner) in mesh.normals.iter_mut().zip(&self.corners) {
            if corner[2] != NONE {
                *normal = self.attributes.normals[corner[2] as usize];
            }
        }
        Ok(())
    }

    /// The file's surface coordinates. The corners of a triangle without them have (0, 0), (1, 0)
    /// and (0, 1), which makes barycentric weights of what lies between: just what a mesh has where
    /// no face has any.
    fn set_uvs(&self, mesh: &mut Mesh) -> Result<(), MeshError> {
        if self.corners.iter().all(|corner| corner[1] == NONE) {
            return Ok(());
        }
        // Not a number: not known yet.
        for corner in &self.corners {
            let uv = match corner[1] {
                NONE => [f32::NAN; 2],
                index => self.attributes.uvs[index as usize],
            };
            push(&mut mesh.uvs, uv)?;
        }
        for at in 0..mesh.triangles.len() {
            for (corner, uv) in [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].into_iter().enumerate() {
                let vertex = mesh.triangles[at][corner] as usize;
                if self.corners.get(vertex).is_none_or(|corner| corner[1] != NONE) {
                    break;
                }
                if mesh.uvs[vertex][0].is_nan() {
                    mesh.uvs[vertex] = uv;
                } else if mesh.uvs[vertex] != uv {
                    // The vertex is another corner of another triangle.
                    let position = mesh.positions[vertex];
                    mesh.triangles[at][corner] = mesh.positions.len() as u32;
                    push(&mut mesh.positions, position)?;
                    push(&mut mesh.uvs, uv)?;
                    if let Some(&normal) = mesh.normals.get(vertex) {
                        push(&mut mesh.normals, normal)?;
                    }
                    if let Some(&color) = mesh.colors.get(vertex) {
                        push(&mut mesh.colors, color)?;
                    }
                }
            }
        }
        Ok(())
    }
}

/// A whole number; past 64 bits, the nearest there is.
fn index(part: &[u8]) -> Option<i64> {
    let (digits, sign) = match part {
        [b'-', digits @ ..] => (digits, -1),
        [b'+', digits @ ..] => (digits, 1),
        digits => (digits, 1),
    };
    if digits.is_empty() || !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    let append =
        |number: i64, digit: &u8| number.saturating_mul(10).saturating_add((digit - b'0').into());
    Some(sign * digits.iter().fold(0, append))
}
