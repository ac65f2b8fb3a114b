use crate::emit::Real;

node! {
    /// Tangent of an angle in radians, per component. No number is a quarter turn, so it is
    /// never infinite; near one it is huge, and angles beyond 2^18 count as 0. A colour keeps
    /// its alpha.
    tangent in trigonometry per component,
    source "",
    inputs {
        /// The angle.
        input: generic = 0.0, unit "radians";
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| i.input.tan()
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_sine_over_cosine() {
        assert_eq!(number!(input = 0.0 => result), 0.0);
        let close = crate::nodes::harness::assert_close;
        for x in [-1.5_f32, -0.3, 1e-20, 0.785, 1.57, 3.0, 100.0] {
            close(&[number!(input = x => result)], &[f64::from(x).tan()], 4e-7, 0.0);
        }
        assert!(number!(input = std::f32::consts::FRAC_PI_2 => result).abs() > 1e7);
    }
}
