use crate::emit::functions::colors::srgb_encoded;

node! {
    /// A linear value encoded as sRGB, per component: `12.92 x` up to 0.0031308, `1.055 x^(1 /
    /// 2.4) - 0.055` above. It goes on above 1, and negative values are mirrored. A colour
    /// keeps its alpha. The renderer encodes what it writes into PNG files itself.
    linear_to_srgb in color per component,
    source "IEC 61966-2-1",
    inputs {
        /// The linear value.
        input: generic = 0.0;
    }
    outputs {
        /// The encoded value.
        result: generic;
    }
    body |e, i| srgb_encoded(i.input)
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_the_way_back() {
        let close = crate::nodes::harness::assert_close;
        for (encoded, linear) in [
            (0.0, 0.0_f32),
            (0.5, 0.214_041_14),
            (0.75, 0.522_521_55),
            (1.0, 1.0),
            (-0.5, -0.214_041_14),
        ] {
            close(&[number!(input = linear => result)], &[encoded], 5e-7, 0.0);
        }
        assert_eq!(number!(input = 1e-3 => result), 1e-3 * 12.92);
    }
}
