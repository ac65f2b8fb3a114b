//! The sRGB transfer function (IEC 61966-2-1).

/// Encodes a linear value; clamps to 0..=1, NaN to 0.
pub fn srgb_encoded(linear: f32) -> f32 {
    if linear >= 1.0 {
        1.0
    } else if linear > 0.003_130_8 {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    } else if linear > 0.0 {
        linear * 12.92
    } else {
        0.0
    }
}

/// Decodes an encoded value in 0..=1; what is beyond goes on as the function does.
pub fn srgb_decoded(encoded: f32) -> f32 {
    if encoded <= 0.040_45 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
}

/// The encoded value in 8 bits, rounded to nearest.
pub(super) fn srgb_byte(linear: f32) -> u8 {
    (srgb_encoded(linear) * 255.0 + 0.5) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_byte_survives_the_round_trip() {
        for byte in 0..=255_u8 {
            assert_eq!(srgb_byte(srgb_decoded(f32::from(byte) / 255.0)), byte);
        }
    }

    #[test]
    fn what_is_out_of_range_is_clamped() {
        assert_eq!([f32::NAN, -1.0, -0.0, f32::NEG_INFINITY].map(srgb_byte), [0; 4]);
        assert_eq!([1.0, 7.0, f32::INFINITY].map(srgb_byte), [255; 3]);
        assert_eq!(srgb_encoded(f32::from_bits(1)), 12.92 * f32::from_bits(1));
    }
}
