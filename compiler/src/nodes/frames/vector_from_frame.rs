use crate::emit::functions::frames::Frame;
use crate::nodes::finite::FACTOR;
use crate::nodes::{node, state};
use crate::state::Field;

node! {
    /// A vector whose components along a frame are given, in the space of the scene:
    /// `x tangent + y (normal × tangent) + z normal`.
    vector_from_frame in frames,
    source "mental ray manual, mi_vector_from_object, for the frame of a surface",
    inputs {
        /// The components along tangent, bitangent and normal.
        vector: vector = [0.0, 0.0, 1.0], in FACTOR;
        /// First axis of the frame, unit length; by default along u.
        tangent: vector = node("frame_from_derivatives"), in -1.0..=1.0;
        /// Last axis of the frame, unit length and at right angles to the first.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
    }
    outputs {
        /// The vector.
        result: vector;
    }
    body |e, i| Outputs { result: Frame::square(i.normal, i.tangent).world(i.vector) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_axes_are_those_of_the_frame() {
        let (tangent, normal) = ([0.0, 1.0, 0.0], [1.0, 0.0, 0.0]);
        let vector =
            numbers!(vector = [2.0, 3.0, 5.0], tangent = tangent, normal = normal => result);
        assert_eq!(vector, [5.0, 2.0, 3.0]);
    }
}
