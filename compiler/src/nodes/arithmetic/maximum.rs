use crate::emit::Real;

node! {
    /// The larger of two values, per component: `a > b ? a : b`. A colour keeps the alpha of `a`.
    maximum in arithmetic per component,
    source "",
    inputs {
        /// First value.
        a: generic = 0.0;
        /// Second value, taken where the two are equal or one is NaN.
        b: generic = 0.0;
    }
    outputs {
        /// The larger.
        result: generic;
    }
    body |e, i| i.a.maximum(i.b)
}

#[cfg(test)]
mod tests {
    #[test]
    fn takes_the_larger() {
        assert_eq!(
            numbers!(a = [1.0, 5.0, -1.0], b = [2.0, 4.0, -2.0] => result),
            [2.0, 5.0, -1.0]
        );
        assert_eq!(
            numbers!(a = [1.0, 5.0, 0.0, 0.5], b = [2.0, 4.0, 0.0, 0.9] => result),
            [2.0, 5.0, 0.0, 0.5]
        );
    }

    #[test]
    fn the_second_wins_ties_and_nan() {
        assert_eq!(number!(a = 0.0, b = -0.0 => result).to_bits(), (-0.0_f32).to_bits());
        assert_eq!(number!(a = f32::NAN, b = 2.0 => result), 2.0);
    }
}
