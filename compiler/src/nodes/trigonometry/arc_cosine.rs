use crate::emit::functions::conventions::acos_clamped;

/// The 32-bit number nearest to pi lies above it.
const ROUNDED: f64 = std::f64::consts::PI as f32 as f64;

node! {
    /// Angle in radians whose cosine is the input, per component, from 0 to pi. Beyond -1 and 1
    /// it is that of the nearer end. Of the cosine between two directions it loses half the
    /// digits near 0: take `arc_tangent2` of the lengths of the cross product and the dot
    /// product for small angles. A colour keeps its alpha.
    arc_cosine in trigonometry per component,
    source "",
    inputs {
        /// A cosine.
        input: generic = 0.0;
    }
    outputs {
        /// The angle in radians.
        result: generic, in 0.0..=ROUNDED;
    }
    body |e, i| acos_clamped(i.input)
}

#[cfg(test)]
mod tests {
    #[test]
    fn turns_cosines_back_and_clamps() {
        let close = crate::nodes::harness::assert_close;
        for x in [-1.0_f32, -0.5, 0.0, 0.7, 0.999_999_9, 1.0] {
            close(&[number!(input = x => result)], &[f64::from(x).acos()], 3e-7, 1e-12);
        }
        assert_eq!(number!(input = 2.0 => result), 0.0);
        assert_eq!(number!(input = -2.0 => result), std::f32::consts::PI);
    }
}
