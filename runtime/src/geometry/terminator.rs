//! Where the shadow ray of a smoothly shaded facet starts.
//!
//! A coarse mesh shaded with interpolated normals looks round, but its facets shadow themselves:
//! where light grazes the round surface, a facet turns away from the light all at once, and the
//! edge of the shadow shows the facets. Hanika (Hacking the Shadow Terminator, Ray Tracing Gems II,
//! 2021, chapter 4) starts the ray on the round surface instead: the point is put on the tangent
//! plane of each vertex, where it lies below it, and the three are mixed by its barycentric weights.

use glam::DVec3;

use super::barycentric::weights;
use super::mesh::Mesh;
use super::vector::double;

/// Where the edge of a smoothly shaded mesh's own shadow runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ShadowTerminator {
    /// As on the round surface that its normals describe.
    #[default]
    Smooth,
    /// As on its triangles.
    Facets,
}

impl Mesh {
    /// The point of triangle `number` lifted onto the round surface, on the outer side or, seen from
    /// `inside`, on the inner; as it is where the mesh has no normals or the point is none of the
    /// triangle.
    pub(crate) fn lifted(&self, number: u32, point: DVec3, inside: bool) -> DVec3 {
        let triangle = self.triangles.get(number as usize);
        let (Some(indices), false) = (triangle, self.normals.is_empty()) else { return point };
        let corners = indices.map(|vertex| double(self.positions[vertex as usize]));
        let Some(weights) = weights(corners, point) else { return point };
        let turn = if inside { -1.0 } else { 1.0 };
        let mut lift = DVec3::ZERO;
        for at in 0..3 {
            let normal = double(self.normals[indices[at] as usize]) * turn;
            let below = (point - corners[at]).dot(normal).min(0.0);
            lift -= normal * (below * weights[at]);
        }
        point + lift
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An eighth of the unit sphere, as one facet.
    fn facet() -> Mesh {
        let corners = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let normals = corners.clone();
        Mesh { positions: corners, normals, triangles: vec![[0, 1, 2]], ..Mesh::default() }
    }

    #[test]
    fn points_of_a_convex_facet_are_lifted_towards_the_sphere() {
        let middle = DVec3::splat(1.0 / 3.0);
        let lifted = facet().lifted(0, middle, false);
        assert!(lifted.length() > 0.9 && lifted.length() < 1.1, "{lifted}");
        assert!((lifted.normalize() - middle.normalize()).length() < 1e-12);
        // A corner lies on the sphere already, and from inside the surface is hollow.
        assert_eq!(facet().lifted(0, DVec3::X, false), DVec3::X);
        assert_eq!(facet().lifted(0, middle, true), middle);
    }

    #[test]
    fn points_of_other_places_flat_meshes_and_slivers_stay() {
        let elsewhere = DVec3::new(2.0, 2.0, 2.0);
        assert_eq!(facet().lifted(0, elsewhere, false), elsewhere);
        let middle = DVec3::splat(1.0 / 3.0);
        assert_eq!(facet().lifted(7, middle, false), middle);
        let flat = Mesh { normals: Vec::new(), ..facet() };
        assert_eq!(flat.lifted(0, middle, false), middle);
        let mut sliver = facet();
        sliver.positions[2] = [0.5, 0.5, 0.0];
        let middle = DVec3::new(0.5, 0.5, 0.0);
        assert_eq!(sliver.lifted(0, middle, false), middle);
    }
}
