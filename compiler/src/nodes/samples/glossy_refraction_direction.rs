use crate::emit::Real;
use crate::nodes::finite::UNIT;
use crate::nodes::rays::refraction_direction::refracted;
use crate::nodes::samples::glossy_reflection_direction::facet;
use crate::nodes::{node, state};
use crate::state::Field;

node! {
    /// A direction in which a rough boundary refracts: that of `refraction_direction` on one of its facets, drawn
    /// as in `glossy_reflection_direction`. Under total internal reflection it is that facet's mirror
    /// direction.
    glossy_refraction_direction in samples,
    source "mental ray manual, mi_refraction_dir_glossy and mi_refraction_dir_anisglossy; Walter et al. 2007",
    inputs {
        /// Roughness along the tangent: the deviation of the slopes of the facets. 0 is a mirror; mental ray's
        /// `shiny` is `1 / roughness`.
        roughness_u: scalar = 0.1, in 0.0..=10.0, soft UNIT;
        /// Roughness across the tangent.
        roughness_v: scalar = 0.1, in 0.0..=10.0, soft UNIT;
        /// Direction of the first roughness; by default along u.
        tangent: vector = node("frame_from_derivatives"), when i.roughness_u.not_equal(i.roughness_v);
        /// Index of refraction on the side the ray comes from.
        ior_in: scalar = 1.0, in 0.0..=100.0, soft 1.0..=2.5;
        /// Index of refraction beyond the boundary.
        ior_out: scalar = 1.5, in 0.0..=100.0, soft 1.0..=2.5;
        /// Direction towards the surface, unit length.
        direction: vector = state(Field::Direction), in -1.0..=1.0;
        /// Shading normal, unit length, on the side the ray comes from.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Geometric normal, unit length, on the side the ray comes from.
        normal_geom: vector = state(Field::NormalGeom), in -1.0..=1.0;
        /// First number drawn, 0 to 1.
        u: scalar = state(Field::SampleU), in UNIT;
        /// Second number drawn, 0 to 1.
        v: scalar = state(Field::SampleV), in UNIT;
    }
    outputs {
        /// Unit direction of the refracted or totally reflected ray.
        direction: vector, in -1.0..=1.0;
        /// Whether all light is reflected there.
        tir: boolean;
    }
    body |e, i| {
        let roughness = [i.roughness_u, i.roughness_v];
        let facet = facet(e, roughness, i.tangent, i.direction, i.normal, [i.u, i.v]);
        let (direction, tir) =
            refracted(e, [i.ior_in, i.ior_out], i.direction, facet, i.normal_geom);
        Outputs { direction, tir }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    const UP: [f32; 3] = [0.0, 0.0, 1.0];

    #[test]
    fn without_roughness_it_is_snells_direction() {
        let slanted = [0.644_217_7, 0.0, -0.764_842_2];
        let to = numbers!(roughness_u = 0.0, roughness_v = 0.0, direction = slanted, normal = UP, u = 0.7, v = 0.3 => direction);
        assert_close(&to, &[0.42947845815846064, 0.0, -0.9030771030082821], 4e-7, 1e-7);
    }

    #[test]
    fn it_stays_below_the_surface_unless_all_is_reflected() {
        for at in 0..256 {
            let (u, v) = ((at % 16) as f32 / 15.0, (at / 16) as f32 / 16.0);
            for (ior_in, ior_out) in [(1.0, 1.5), (1.5, 1.0)] {
                let direction = [0.6, 0.0, -0.8];
                let to = numbers!(roughness_u = 0.4, roughness_v = 0.4, ior_in = ior_in, ior_out = ior_out, direction = direction, normal = UP, normal_geom = UP, u = u, v = v => direction);
                let tir = truth!(roughness_u = 0.4, roughness_v = 0.4, ior_in = ior_in, ior_out = ior_out, direction = direction, normal = UP, normal_geom = UP, u = u, v = v => tir);
                assert_eq!(to[2] > 0.0, tir, "{to:?}");
            }
        }
    }
}
