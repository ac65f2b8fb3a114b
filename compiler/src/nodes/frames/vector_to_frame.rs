use crate::emit::Vector;
use crate::nodes::finite::FACTOR;
use crate::nodes::{node, state};
use crate::state::Field;

node! {
    /// The components of a vector along a frame: its products with the tangent, with `normal × tangent`,
    /// and with the normal.
    vector_to_frame in frames,
    source "mental ray manual, mi_vector_to_object, for the frame of a surface",
    inputs {
        /// The vector.
        vector: vector = [0.0, 0.0, 1.0], in FACTOR;
        /// First axis of the frame, unit length; by default along u.
        tangent: vector = node("frame_from_derivatives"), in -1.0..=1.0;
        /// Last axis of the frame, unit length and at right angles to the first.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
    }
    outputs {
        /// Its components along tangent, bitangent and normal.
        result: vector;
    }
    body |e, i| Outputs {
        result: Vector {
            x: i.vector.dot(i.tangent),
            y: i.vector.dot(i.normal.cross(i.tangent)),
            z: i.vector.dot(i.normal),
        },
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_components_are_those_along_the_frame() {
        let (tangent, normal) = ([0.0, 1.0, 0.0], [1.0, 0.0, 0.0]);
        let found =
            numbers!(vector = [5.0, 2.0, 3.0], tangent = tangent, normal = normal => result);
        assert_eq!(found, [2.0, 3.0, 5.0]);
    }
}
