use crate::emit::functions::conventions::clamp_finite;
use crate::emit::{Mask, Real};
use crate::nodes::finite::SUMMAND;

node! {
    /// A value of one range at the same place of another, per component: `out_low + (input -
    /// in_low) (out_high - out_low) / (in_high - in_low)`. It extrapolates, unless `clamped`.
    /// Where `in_low` equals `in_high` it is `out_low`, and what overflows is the largest
    /// number. A colour keeps its alpha. Blender clamps by default; MaterialX clamps in `range`
    /// only.
    remap in ranges per component,
    source "",
    inputs {
        /// Where to look.
        input: generic = 0.0, in SUMMAND;
        /// Where it is `out_low`.
        in_low: generic = 0.0, in SUMMAND;
        /// Where it is `out_high`.
        in_high: generic = 1.0, in SUMMAND;
        /// The value there.
        out_low: generic = 0.0, in SUMMAND;
        /// The value there.
        out_high: generic = 1.0, in SUMMAND;
        /// Whether it stays between `out_low` and `out_high`.
        clamped: boolean = false;
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| {
        let share = (i.input - i.in_low).divide_or_zero(i.in_high - i.in_low);
        let share = i.clamped.select(share.saturate(), share);
        clamp_finite(share.mul_add(i.out_high - i.out_low, i.out_low))
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn keeps_the_place() {
        let at = |x: f32, clamped: bool| number!(input = x, in_low = 1.0, in_high = 3.0, out_low = 10.0, out_high = 0.0, clamped = clamped => result);
        assert_eq!([at(1.0, false), at(2.0, false), at(5.0, false)], [10.0, 5.0, -10.0]);
        assert_eq!([at(0.0, true), at(2.0, true), at(5.0, true)], [10.0, 5.0, 0.0]);
        let flat = number!(input = 7.0, in_low = 2.0, in_high = 2.0, out_low = 0.25 => result);
        assert_eq!(flat, 0.25);
    }
}
