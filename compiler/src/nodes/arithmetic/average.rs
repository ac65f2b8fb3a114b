use crate::emit::Real;

node! {
    /// Arithmetic mean `a / 2 + b / 2`, per component: halved first, so that no sum overflows.
    /// A colour keeps the alpha of `a`. `mix` has other weights.
    average in arithmetic per component,
    source "",
    inputs {
        /// First value.
        a: generic = 0.0;
        /// Second value.
        b: generic = 0.0;
    }
    outputs {
        /// What lies half way.
        result: generic;
    }
    body |e, i| i.a.mul_add(e.real(0.5), i.b * 0.5)
}

#[cfg(test)]
mod tests {
    #[test]
    fn lies_half_way() {
        assert_eq!(number!(a = 1.0, b = 4.0 => result), 2.5);
        assert_eq!(number!(a = f32::MAX, b = f32::MAX => result), f32::MAX);
        assert_eq!(
            numbers!(a = [1.0, 2.0, 3.0, 0.5], b = [3.0, 2.0, 1.0, 1.0] => result),
            [2.0, 2.0, 2.0, 0.5]
        );
    }
}
