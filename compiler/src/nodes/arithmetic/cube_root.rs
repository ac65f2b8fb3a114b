use crate::emit::functions::conventions::pow_or_zero;
use crate::emit::{Mask, Real};

node! {
    /// Cube root, per component, with the sign of the input. A power of a third, and a step of
    /// Newton's that mends the third's rounding. A colour keeps its alpha.
    cube_root in arithmetic per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The root.
        result: generic;
    }
    body |e, i| {
        let zero = e.real(0.0);
        let size = i.input.absolute();
        let near = pow_or_zero(size, e.real(1.0 / 3.0));
        let error = near - (size / near).divide_or_zero(near);
        let root = error.mul_add(e.real(-1.0 / 3.0), near);
        let root = size.greater(zero).select(root, zero);
        i.input.less(zero).select(-root, root)
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_the_number_whose_cube_it_is() {
        let close = crate::nodes::harness::assert_close;
        for x in [0.0_f32, -8.0, 27.0, 1e-45, 1e-39, 0.3, -f32::MAX, 1.0_f32.next_up()] {
            close(&[number!(input = x => result)], &[f64::from(x).cbrt()], 2.4e-7, 0.0);
        }
    }
}
