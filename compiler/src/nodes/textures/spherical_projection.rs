use crate::emit::functions::placing::{latitude, longitude, place};
use crate::nodes::finite::SUMMAND;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Wraps a picture round a point, as a sphere has it: its middle faces +z, its left and right edge meet at
    /// -z, the lower edge is straight down (-y). Seen from outside it stands upright and is not mirrored. A
    /// position is as good as any on the ray to it from the centre, a direction as a position; the centre itself is
    /// the middle.
    spherical_projection in textures,
    source "mental ray base shaders, mib_texture_vector: spherical projection",
    inputs {
        /// What the picture falls on.
        position: vector = state(Field::Point), in SUMMAND;
        /// What it is wrapped round.
        center: vector = [0.0; 3], in SUMMAND;
    }
    outputs {
        /// Where to read, as a vector whose z is 0.
        uv: vector, in 0.0..=1.0;
        /// Turns round the y axis.
        u: scalar, in 0.0..=1.0;
        /// Half turns from straight down.
        v: scalar, in 0.0..=1.0;
    }
    body |e, i| {
        let from = i.position - i.center;
        let uv = place(longitude(from.x, from.z), latitude(from));
        Outputs { uv, u: uv.x, v: uv.y }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn the_middle_faces_z_and_up_is_up() {
        assert_eq!(numbers!(position = [0.0, 0.0, 2.0] => uv), [0.5, 0.5, 0.0]);
        assert_close(&numbers!(position = [3.0, 0.0, 0.0] => uv), &[0.75, 0.5, 0.0], 1e-6, 0.0);
        assert_close(
            &numbers!(position = [1.0, 5.0, 3.0], center = [1.0, 1.0, 3.0] => uv),
            &[0.5, 1.0, 0.0],
            1e-6,
            0.0,
        );
        assert_eq!(numbers!(position = [0.0, -1e-45, 0.0] => uv)[1], 0.0);
        let down = std::f32::consts::FRAC_1_SQRT_2;
        assert_close(
            &numbers!(position = [0.0, -down, -down] => uv),
            &[1.0, 0.25, 0.0],
            1e-6,
            1e-6,
        );
    }

    /// A step of 2^-12 from the pole is 2^-12 radians, which an arc cosine would lose.
    #[test]
    fn digits_are_kept_at_the_poles() {
        let step = 2.0_f32.powi(-12);
        let v = number!(position = [step, -1.0, 0.0] => v);
        assert!((v * std::f32::consts::PI / step - 1.0).abs() < 5e-4, "{v:e}");
    }

    #[test]
    fn no_direction_is_the_middle_and_nothing_overflows() {
        assert_eq!(
            numbers!(position = [1.0, -2.0, 3.0], center = [1.0, -2.0, 3.0] => uv),
            [0.5, 0.5, 0.0]
        );
        let far = numbers!(position = [1.7e38, 1.7e38, 0.0], center = [-1.7e38, 0.0, 0.0] => uv);
        assert!(far.iter().all(|x| (0.0..=1.0).contains(x)), "{far:?}");
    }
}
