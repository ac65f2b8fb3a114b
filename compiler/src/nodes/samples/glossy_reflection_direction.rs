use std::f64::consts::TAU;

use crate::emit::functions::conventions::sqrt_or_zero;
use crate::emit::functions::frames::{Frame, any_tangent, tangent_along};
use crate::emit::{Emit, Mask, Real, Vector};
use crate::nodes::finite::UNIT;
use crate::nodes::rays::reflection_direction::mirrored;
use crate::nodes::{node, state};
use crate::state::Field;

node! {
    /// A direction in which a rough surface reflects: that of a mirror on one of its facets, drawn as Ward's
    /// model has them. Their slopes are `roughness sqrt(-ln(1 - u))` long, which is taken as
    /// `log1p(-u)`, and turned by v. A facet that looks away from the ray counts as the surface itself, and what would
    /// go below the geometric surface grazes it, as in `reflection_direction`. The tangent is evaluated only
    /// where the two roughnesses differ.
    glossy_reflection_direction in samples,
    source "mental ray manual, mi_reflection_dir_glossy and mi_reflection_dir_anisglossy; Ward 1992",
    inputs {
        /// Roughness along the tangent: the deviation of the slopes of the facets. 0 is a mirror; mental ray's
        /// `shiny` is `1 / roughness`.
        roughness_u: scalar = 0.1, in 0.0..=10.0, soft UNIT;
        /// Roughness across the tangent.
        roughness_v: scalar = 0.1, in 0.0..=10.0, soft UNIT;
        /// Direction of the first roughness; by default along u.
        tangent: vector = node("frame_from_derivatives"), when i.roughness_u.not_equal(i.roughness_v);
        /// Direction towards the surface, unit length.
        direction: vector = state(Field::Direction), in -1.0..=1.0;
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Geometric normal, unit length.
        normal_geom: vector = state(Field::NormalGeom), in -1.0..=1.0;
        /// First number drawn, 0 to 1.
        u: scalar = state(Field::SampleU), in UNIT;
        /// Second number drawn, 0 to 1.
        v: scalar = state(Field::SampleV), in UNIT;
    }
    outputs {
        /// Unit direction of the reflected ray.
        direction: vector, in -1.0..=1.0;
    }
    body |e, i| {
        let roughness = [i.roughness_u, i.roughness_v];
        let facet = facet(e, roughness, i.tangent, i.direction, i.normal, [i.u, i.v]);
        Outputs { direction: mirrored(e, i.direction, facet, i.normal_geom) }
    }
}

/// The unit normal of a facet of a rough surface, on the side the ray comes from. The tangent counts only
/// where the two roughnesses differ.
#[inline(always)]
pub fn facet<E: Emit>(
    e: E,
    [along, across]: [E::Real; 2],
    tangent: Vector<E::Real>,
    direction: Vector<E::Real>,
    normal: Vector<E::Real>,
    [u, v]: [E::Real; 2],
) -> Vector<E::Real> {
    let unit = normal.normalized();
    let differ = along.not_equal(across);
    let tangent = differ.select(tangent_along(tangent, unit), any_tangent(unit));
    // At 1 the logarithm would be infinite.
    let u = u.saturate().minimum(e.real(1.0 - f64::from(f32::EPSILON) / 2.0));
    let (slope, turn) = (sqrt_or_zero(-((-u).log1p())), v.saturate() * TAU);
    let rough = |of: E::Real| of.clamp_to(e.real(0.0), e.real(1e3)) * slope;
    let local =
        Vector { x: rough(along) * turn.cos(), y: rough(across) * turn.sin(), z: e.real(1.0) };
    let facet = Frame::square(unit, tangent).world(local).normalized();
    facet.dot(direction).less(e.real(0.0)).select(facet, normal)
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const SLANTED: [f32; 3] = [0.6, 0.0, -0.8];

    #[test]
    fn without_roughness_it_is_the_mirror() {
        for (u, v) in [(0.0, 0.0), (0.5, 0.7), (1.0, 1.0)] {
            let to = numbers!(roughness_u = 0.0, roughness_v = 0.0, direction = SLANTED, normal = UP, u = u, v = v => direction);
            assert_close(&to, &[0.6, 0.0, 0.8], 3e-7, 1e-7);
        }
    }

    #[test]
    fn slopes_are_those_of_wards_lobe() {
        // Straight from above the facet's normal is half way to the reflected ray.
        let straight = [0.0, 0.0, -1.0];
        let u = 1.0 - (-1.0_f32).exp();
        for (v, slope) in [(0.0, [0.2, 0.0]), (0.25, [0.0, 0.5])] {
            let to = numbers!(roughness_u = 0.2, roughness_v = 0.5, tangent = [7.0, 0.0, 3.0], direction = straight, normal = UP, u = u, v = v => direction);
            let half = [to[0], to[1], to[2] + 1.0];
            assert_close(&[half[0] / half[2], half[1] / half[2]], &slope, 1e-6, 1e-7);
        }
    }

    #[test]
    fn it_never_goes_below_the_surface() {
        let grazing = [0.98, 0.0, -0.198_997_5];
        for at in 0..256 {
            let (u, v) = ((at % 16) as f32 / 15.0, (at / 16) as f32 / 16.0);
            let to = numbers!(roughness_u = 1.0, roughness_v = 1.0, direction = grazing, normal = UP, u = u, v = v => direction);
            let length: f32 = to.iter().map(|x| x * x).sum();
            assert!(to[2] > 0.0 && (length - 1.0).abs() < 1e-6, "{to:?}");
        }
    }

    #[test]
    fn the_tangent_counts_where_roughnesses_differ() {
        assert!(demanded!(roughness_u = 0.1, roughness_v = 0.2 => tangent));
        assert!(!demanded!(roughness_u = 0.1, roughness_v = 0.1 => tangent));
    }
}
