use crate::emit::functions::conventions::pow_or_zero;
use crate::emit::{Emit, Mask, Real, Vector};
use crate::nodes::finite::{SUMMAND, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Blends three values by the normal: `x` shows where it points along the x axis, and so on. The shares are
    /// `(|n| / (|n.x| + |n.y| + |n.z|))^(1 / blend)`, divided by their sum; `blend` 1 is a soft transition, near 0
    /// a hard one. What the normal has no part of is not evaluated: a floor reads one picture. Of
    /// colours the alpha is blended too; no normal gives 0.
    triplanar_blend in textures generic,
    source "MaterialX 1.39, triplanarprojection: blend",
    inputs {
        /// The normal, of any length.
        normal: vector = state(Field::Normal), in SUMMAND;
        /// Width of the transition; below 0.03 it counts as that.
        blend: scalar = 1.0, in UNIT;
        /// Value along the x axis.
        x: generic = 0.0, in SUMMAND, when i.normal.x.not_equal(e.real(0.0));
        /// Value along the y axis.
        y: generic = 0.0, in SUMMAND, when i.normal.y.not_equal(e.real(0.0));
        /// Value along the z axis.
        z: generic = 0.0, in SUMMAND, when i.normal.z.not_equal(e.real(0.0));
    }
    outputs {
        /// The blend.
        result: generic;
    }
    body |e, i| {
        let shares = shares(e, i.normal, i.blend);
        let (x, y, z) = (i.x.to_words(), i.y.to_words(), i.z.to_words());
        let mut sum = x;
        for k in 0..4 {
            let x = where_demanded(x[k], i.normal.x);
            let y = where_demanded(y[k], i.normal.y);
            let z = where_demanded(z[k], i.normal.z);
            sum[k] = shares.x.mul_add(x, shares.y.mul_add(y, shares.z * z));
        }
        Outputs { result: T::from_words(sum) }
    }
}

/// What was not demanded is anything.
#[inline(always)]
fn where_demanded<R: Real>(value: R, normal: R) -> R {
    let zero = normal.same(0.0);
    normal.equal(zero).select(zero, value)
}

/// How much of each axis there is, together 1.
#[inline(always)]
fn shares<E: Emit>(e: E, normal: Vector<E::Real>, blend: E::Real) -> Vector<E::Real> {
    // The largest becomes 1: no power of it vanishes.
    let largest = normal.largest();
    let along = normal.divided_by(largest);
    let exponent = e.real(1.0) / blend.maximum(e.real(0.03));
    let powers = Vector {
        x: pow_or_zero(along.x.absolute(), exponent),
        y: pow_or_zero(along.y.absolute(), exponent),
        z: pow_or_zero(along.z.absolute(), exponent),
    };
    powers.divided_by(powers.x + powers.y + powers.z)
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn shares_are_those_of_the_axes() {
        let of = |normal: [f32; 3], blend: f32| numbers!(normal = normal, blend = blend, x = [1.0, 0.0, 0.0], y = [0.0, 1.0, 0.0], z = [0.0, 0.0, 1.0] => result);
        assert_eq!(of([0.0, -2.0, 0.0], 1.0), [0.0, 1.0, 0.0]);
        assert_close(&of([1.0, -1.0, 2.0], 1.0), &[0.25, 0.25, 0.5], 1e-6, 0.0);
        assert_close(&of([1.0, -1.0, 2.0], 0.5), &[1.0 / 6.0, 1.0 / 6.0, 4.0 / 6.0], 1e-6, 0.0);
        assert_close(&of([0.9, 1.0, 0.0], 0.0), &[0.028_98, 0.971_02, 0.0], 1e-3, 0.0);
        assert_eq!(of([0.0; 3], 1.0), [0.0; 3]);
    }

    #[test]
    fn what_has_no_part_is_not_evaluated_and_does_not_show() {
        assert!(!demanded!(normal = [0.0, 1.0, -0.0] => x));
        assert!(demanded!(normal = [0.0, 1.0, -0.0] => y));
        let hidden = numbers!(normal = [0.0, 1.0, 0.0], x = [f32::NAN; 3], y = [2.0; 3] => result);
        assert_eq!(hidden, [2.0; 3]);
    }

    #[test]
    fn alpha_is_blended_too() {
        let clear = [0.0; 4];
        let mixed = numbers!(normal = [1.0, 1.0, 0.0], x = [1.0; 4], y = clear => result);
        assert_eq!(mixed, [0.5; 4]);
    }
}
