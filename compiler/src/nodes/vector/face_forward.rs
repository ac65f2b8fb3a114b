use crate::emit::{Mask, Real};
use crate::nodes::finite::FACTOR;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// A vector turned to the side an incident direction comes from: `vector` where `incident .
    /// reference` is below zero, else its opposite. The normals of a `state` node face the ray
    /// already.
    face_forward in vector,
    source "RenderMan Interface Specification, faceforward",
    inputs {
        /// What is turned, mostly a normal.
        vector: vector = [0.0; 3];
        /// Direction towards the surface.
        incident: vector = state(Field::Direction), in FACTOR;
        /// What decides: the normal of the surface.
        reference: vector = state(Field::NormalGeom), in FACTOR;
    }
    outputs {
        /// The vector, or its opposite.
        result: vector;
    }
    body |e, i| {
        let faces = i.incident.dot(i.reference).less(e.real(0.0));
        Outputs { result: faces.select(i.vector, -i.vector) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn turns_to_the_side_of_the_ray() {
        let turned = |z: f32| {
            let (vector, reference) = ([1.0, 2.0, 3.0], [0.0, 0.0, 1.0]);
            numbers!(vector = vector, incident = [0.5, 0.0, z], reference = reference => result)
        };
        assert_eq!(turned(-1.0), [1.0, 2.0, 3.0]);
        assert_eq!(turned(1.0), [-1.0, -2.0, -3.0]);
    }
}
