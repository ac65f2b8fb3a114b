use crate::emit::functions::colors::srgb_decoded;
use crate::emit::functions::conventions::clamp_finite;

node! {
    /// A value encoded as sRGB, made linear, per component: `x / 12.92` up to 0.04045, `((x +
    /// 0.055) / 1.055)^2.4` above. It goes on above 1, and negative values are mirrored. A
    /// colour keeps its alpha. Literals and pictures are decoded when they are read: this is
    /// for values that are computed.
    srgb_to_linear in color per component,
    source "IEC 61966-2-1",
    inputs {
        /// The encoded value.
        input: generic = 0.0;
    }
    outputs {
        /// The linear value.
        result: generic;
    }
    body |e, i| clamp_finite(srgb_decoded(i.input))
}

#[cfg(test)]
mod tests {
    #[test]
    fn agrees_with_the_standard() {
        let close = crate::nodes::harness::assert_close;
        for (encoded, linear) in [
            (0.0_f32, 0.0),
            (0.04, 0.04 / 12.92),
            (0.5, 0.214_041_140_482_232_55),
            (0.75, 0.522_521_553_968_392_1),
            (1.0, 1.0),
            (-0.5, -0.214_041_140_482_232_55),
        ] {
            close(&[number!(input = encoded => result)], &[linear], 5e-7, 0.0);
        }
        assert_eq!(number!(input = f32::MAX => result), f32::MAX);
    }
}
