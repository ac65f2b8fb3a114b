//! What shaders look up of the surfaces of a scene: worked out from the note on the hit, and only where a
//! graph reads it.

use glam::DVec3;
use phenomenon_compiler::state::{Footprint, Hit, State, Surface, Surfaces};

use super::build::Scene;
use crate::geometry::{Mesh, Shape, double, footprint, single};

impl Scene {
    /// The mesh a point is on, and the number of its triangle.
    fn mesh_of(&self, state: &State) -> Option<(&Mesh, u32)> {
        let Shape::Mesh(mesh) = &self.objects.get(state.hit.instance as usize)?.shape else {
            return None;
        };
        let number = state.hit.primitive;
        ((number as usize) < mesh.triangles.len()).then_some((&**mesh, number))
    }

    /// How much the normal of a surface turns along it, for each unit of length, seen from outside. Of meshes it is taken
    /// for nothing.
    pub(crate) fn curvature(&self, hit: &Hit) -> f32 {
        match self.objects.get(hit.instance as usize).map(|object| &object.shape) {
            Some(Shape::Sphere(sphere)) => 1.0 / sphere.radius,
            _ => 0.0,
        }
    }

    /// How a point moves with its coordinates; not at all where it is on no object.
    fn derivatives(&self, state: &State) -> [DVec3; 2] {
        let object = self.objects.get(state.hit.instance as usize);
        match (object.map(|object| &object.shape), self.mesh_of(state)) {
            (Some(Shape::Sphere(sphere)), _) => sphere.derivatives(DVec3::from(state.hit.position)),
            (_, Some((mesh, number))) => mesh.derivatives(number),
            _ => [DVec3::ZERO; 2],
        }
    }
}

impl Surfaces for Scene {
    fn derivative_u(&self, state: &State) -> [f32; 3] {
        single(self.derivatives(state)[0])
    }

    fn derivative_v(&self, state: &State) -> [f32; 3] {
        single(self.derivatives(state)[1])
    }

    fn vertex_color(&self, state: &State) -> [f32; 4] {
        let position = DVec3::from(state.hit.position);
        let of_mesh = |(mesh, number): (&Mesh, u32)| mesh.color(number, position);
        self.mesh_of(state).map_or(Surface::NONE.vertex_color, of_mesh)
    }

    fn second_uv(&self, state: &State) -> [f32; 2] {
        let position = DVec3::from(state.hit.position);
        let of_mesh = |(mesh, number): (&Mesh, u32)| mesh.second_uv(number, position);
        self.mesh_of(state).and_then(of_mesh).unwrap_or(state.uv)
    }

    fn footprint(&self, state: &State) -> Footprint {
        if self.objects.get(state.hit.instance as usize).is_none() {
            return Surface::NONE.footprint;
        }
        let (direction, normal) = (double(state.direction), double(state.normal_geom));
        footprint(direction, normal, self.derivatives(state), state.hit.cone.width.into())
    }
}
