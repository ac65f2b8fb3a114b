use crate::emit::functions::placing::{latitude, longitude, place};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Where a picture of all directions by longitude and latitude shows a direction: as scenes have their
    /// environments, its middle is towards -z, +x to the right of it, its upper edge straight up (+y). It is
    /// seen from inside; `spherical_projection` is for what is looked at from outside. Read it `periodic` in u and
    /// `clamp` in v.
    ///
    /// MaterialX's `latlongimage` has its middle towards +z: `rotation` is then pi minus its own in radians.
    latlong_projection in textures,
    source "MaterialX 1.39, latlongimage; Debevec 1998, Rendering Synthetic Objects into Real Scenes",
    inputs {
        /// Direction of any length; none is the middle of the picture turned by half.
        direction: vector = state(Field::Direction);
        /// Angle by which the picture is turned about y: as the `rotation` of an environment.
        rotation: scalar = 0.0, in -1e5..=1e5, unit "radians", soft -3.2..=3.2;
    }
    outputs {
        /// Where to read, as a vector whose z is 0; `u` goes on past 0 and 1 where the picture is turned.
        uv: vector, in -2e4..=2e4;
        /// Turns round the y axis.
        u: scalar, in -2e4..=2e4;
        /// Half turns from straight down.
        v: scalar, in 0.0..=1.0;
    }
    body |e, i| {
        let turned = longitude(i.direction.x, -i.direction.z) - i.rotation / std::f64::consts::TAU;
        let uv = place(turned, latitude(i.direction));
        Outputs { uv, u: uv.x, v: uv.y }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn directions_are_where_environments_have_them() {
        assert_eq!(numbers!(direction = [0.0, 0.0, -3.0] => uv), [0.5, 0.5, 0.0]);
        assert_close(&numbers!(direction = [1.0, 0.0, 0.0] => uv), &[0.75, 0.5, 0.0], 1e-6, 0.0);
        assert_close(&numbers!(direction = [0.0, 1.0, 0.0] => uv), &[0.5, 1.0, 0.0], 1e-6, 0.0);
        let half = std::f32::consts::FRAC_1_SQRT_2;
        assert_close(&numbers!(direction = [0.0, half, -half] => uv), &[0.5, 0.75, 0.0], 1e-6, 0.0);
        let quarter = std::f32::consts::FRAC_PI_2;
        assert_close(
            &numbers!(direction = [1.0, 0.0, 0.0], rotation = quarter => uv),
            &[0.5, 0.5, 0.0],
            1e-6,
            0.0,
        );
    }

    /// By the definition of MaterialX: 0.5 - atan2(x, z) / 2 pi + rotation / 360, up to whole turns.
    #[test]
    fn half_a_turn_away_it_is_that_of_materialx() {
        for (direction, degrees) in [([0.3, -0.2, 0.8], 0.0), ([-0.7, 0.1, -0.6], 33.0_f32)] {
            let [x, _, z]: [f32; 3] = direction;
            let theirs = 0.5 - x.atan2(z) / std::f32::consts::TAU + degrees / 360.0;
            let rotation = std::f32::consts::PI - degrees.to_radians();
            let ours = number!(direction = direction, rotation = rotation => u);
            let apart = ours - theirs;
            assert!((apart - apart.round()).abs() < 1e-6, "{ours} {theirs}");
        }
    }

    #[test]
    fn no_direction_has_a_place() {
        assert_eq!(numbers!(direction = [0.0; 3] => uv)[1], 0.5);
        let hard = numbers!(direction = [f32::MAX, f32::MAX, -f32::MAX] => uv);
        assert!(hard.iter().all(|x| (0.0..=1.0).contains(x)), "{hard:?}");
    }
}
