//! One pixel: mantissas of red, green and blue, and an exponent.
//!
//! A value is `mantissa 2^(exponent - 136)`, and 0 where the exponent is 0: so exactly what is written is
//! what is read, powers of two among them. Radiance itself adds half a step when it reads, because it
//! cuts when it writes; we round to nearest instead, as most other writers and readers do.

/// What is added to the exponent: 128, and 8 for the bits of the mantissa.
const BIAS: i32 = 136;

/// The three values of a pixel; in f64 they are exact.
pub(super) fn decoded([red, green, blue, exponent]: [u8; 4]) -> [f64; 3] {
    if exponent == 0 {
        return [0.0; 3];
    }
    let step = power_of_two(i32::from(exponent) - BIAS);
    [red, green, blue].map(|mantissa| f64::from(mantissa) * step)
}

/// The pixel nearest to three values: the largest has all 8 bits of its mantissa, the others are
/// rounded to the same step, ties away from 0. Negative values and NaN become 0, what is too large
/// (infinity as well) 255 2^119. Where no value reaches 2^-128 the pixel is black.
pub(super) fn encoded(color: [f32; 3]) -> [u8; 4] {
    let color = color.map(|value| if value > 0.0 { f64::from(value) } else { 0.0 });
    let largest = color[0].max(color[1]).max(color[2]);
    if largest < power_of_two(-128) {
        return [0; 4];
    }
    // No f32 is subnormal in f64, so the bits have the exponent: largest = 1.f 2^(bits - 1023), and
    // a mantissa of 128 to 255 takes seven bits before the point.
    let mut exponent = ((largest.to_bits() >> 52) as i32 - 1023 + 1 + 128).min(255);
    let scaled = |exponent: i32| {
        let step = power_of_two(exponent - BIAS);
        color.map(|value| (value / step).round().min(256.0) as u16)
    };
    let mut mantissas = scaled(exponent);
    if mantissas.contains(&256) && exponent < 255 {
        // Rounded up to the next power of two: all are rounded again, from the values themselves.
        exponent += 1;
        mantissas = scaled(exponent);
    }
    let [red, green, blue] = mantissas.map(|mantissa| mantissa.min(255) as u8);
    [red, green, blue, exponent as u8]
}

/// 2 to a power within the normal numbers of f64.
fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn back(color: [f32; 3]) -> [f32; 3] {
        decoded(encoded(color)).map(|x| x as f32)
    }

    /// 255 2^119.
    const LARGEST: f32 = 1.694_765_7e38;

    #[test]
    fn every_pixel_with_a_full_mantissa_is_written_as_it_was_read() {
        for exponent in 1..=255 {
            for mantissa in 128..=255 {
                for [red, green, blue] in
                    [[mantissa, 0, 1], [1, mantissa, 127], [mantissa, 255, 0], [0, 64, mantissa]]
                {
                    let pixel = [red, green, blue, exponent];
                    let color = decoded(pixel).map(|x| x as f32);
                    assert_eq!(color.map(f64::from), decoded(pixel), "f32 holds it exactly");
                    assert_eq!(encoded(color), pixel);
                }
            }
        }
    }

    #[test]
    fn values_are_rounded_to_the_nearest_step() {
        // Of every 9,973rd positive number.
        for bits in (0..f32::INFINITY.to_bits()).step_by(9_973) {
            let value = f32::from_bits(bits);
            let near = f64::from(back([value, 0.0, 0.0])[0]);
            let [_, _, _, exponent] = encoded([value, 0.0, 0.0]);
            let step = power_of_two(i32::from(exponent.max(1)) - BIAS);
            let error = (near - f64::from(value)).abs();
            match value {
                ..2.938_735_9e-39 => assert_eq!(near, 0.0, "{value:e}"),
                _ if value > LARGEST => assert_eq!(near as f32, LARGEST),
                _ => assert!(error <= step / 2.0, "{value:e} became {near:e}"),
            }
        }
    }

    #[test]
    fn hard_values_have_a_meaning() {
        assert_eq!(back([1e-45, 1e-45, 1e-45]), [0.0; 3]);
        assert_eq!(back([0.0, -0.0, -1.0]), [0.0; 3]);
        assert_eq!(back([f32::NAN, 0.5, f32::NEG_INFINITY]), [0.0, 0.5, 0.0]);
        assert_eq!(LARGEST, 255.0 * 2.0_f32.powi(119));
        assert_eq!(back([3e38, f32::MAX, f32::INFINITY]), [LARGEST; 3]);
        assert_eq!(back([LARGEST, 1.0, f32::INFINITY]), [LARGEST, 0.0, LARGEST]);
        // 0.999 lies between 255 and 256 of 256 steps; 255.744 is nearer to 256.
        assert_eq!(back([0.999; 3]), [1.0; 3]);
        // The carry makes the steps of the others twice as wide: 0.5 + 3/256 is a tie of the wide ones.
        assert_eq!(back([0.999, 131.0 / 256.0, 0.0]), [1.0, 132.0 / 256.0, 0.0]);
        assert_eq!(back([1e-3, 1e3, 0.5]), [0.0, 1000.0, 0.0]);
    }
}
