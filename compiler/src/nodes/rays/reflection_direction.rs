use crate::emit::{Emit, Mask, Real, Vector};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Mirror direction `d - 2 (d·n) n`. Where a bent normal would send it below the geometric
    /// surface, it is lifted to graze the surface instead.
    reflection_direction in rays,
    source "mental ray manual, mi_reflection_dir",
    inputs {
        /// Direction towards the surface, unit length.
        direction: vector = state(Field::Direction), in -1.0..=1.0;
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Geometric normal, unit length.
        normal_geom: vector = state(Field::NormalGeom), in -1.0..=1.0;
    }
    outputs {
        /// Unit direction of the mirrored ray.
        direction: vector, in -1.0..=1.0;
    }
    body |e, i| Outputs { direction: mirrored(e, i.direction, i.normal, i.normal_geom) }
}

/// The mirror direction, held above the geometric surface.
#[inline(always)]
pub fn mirrored<E: Emit>(
    e: E,
    direction: Vector<E::Real>,
    normal: Vector<E::Real>,
    normal_geom: Vector<E::Real>,
) -> Vector<E::Real> {
    let mirrored = along(normal, direction.dot(normal) * -2.0, direction);
    let above = mirrored.dot(normal_geom);
    let lifted = along(normal_geom, e.real(1e-4) - above, mirrored);
    above.less_equal(e.real(0.0)).select(lifted, mirrored).normalized()
}

/// `start + axis * distance`, each component rounded once.
#[inline(always)]
pub fn along<R: Real>(axis: Vector<R>, distance: R, start: Vector<R>) -> Vector<R> {
    Vector {
        x: axis.x.mul_add(distance, start.x),
        y: axis.y.mul_add(distance, start.y),
        z: axis.z.mul_add(distance, start.z),
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    const UP: [f32; 3] = [0.0, 0.0, 1.0];

    #[test]
    fn mirrors_a_known_ray() {
        let direction = [0.644_217_7, 0.0, -0.764_842_2];
        let mirrored = numbers!(direction = direction, normal = UP => direction);
        assert_close(&mirrored, &[0.644217687237691, 0.0, 0.7648421872844885], 2e-7, 0.0);
    }

    #[test]
    fn comes_straight_back() {
        assert_eq!(numbers!(=> direction), UP);
    }

    #[test]
    fn a_bent_normal_cannot_send_it_below_the_surface() {
        let normal = [0.0, 0.8, 0.6];
        let direction = [0.0, -0.6, -0.8];
        let bent = numbers!(direction = direction, normal = normal, normal_geom = UP => direction);
        assert!(bent[2] > 0.0, "{bent:?}");
        let grazing = [0.0, 0.98, -0.199];
        let bent =
            numbers!(direction = grazing, normal = [0.0, 0.6, 0.8], normal_geom = UP => direction);
        assert!(bent[2] > 0.0 && bent[2] < 1e-3, "{bent:?}");
    }

    #[test]
    fn a_ray_without_direction_leaves_along_the_normal() {
        assert_eq!(numbers!(direction = [0.0; 3], normal = UP => direction), UP);
        assert_eq!(
            numbers!(direction = [0.0; 3], normal = [0.0; 3], normal_geom = [0.0; 3] => direction),
            [0.0; 3]
        );
    }
}
