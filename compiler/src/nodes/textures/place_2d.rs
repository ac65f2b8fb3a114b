use crate::emit::functions::conventions::clamp_finite;
use crate::emit::functions::placing::place;
use crate::emit::{Real, Vector};
use crate::nodes::finite::FACTOR;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Puts a picture elsewhere on a surface: larger, turned, shifted. It moves the coordinates at which the
    /// picture is read, so a `scale` of 2 shows it twice as large, `rotate` turns it counterclockwise,
    /// and an `offset` of 0.1 shifts it by 0.1 along the coordinate. To repeat it n times, scale by 1/n.
    ///
    /// With the order `scale_rotate_translate` it is `turned((p - pivot) / scale) - offset + pivot`, with
    /// `translate_rotate_scale` `turned(p - pivot - offset) / scale + pivot`, where `turned` is
    /// (u cos + v sin, v cos - u sin). Division by a scale of 0 gives 0. As MaterialX's `place2d`, whose
    /// `rotate` is in degrees.
    place_2d in textures,
    source "MaterialX 1.39, place2d",
    inputs {
        /// First coordinate.
        u: scalar = state(Field::U), in FACTOR;
        /// Second coordinate.
        v: scalar = state(Field::V), in FACTOR;
        /// What stays where it is while the picture is scaled and turned, in x and y.
        pivot: vector = [0.0; 3], in FACTOR;
        /// Size of the picture, in x and y.
        scale: vector = [1.0; 3], in FACTOR, avoid zero;
        /// Angle by which the picture is turned.
        rotate: scalar = 0.0, in -1e5..=1e5, unit "radians", soft -3.2..=3.2;
        /// By how much the picture is shifted, in x and y.
        offset: vector = [0.0; 3], in FACTOR;
        /// What is done first.
        order: choice = 0, of ["scale_rotate_translate", "translate_rotate_scale"];
    }
    outputs {
        /// Where to read, as a vector whose z is 0.
        uv: vector;
        /// Its first coordinate.
        u: scalar;
        /// Its second coordinate.
        v: scalar;
    }
    body |e, i| {
        let from = Vector { x: i.u, y: i.v, z: e.real(0.0) } - i.pivot;
        let moved = if i.order == 0 {
            turned(divided(from, i.scale), i.rotate) - i.offset
        } else {
            divided(turned(from - i.offset, i.rotate), i.scale)
        };
        let uv = place(moved.x + i.pivot.x, moved.y + i.pivot.y);
        Outputs { uv, u: uv.x, v: uv.y }
    }
}

#[inline(always)]
fn divided<R: Real>(place: Vector<R>, scale: Vector<R>) -> Vector<R> {
    Vector {
        x: clamp_finite(place.x.divide_or_zero(scale.x)),
        y: clamp_finite(place.y.divide_or_zero(scale.y)),
        z: place.z,
    }
}

#[inline(always)]
fn turned<R: Real>(place: Vector<R>, angle: R) -> Vector<R> {
    let (sine, cosine) = (angle.sin(), angle.cos());
    let (x, y) = (place.x, place.y);
    Vector {
        x: clamp_finite(cosine.mul_add(x, sine * y)),
        y: clamp_finite(cosine.mul_add(y, -(sine * x))),
        z: place.z,
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    /// Computed with MaterialX 1.39.5, its angles in degrees.
    #[test]
    fn places_as_materialx_does() {
        let placed = numbers!(
            u = 0.66926, v = -1.48319, pivot = [-1.79719, 2.55282, 0.0], scale = [1.31744, 1.08544, 1.0],
            rotate = 2.71149_f32.to_radians(), offset = [1.45259, -2.245, 0.0], order = 1 => uv
        );
        assert_close(&placed, &[-1.092_795_13, 0.860_449_076, 0.0], 1e-6, 1e-6);
        let placed = numbers!(
            u = 1.76866, v = 2.03845, pivot = [-2.40851, 0.289417, 0.0], scale = [-1.03504, 2.58693, 1.0],
            rotate = (-0.555911_f32).to_radians(), offset = [2.18735, 0.28278, 0.0], order = 1 => uv
        );
        assert_close(&placed, &[-4.317132, 0.863_645_792, 0.0], 1e-6, 1e-6);
    }

    #[test]
    fn the_orders_differ_and_by_default_nothing_moves() {
        assert_eq!(numbers!(u = 0.3, v = -0.7 => uv), [0.3, -0.7, 0.0]);
        let (scale, offset) = ([2.0, 4.0, 1.0], [0.5, 1.0, 0.0]);
        assert_eq!(
            numbers!(u = 3.0, v = 5.0, scale = scale, offset = offset => uv),
            [1.0, 0.25, 0.0]
        );
        assert_eq!(
            numbers!(u = 3.0, v = 5.0, scale = scale, offset = offset, order = 1 => uv),
            [1.25, 1.0, 0.0]
        );
        // A quarter turn brings the picture's right edge up.
        let quarter = std::f32::consts::FRAC_PI_2;
        assert_close(
            &numbers!(u = 0.0, v = 1.0, rotate = quarter => uv),
            &[1.0, 0.0, 0.0],
            0.0,
            1e-6,
        );
    }

    #[test]
    fn hard_places_are_finite() {
        for x in [0.0, -0.0, 1e-45, 1e19, -1e19] {
            for order in [0, 1] {
                let uv = numbers!(u = 1e19, v = -1e19, scale = [x, -x, x], rotate = 1e5, order = order => uv);
                assert!(uv.iter().all(|x| x.is_finite()), "{x}: {uv:?}");
            }
        }
    }
}
