use super::reflection_direction::{along, mirrored};
use crate::emit::{Emit, Mask, Real, Vector};
use crate::nodes::fresnel::fresnel_dielectric::{boundary, index};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Direction of the ray behind the boundary, by Snell's law; under total internal reflection the
    /// mirror direction.
    ///
    /// In units of the incident index, with `D` and `g` of `fresnel_dielectric`:
    /// `d - n D / (g + c)`, made unit length. Written so, nothing cancels where the indices nearly
    /// match; equal ones pass the ray on to the bit. Where a bent normal would send it back above
    /// the geometric surface, it grazes the surface from below instead.
    refraction_direction in rays,
    source "mental ray manual, mi_refraction_dir",
    inputs {
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
    }
    outputs {
        /// Unit direction of the refracted or totally reflected ray.
        direction: vector, in -1.0..=1.0;
        /// Whether all light is reflected.
        tir: boolean;
    }
    body |e, i| {
        let (direction, tir) =
            refracted(e, [i.ior_in, i.ior_out], i.direction, i.normal, i.normal_geom);
        Outputs { direction, tir }
    }
}

/// The direction behind the boundary, held below the geometric surface, or the mirror direction; and
/// whether all light is reflected.
#[inline(always)]
pub fn refracted<E: Emit>(
    e: E,
    [ior_in, ior_out]: [E::Real; 2],
    direction: Vector<E::Real>,
    normal: Vector<E::Real>,
    normal_geom: Vector<E::Real>,
) -> (Vector<E::Real>, E::Mask) {
    let cosine = -direction.dot(normal);
    let b = boundary(e, index(e, ior_in), index(e, ior_out), cosine);
    let bend = -(b.excess.divide_or_zero(b.transmitted + b.cosine));
    let refracted = along(normal, bend, direction);
    let above = refracted.dot(normal_geom);
    let lowered = along(normal_geom, e.real(-1e-4) - above, refracted);
    let refracted = above.greater_equal(e.real(0.0)).select(lowered, refracted).normalized();
    let unbent = b.matched.select(direction, refracted);
    let mirror = mirrored(e, direction, normal, normal_geom);
    (b.total.select(mirror, unbent), b.total)
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const SLANTED: [f32; 3] = [0.644_217_7, 0.0, -0.764_842_2];

    #[test]
    fn air_to_glass() {
        let bent =
            numbers!(ior_in = 1.0, ior_out = 1.5, direction = SLANTED, normal = UP => direction);
        assert_close(&bent, &[0.42947845815846064, 0.0, -0.9030771030082821], 3e-7, 0.0);
        assert!(!truth!(ior_in = 1.0, ior_out = 1.5, direction = SLANTED, normal = UP => tir));
    }

    #[test]
    fn equal_indices_pass_the_ray_to_the_bit() {
        for direction in [SLANTED, [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]] {
            assert_eq!(
                numbers!(ior_in = 1.5, ior_out = 1.5, direction = direction, normal = UP => direction),
                direction
            );
            assert!(
                !truth!(ior_in = 1.5, ior_out = 1.5, direction = direction, normal = UP => tir)
            );
        }
    }

    #[test]
    fn glass_to_air_reflects_beyond_the_critical_angle() {
        let steep = [0.717_356_1, 0.0, -0.696_706_7];
        assert!(truth!(ior_in = 1.5, ior_out = 1.0, direction = steep, normal = UP => tir));
        let mirror =
            numbers!(ior_in = 1.5, ior_out = 1.0, direction = steep, normal = UP => direction);
        assert_close(&mirror, &[0.7173560908995228, 0.0, 0.6967067093471654], 3e-7, 0.0);
    }

    #[test]
    fn straight_through_at_normal_incidence() {
        let down = [0.0, 0.0, -1.0];
        assert_eq!(
            numbers!(ior_in = 1.0, ior_out = 2.42, direction = down, normal = UP => direction),
            down
        );
    }

    #[test]
    fn leaving_undoes_entering() {
        for k in 1..100 {
            let angle = k as f32 * 0.0157;
            let direction = [angle.sin(), 0.0, -angle.cos()];
            let inside = numbers!(ior_in = 1.0, ior_out = 1.5, direction = direction, normal = UP => direction);
            let inside = [inside[0], inside[1], inside[2]];
            let outside =
                numbers!(ior_in = 1.5, ior_out = 1.0, direction = inside, normal = UP => direction);
            assert_close(&outside, &direction.map(f64::from), 0.0, 3e-5);
        }
    }

    #[test]
    fn a_bent_normal_cannot_send_it_above_the_surface() {
        let normal = [0.866_025_4, 0.0, 0.5];
        let bent = numbers!(ior_in = 1.5, ior_out = 1.0, direction = [-0.5, 0.0, -0.05], normal = normal, normal_geom = UP => direction);
        assert!(
            bent[2] < 0.0
                || truth!(ior_in = 1.5, ior_out = 1.0, direction = [-0.5, 0.0, -0.05], normal = normal, normal_geom = UP => tir),
            "{bent:?}"
        );
    }
}
