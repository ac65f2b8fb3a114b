use crate::emit::Real;
use crate::emit::functions::conventions::clamp_finite;

node! {
    /// The multiple of `step` not above, per component: `step floor(input / step)`. A step of 0
    /// gives 0. A colour keeps its alpha.
    snap in arithmetic per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
        /// Distance of the values it may have.
        step: scalar = 1.0, avoid zero;
    }
    outputs {
        /// The multiple.
        result: generic;
    }
    body |e, i| clamp_finite(i.input.divide_or_zero(i.step).floor() * i.step)
}

#[cfg(test)]
mod tests {
    #[test]
    fn goes_down_to_a_multiple() {
        for (x, step, snapped) in
            [(0.7, 0.25, 0.5), (-0.7, 0.25, -0.75), (5.0, 0.0, 0.0), (7.0, 2.0, 6.0)]
        {
            assert_eq!(number!(input = x, step = step => result), snapped);
        }
    }
}
