use crate::emit::Real;

/// The 32-bit number nearest to pi / 2 lies above it.
const ROUNDED: f64 = std::f64::consts::FRAC_PI_2 as f32 as f64;

node! {
    /// Angle in radians whose tangent is the input, per component, from -pi/2 to pi/2.
    /// `arc_tangent2` tells all four quadrants apart. A colour keeps its alpha.
    arc_tangent in trigonometry per component,
    source "",
    inputs {
        /// A tangent.
        input: generic = 0.0;
    }
    outputs {
        /// The angle in radians.
        result: generic, in -ROUNDED..=ROUNDED;
    }
    body |e, i| i.input.atan()
}

#[cfg(test)]
mod tests {
    #[test]
    fn turns_tangents_back() {
        let close = crate::nodes::harness::assert_close;
        for x in [-1e30_f32, -1.0, -1e-30, 0.0, 0.3, 57.0, f32::MAX] {
            close(&[number!(input = x => result)], &[f64::from(x).atan()], 3e-7, 0.0);
        }
    }
}
