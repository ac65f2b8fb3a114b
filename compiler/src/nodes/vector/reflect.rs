use crate::emit::Components;
use crate::nodes::finite::CUBED;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// A direction mirrored at a plane: `input - 2 (input . normal) normal`, as GLSL, OSL and
    /// MaterialX have it: the normal must have length 1, and the input points towards the
    /// plane. `reflection_direction` does it for the ray and keeps it above the surface.
    reflect in vector,
    source "",
    inputs {
        /// What is mirrored.
        input: vector = state(Field::Direction), in CUBED;
        /// Unit normal of the plane; its side does not matter.
        normal: vector = state(Field::Normal), in CUBED;
    }
    outputs {
        /// The mirrored direction.
        result: vector;
    }
    body |e, i| Outputs { result: i.normal.mul_add(i.input.dot(i.normal) * -2.0, i.input) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn turns_what_goes_into_the_plane() {
        let mirrored = numbers!(input = [0.6, 0.0, -0.8], normal = [0.0, 0.0, 1.0] => result);
        assert_eq!(mirrored, [0.6, 0.0, 0.8]);
        let other_side = numbers!(input = [0.6, 0.0, -0.8], normal = [0.0, 0.0, -1.0] => result);
        assert_eq!(other_side, mirrored);
    }
}
