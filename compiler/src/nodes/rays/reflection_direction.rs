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
}

#[inline(always)]
fn body<E: Emit>(e: E, i: &Inputs<E>) -> Outputs<E> {
    let twice = i.direction.dot(i.normal) * -2.0;
    let mirrored = Vector {
        x: i.normal.x.mul_add(twice, i.direction.x),
        y: i.normal.y.mul_add(twice, i.direction.y),
        z: i.normal.z.mul_add(twice, i.direction.z),
    };
    let above = mirrored.dot(i.normal_geom);
    let lift = e.real(1e-4) - above;
    let lifted = Vector {
        x: i.normal_geom.x.mul_add(lift, mirrored.x),
        y: i.normal_geom.y.mul_add(lift, mirrored.y),
        z: i.normal_geom.z.mul_add(lift, mirrored.z),
    };
    let direction = above.less_equal(e.real(0.0)).select(lifted, mirrored).normalized();
    Outputs { direction }
}
