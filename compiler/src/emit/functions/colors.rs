//! Colours in other models: hue, saturation and value or lightness, and encoded ones.

use super::shaping::signed_power;
use crate::emit::{Color, Mask, Real};

/// Weights of relative luminance, ITU-R BT.709.
pub const LUMINANCE: [f64; 3] = [0.2126, 0.7152, 0.0722];

/// Relative luminance of a scene-linear Rec. 709 colour.
#[inline(always)]
pub fn luminance<R: Real>(color: Color<R>) -> R {
    sum(color, &LUMINANCE)
}

/// The components of the pure hue, which is in turns and wraps.
#[inline(always)]
pub fn pure_hue<R: Real>(hue: R) -> [R; 3] {
    let two = hue.same(2.0);
    let sextants = (hue - hue.floor()) * 6.0;
    [
        ((sextants - 3.0).absolute() - 1.0).saturate(),
        (two - (sextants - 2.0).absolute()).saturate(),
        (two - (sextants - 4.0).absolute()).saturate(),
    ]
}

/// A component from that of the pure hue: `value (1 - saturation (1 - pure))`.
#[inline(always)]
pub fn of_hue<R: Real>(pure: R, saturation: R, value: R) -> R {
    let one = pure.same(1.0);
    // saturation + (1 - saturation) need not round to 1.
    let kept = pure.mul_add(saturation, one - saturation);
    value * pure.equal(one).select(one, kept)
}

/// Hue of a colour in turns, its largest and its smallest component. The hue of grey is 0.
#[derive(Clone, Copy, Debug)]
pub struct Hue<R> {
    /// In turns, from 0 to 1.
    pub hue: R,
    /// The largest component.
    pub largest: R,
    /// The smallest component.
    pub smallest: R,
}

/// The hue of a colour.
#[inline(always)]
pub fn hue_of<R: Real>(color: Color<R>) -> Hue<R> {
    let (r, g, b) = (color.r, color.g, color.b);
    let zero = r.same(0.0);
    let largest = r.maximum(g).maximum(b);
    let smallest = r.minimum(g).minimum(b);
    let chroma = largest - smallest;
    // From green to blue the sextants count from 2, from blue to red from 4.
    let of_blue = (r - g).divide_or_zero(chroma) + 4.0;
    let of_green = (b - r).divide_or_zero(chroma) + 2.0;
    let of_red = (g - b).divide_or_zero(chroma);
    let sextants = g.equal(largest).select(of_green, of_blue);
    let sextants = r.equal(largest).select(of_red, sextants);
    let turns = sextants * (1.0 / 6.0);
    let turns = turns.less(zero).select(turns + 1.0, turns);
    let hue = chroma.greater(zero).select(turns, zero);
    Hue { hue, largest, smallest }
}

/// Hue in turns, saturation and value. Of a colour without a component above zero, hue and saturation
/// are 0.
#[inline(always)]
pub fn to_hsv<R: Real>(color: Color<R>) -> [R; 3] {
    let Hue { hue, largest, smallest } = hue_of(color);
    let zero = hue.same(0.0);
    let is_lit = largest.greater(zero);
    let saturation = (largest - smallest).divide_or_zero(largest);
    [is_lit.select(hue, zero), is_lit.select(saturation, zero), largest]
}

/// The colour of a hue in turns, a saturation and a value.
#[inline(always)]
pub fn from_hsv<R: Real>([hue, saturation, value]: [R; 3], alpha: R) -> Color<R> {
    let [r, g, b] = pure_hue(hue);
    Color {
        r: of_hue(r, saturation, value),
        g: of_hue(g, saturation, value),
        b: of_hue(b, saturation, value),
        a: alpha,
    }
}

/// A component of IEC 61966-2-1 (sRGB), made linear; negative ones are mirrored.
#[inline(always)]
pub fn srgb_decoded<R: Real>(x: R) -> R {
    let zero = x.same(0.0);
    let size = x.absolute();
    let curve = signed_power((size + 0.055) * (1.0 / 1.055), x.same(2.4));
    let linear = size.less_equal(x.same(0.04045)).select(size / 12.92, curve);
    x.less(zero).select(-linear, linear)
}

/// A linear component, encoded by IEC 61966-2-1 (sRGB); negative ones are mirrored.
#[inline(always)]
pub fn srgb_encoded<R: Real>(x: R) -> R {
    let zero = x.same(0.0);
    let size = x.absolute();
    let curve = signed_power(size, x.same(1.0 / 2.4)) * 1.055 - 0.055;
    let encoded = size.less_equal(x.same(0.003_130_8)).select(size * 12.92, curve);
    x.less(zero).select(-encoded, encoded)
}

/// Three weighted sums of the components of a colour.
#[inline(always)]
pub fn weighted<R: Real>(color: Color<R>, [red, green, blue]: &[[f64; 3]; 3]) -> Color<R> {
    Color { r: sum(color, red), g: sum(color, green), b: sum(color, blue), a: color.a }
}

/// The weighted sum of the components of a colour.
#[inline(always)]
fn sum<R: Real>(color: Color<R>, &[red, green, blue]: &[f64; 3]) -> R {
    let rest = color.g.mul_add(color.g.same(green), color.b * blue);
    color.r.mul_add(color.r.same(red), rest)
}

/// Linear Rec. 709 of CIE XYZ: the primaries of ITU-R BT.709, and white at x = 0.3127, y = 0.3290.
pub const XYZ_TO_REC709: [[f64; 3]; 3] = [
    [3.240_969_941_9, -1.537_383_177_57, -0.498_610_760_293],
    [-0.969_243_636_281, 1.875_967_501_51, 0.041_555_057_407_2],
    [0.055_630_079_697, -0.203_976_958_889, 1.056_971_514_24],
];
