use crate::emit::Mask;
use crate::emit::functions::bent_normal::{along_surface, facing_out, raised, slope};
use crate::nodes::{required, state};
use crate::state::Field;

node! {
    /// Evaluates `input` under the normal of a surface raised by a height: any graph will do, a noise or a texture. It
    /// is evaluated three times, here and a `step` further along u and along v, which the checker adds by
    /// `shifted_u` and `shifted_v`; see `bump_normal` for how the slopes bend the normal, and for the step. Heights
    /// are in scene units and rise outwards.
    bump in scopes scope [Normal, DotNd],
    source "Mikkelsen 2010, Bump Mapping Unparametrized Surfaces on the GPU; Blinn 1978, Simulation of Wrinkled \
            Surfaces; mental ray base shaders, mib_bump_map",
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
    scoped {
        /// What is evaluated under that normal.
        input: generic = required();
    }
    changes { normal: vector; dot_nd: scalar; }
    outputs {
        /// The value of `input` under that normal.
        result: generic;
    }
    body |e, i| {
        let along = along_surface(i.derivative_u, i.derivative_v, i.normal);
        let upwards = i.inside.select(-i.scale, i.scale);
        let slope_u = slope([i.height, i.height_u], i.step, upwards);
        let slope_v = slope([i.height, i.height_v], i.step, upwards);
        let bent = raised([along.across, along.up], [slope_u, slope_v], i.normal);
        let normal = facing_out(bent, i.direction, i.normal_geom);
        Changes { normal, dot_nd: normal.dot(i.direction) }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::{assert_close, changed};
    use crate::values::Literal;

    #[test]
    fn the_product_with_the_ray_is_that_of_the_bent_normal() {
        let given = [
            ("direction", Literal::Vector([0.0, 0.0, -1.0])),
            ("step", Literal::Scalar(0.5)),
            ("height_u", Literal::Scalar(0.375)),
        ];
        assert_close(&changed(&super::definition(), &given), &[-0.6, 0.0, 0.8, -0.8], 1e-6, 1e-6);
    }
}
