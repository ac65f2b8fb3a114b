use crate::emit::functions::conventions::clamp_finite;
use crate::emit::{Real, Transform, Vector};
use crate::nodes::finite::FACTOR;
use crate::values::Literal;

node! {
    /// The transform that undoes another, by cofactors. One that flattens space has none; the
    /// result then is all zeros, and takes every point to the origin. Rows are divided by the
    /// largest component first, so that determinants of tiny and huge transforms neither vanish
    /// nor overflow.
    inverse in transforms,
    source "",
    inputs {
        /// The transform.
        transform: transform = Literal::IDENTITY, in FACTOR;
    }
    outputs {
        /// Its inverse.
        result: transform;
    }
    body |e, i| {
        let (x, y, z) = (i.transform.x, i.transform.y, i.transform.z);
        let largest = x.largest().maximum(y.largest()).maximum(z.largest());
        let (x, y, z) = (x.divided_by(largest), y.divided_by(largest), z.divided_by(largest));
        let (of_x, of_y, of_z) = (y.cross(z), z.cross(x), x.cross(y));
        let determinant = x.dot(of_x);
        let rows = [[of_x.x, of_y.x, of_z.x], [of_x.y, of_y.y, of_z.y], [of_x.z, of_y.z, of_z.z]];
        let mut result = Transform {
            x: row(rows[0], determinant, largest),
            y: row(rows[1], determinant, largest),
            z: row(rows[2], determinant, largest),
            translation: i.transform.translation,
        };
        let back = result.vector(-i.transform.translation);
        result.translation =
            Vector { x: clamp_finite(back.x), y: clamp_finite(back.y), z: clamp_finite(back.z) };
        Outputs { result }
    }
}

/// A row of the inverse.
#[inline(always)]
fn row<R: Real>([x, y, z]: [R; 3], determinant: R, largest: R) -> Vector<R> {
    Vector {
        x: quotient(x, determinant, largest),
        y: quotient(y, determinant, largest),
        z: quotient(z, determinant, largest),
    }
}

/// A component of the inverse.
#[inline(always)]
fn quotient<R: Real>(cofactor: R, determinant: R, largest: R) -> R {
    clamp_finite(cofactor.divide_or_zero(determinant).divide_or_zero(largest))
}

#[cfg(test)]
mod tests {
    use crate::values::Literal;

    #[test]
    fn undoes_it() {
        let rows =
            [0.0, 2.0, 0.0, 0.0, -4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5, 0.0, 8.0, 2.0, 1.0, 1.0];
        let inverse = numbers!(transform = Literal::Transform(rows) => result);
        let expected =
            [0.0, -0.25, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, -1.0, 2.0, -2.0, 1.0];
        assert_eq!(inverse, expected);
    }

    #[test]
    fn tiny_ones_have_one_and_flat_ones_zeros() {
        let scaled = |s: f32| {
            Literal::Transform([
                s, 0.0, 0.0, 0.0, 0.0, s, 0.0, 0.0, 0.0, 0.0, s, 0.0, 0.0, 0.0, 0.0, 1.0,
            ])
        };
        assert_eq!(numbers!(transform = scaled(1e-18) => result)[0], 1e18);
        let none = numbers!(transform = scaled(0.0) => result);
        assert!(none[..15].iter().all(|&word| word == 0.0) && none[15] == 1.0);
    }
}
