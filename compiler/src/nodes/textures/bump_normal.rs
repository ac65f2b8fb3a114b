use crate::emit::Mask;
use crate::emit::functions::bent_normal::{along_surface, facing_out, raised, slope};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// The normal of a surface raised by a height: from the slopes between `height` and the same graph a `step`
    /// further along u and along v. These the checker adds by `shifted_u` and `shifted_v` where only `height` is
    /// given. Heights are in scene units and rise outwards, also where the surface is seen from inside; a `scale`
    /// below 0 makes dents of bumps. With unit vectors a and b along the surface and d = a · (b × n) it is
    /// `|d| n - sign(d) (slope_u b × n + slope_v n × a)`, which holds for slanted coordinates too.
    ///
    /// The step should be as long as the finest detail, or a pixel of the texture: of shorter ones 32 bits keep
    /// too few digits of the difference, longer ones blur. A normal bent so far that a mirror would throw rays
    /// below the geometric surface is bent less. `bump` evaluates a graph under such a normal. MaterialX's
    /// `bump` takes the slopes between pixels of the image.
    bump_normal in textures,
    source "Mikkelsen 2010, Bump Mapping Unparametrized Surfaces on the GPU; Blinn 1978, Simulation of Wrinkled \
            Surfaces; mental ray base shaders, mib_bump_map; MaterialX 1.39, bump",
    inputs {
        /// How far the surface is raised here.
        height: scalar = 0.0, unit "scene units";
        /// Factor on heights.
        scale: scalar = 1.0, in -1e6..=1e6, soft 0.0..=10.0;
        /// Distance over which slopes are taken.
        step: scalar = 0.001, in 1e-6..=1e6, unit "scene units", soft 0.0001..=0.1;
        /// How the point moves with u, of any length.
        derivative_u: vector = state(Field::DerivativeU);
        /// How the point moves with v, of any length.
        derivative_v: vector = state(Field::DerivativeV);
        /// The normal outside.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Geometric normal.
        normal_geom: vector = state(Field::NormalGeom), in -1.0..=1.0;
        /// Direction of the ray.
        direction: vector = state(Field::Direction), in -1.0..=1.0;
        /// Whether the surface was hit from inside: the normal is turned.
        inside: boolean = state(Field::InvNormal);
        /// How far the surface is raised a step along u.
        height_u: scalar = 0.0, under ("shifted_u", "height");
        /// How far the surface is raised a step along v.
        height_v: scalar = 0.0, under ("shifted_v", "height");
    }
    outputs {
        /// The bent normal, of unit length.
        normal: vector, in -1.0..=1.0;
    }
    body |e, i| {
        let along = along_surface(i.derivative_u, i.derivative_v, i.normal);
        let upwards = i.inside.select(-i.scale, i.scale);
        let slope_u = slope([i.height, i.height_u], i.step, upwards);
        let slope_v = slope([i.height, i.height_v], i.step, upwards);
        let bent = raised([along.across, along.up], [slope_u, slope_v], i.normal);
        let normal = facing_out(bent, i.direction, i.normal_geom);
        Outputs { normal }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn a_ramp_leans_against_its_rise() {
        let flat =
            numbers!(direction = DOWN, height = 3.0, height_u = 3.0, height_v = 3.0 => normal);
        assert_eq!(flat, [0.0, 0.0, 1.0]);
        // Three up on four along: the normal is (-3, 0, 4) / 5.
        let ramp = numbers!(direction = DOWN, step = 0.5, height_u = 0.375 => normal);
        assert_close(&ramp, &[-0.6, 0.0, 0.8], 1e-6, 1e-6);
        let ramp = numbers!(direction = DOWN, step = 0.5, height_v = 0.375 => normal);
        assert_close(&ramp, &[0.0, -0.6, 0.8], 1e-6, 1e-6);
        let dent = numbers!(direction = DOWN, step = 0.5, scale = -1.0, height_v = 0.375 => normal);
        assert_close(&dent, &[0.0, 0.6, 0.8], 1e-6, 1e-6);
    }

    #[test]
    fn slanted_and_mirrored_coordinates_give_the_same_plane() {
        // The height x / 4, seen along (1, 0), (1, 1) and (1, -1).
        let (half, diagonal) = (std::f32::consts::FRAC_1_SQRT_2, [2.0, 2.0, 0.0]);
        let expected = [-0.242_535_63, 0.0, 0.970_142_5];
        for (v, height_v) in [(diagonal, 0.25 * half), ([1.0, -1.0, 0.0], 0.25 * half)] {
            let normal = numbers!(
                direction = DOWN, step = 1.0, derivative_u = [9.0, 0.0, 0.0], derivative_v = v,
                height_u = 0.25, height_v = height_v => normal
            );
            assert_close(&normal, &expected, 1e-6, 1e-6);
        }
    }

    #[test]
    fn from_inside_the_surface_is_the_same() {
        let below = numbers!(
            direction = [0.0, 0.0, 1.0], normal = DOWN, normal_geom = DOWN, inside = true,
            step = 0.5, height_u = 0.375 => normal
        );
        assert_close(&below, &[0.6, 0.0, -0.8], 1e-6, 1e-6);
    }

    #[test]
    fn steep_slopes_still_face_the_ray() {
        for height in [1e3, -1e3, 1e38, f32::INFINITY, f32::NAN] {
            let direction = [0.6, 0.0, -0.8];
            let normal =
                numbers!(direction = direction, height_u = height, height_v = -height => normal);
            let dot: f32 = normal.iter().zip(direction).map(|(a, b)| a * b).sum();
            assert!(dot <= 1e-6 && normal[2] > 0.0, "{height}: {normal:?}");
        }
    }
}
