use crate::emit::Real;
use crate::emit::functions::placing::{longitude, place};
use crate::nodes::finite::SUMMAND;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Wraps a picture round an upright axis: `u` in turns as `spherical_projection` has it, with the middle at
    /// +z, and `v = (y - y of the centre) / height`. A height of 0 gives 0.
    cylindrical_projection in textures,
    source "mental ray base shaders, mib_texture_vector: cylindrical projection",
    inputs {
        /// What the picture falls on.
        position: vector = state(Field::Point), in SUMMAND;
        /// The point on the axis where the lower edge of the picture is.
        center: vector = [0.0; 3], in SUMMAND;
        /// Height of the picture, in the unit of the position.
        height: scalar = 1.0, in SUMMAND, avoid zero;
    }
    outputs {
        /// Where to read, as a vector whose z is 0.
        uv: vector;
        /// Turns round the axis.
        u: scalar, in 0.0..=1.0;
        /// Heights above the centre.
        v: scalar;
    }
    body |e, i| {
        let from = i.position - i.center;
        let uv = place(longitude(from.x, from.z), from.y.divide_or_zero(i.height));
        Outputs { uv, u: uv.x, v: uv.y }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn goes_round_and_up() {
        let (center, height) = ([1.0, 2.0, 3.0], 4.0);
        let at = |position: [f32; 3]| numbers!(position = position, center = center, height = height => uv);
        assert_eq!(at([1.0, 3.0, 7.0]), [0.5, 0.25, 0.0]);
        assert_close(&at([0.0, 6.0, 3.0]), &[0.25, 1.0, 0.0], 1e-6, 0.0);
        // On the axis, and below the picture.
        assert_eq!(at([1.0, -2.0, 3.0]), [0.5, -1.0, 0.0]);
    }

    #[test]
    fn a_height_of_nothing_is_finite() {
        for height in [0.0, 1e-45, -1e-45] {
            let uv = numbers!(position = [0.0, 1e38, 1.0], height = height => uv);
            assert!(uv.iter().all(|x| x.is_finite()), "{height}: {uv:?}");
        }
    }
}
