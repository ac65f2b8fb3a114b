use crate::emit::Real;

node! {
    /// The smaller of two values, per component: `a < b ? a : b`. A colour keeps the alpha of `a`.
    minimum in arithmetic per component,
    source "",
    inputs {
        /// First value.
        a: generic = 0.0;
        /// Second value, taken where the two are equal or one is NaN.
        b: generic = 0.0;
    }
    outputs {
        /// The smaller.
        result: generic;
    }
    body |e, i| i.a.minimum(i.b)
}

#[cfg(test)]
mod tests {
    #[test]
    fn takes_the_smaller() {
        assert_eq!(
            numbers!(a = [1.0, 5.0, -1.0], b = [2.0, 4.0, -1.0] => result),
            [1.0, 4.0, -1.0]
        );
        assert_eq!(
            numbers!(a = [1.0, 5.0, 0.0, 0.5], b = [2.0, 4.0, 0.0, 0.1] => result),
            [1.0, 4.0, 0.0, 0.5]
        );
    }

    #[test]
    fn the_second_wins_ties_and_nan() {
        assert_eq!(number!(a = 0.0, b = -0.0 => result).to_bits(), (-0.0_f32).to_bits());
        assert_eq!(number!(a = -0.0, b = 0.0 => result).to_bits(), 0.0_f32.to_bits());
        assert_eq!(number!(a = f32::NAN, b = 2.0 => result), 2.0);
    }
}
