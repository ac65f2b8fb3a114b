use crate::emit::functions::conventions::asin_clamped;

/// The 32-bit number nearest to pi / 2 lies above it.
const ROUNDED: f64 = std::f64::consts::FRAC_PI_2 as f32 as f64;

node! {
    /// Angle in radians whose sine is the input, per component, from -pi/2 to pi/2. Beyond -1
    /// and 1 it is that of the nearer end. A colour keeps its alpha.
    arc_sine in trigonometry per component,
    source "",
    inputs {
        /// A sine.
        input: generic = 0.0;
    }
    outputs {
        /// The angle in radians.
        result: generic, in -ROUNDED..=ROUNDED;
    }
    body |e, i| asin_clamped(i.input)
}

#[cfg(test)]
mod tests {
    #[test]
    fn turns_sines_back_and_clamps() {
        let close = crate::nodes::harness::assert_close;
        for x in [-1.0_f32, -0.999_999_9, -0.5, 1e-30, 0.469, 1.0] {
            close(&[number!(input = x => result)], &[f64::from(x).asin()], 3e-7, 0.0);
        }
        assert_eq!(number!(input = -3.0 => result), -std::f32::consts::FRAC_PI_2);
    }
}
