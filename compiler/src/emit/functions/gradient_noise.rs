//! Perlin's noise with gradients by a hash of the corner, in one to four dimensions.
//!
//! Source: Perlin 2002; the gradients of one, two and four dimensions and the factors that bring each
//! near -1..1 are those of OSL, which MaterialX and Cycles share.
//!
//! In numbers of 32 bits, u = 2^-24: the place within a cell is known to u, a gradient's product to 4 u,
//! `fade` to 11 u. A mix of two products that differ by at most 4 adds 44 u, its own roundings 3 u, and
//! the mixes of the second and third dimension differ by no more; so a value in three dimensions is known to
//! 4 + 3 · 47 = 145 u, which is 9 · 10^-6, and in four to 192 u. What is seen is some 2 · 10^-7. From 2^24
//! on coordinates are whole, and the noise is 0.

use super::hash::hash;
use crate::emit::{Emit, Int, Mask, Real};

/// The cell a coordinate lies in, and where within it, 0..1. Total: beyond the integers the last cell,
/// and 0 within it, as for NaN.
#[inline(always)]
pub fn cell_of<R: Real>(x: R) -> (R::Int, R) {
    let whole = x.floor();
    (whole.to_int(), (x - whole).saturate())
}

/// `t^3 (t (6 t - 15) + 10)`.
#[inline(always)]
pub fn fade<R: Real>(t: R) -> R {
    t * t * t * t.mul_add(t.mul_add(t.same(6.0), t.same(-15.0)), t.same(10.0))
}

/// From `a` at 0 to `b` at 1.
#[inline(always)]
pub fn between<R: Real>(t: R, a: R, b: R) -> R {
    t.mul_add(b - a, a)
}

/// The number, with its sign changed where this bit of `bits` is set.
#[inline(always)]
pub fn signed<I: Int>(bits: I, bit: i32, number: I::Real) -> I::Real {
    (bits & bits.same(bit)).equal(bits.same(0)).select(number, -number)
}

/// The product of a place with the gradient its corner has by `bits`.
#[inline(always)]
fn slope<I: Int, const D: usize>(bits: I, at: [I::Real; D]) -> I::Real {
    match D {
        1 => {
            let size = (bits & bits.same(7)).to_real() + 1.0;
            signed(bits, 8, size * at[0])
        }
        2 => {
            let first = (bits & bits.same(7)).less(bits.same(4));
            let (near, far) = (first.select(at[0], at[1]), first.select(at[1], at[0]));
            signed(bits, 1, near) + signed(bits, 2, far * 2.0)
        }
        3 => {
            let number = bits & bits.same(15);
            let first = number.less(bits.same(8)).select(at[0], at[1]);
            let like_x = number.equal(bits.same(12)) | number.equal(bits.same(14));
            let other = like_x.select(at[0], at[2]);
            let second = number.less(bits.same(4)).select(at[1], other);
            signed(number, 1, first) + signed(number, 2, second)
        }
        _ => {
            let number = bits & bits.same(31);
            let first = number.less(bits.same(24)).select(at[0], at[1]);
            let second = number.less(bits.same(16)).select(at[1], at[2]);
            let third = number.less(bits.same(8)).select(at[2], at[3]);
            signed(number, 1, first) + signed(number, 2, second) + signed(number, 4, third)
        }
    }
}

/// What brings the noise of each number of dimensions near -1..1.
const SCALE: [f64; 5] = [0.0, 0.25, 0.6616, 0.982, 0.8344];

/// Three noises at one place: the bits of a corner give each its gradient, the first from the lowest.
#[inline(always)]
pub fn gradient_noise<E: Emit, const D: usize>(e: E, at: [E::Real; D]) -> [E::Real; 3] {
    let mut cells = [[e.int(0); 2]; D];
    let mut ends = [[e.real(0.0); 2]; D];
    for axis in 0..D {
        let (cell, near) = cell_of(at[axis]);
        cells[axis] = [cell, cell + e.int(1)];
        ends[axis] = [near, near - 1.0];
    }
    let mut corners = [[e.real(0.0); 3]; 16];
    for (number, corner) in corners[..1 << D].iter_mut().enumerate() {
        let (mut cell, mut place) = ([e.int(0); D], [e.real(0.0); D]);
        for axis in 0..D {
            let end = number >> axis & 1;
            (cell[axis], place[axis]) = (cells[axis][end], ends[axis][end]);
        }
        let bits = hash(&cell);
        for (channel, value) in corner.iter_mut().enumerate() {
            *value = slope::<E::Int, D>(bits.shift_right(8 * channel as u32), place);
        }
    }
    for (axis, end) in ends.iter().enumerate() {
        let weight = fade(end[0]);
        for pair in 0..1 << (D - 1 - axis) {
            let [[ax, ay, az], [bx, by, bz]] = [corners[2 * pair], corners[2 * pair + 1]];
            corners[pair] =
                [between(weight, ax, bx), between(weight, ay, by), between(weight, az, bz)];
        }
    }
    let [x, y, z] = corners[0];
    [x * SCALE[D], y * SCALE[D], z * SCALE[D]]
}

/// How octaves are summed.
#[derive(Clone, Copy)]
pub struct Octaves<R> {
    /// How many.
    pub count: i32,
    /// Factor on the position from one to the next.
    pub lacunarity: R,
    /// Factor on the share from one to the next.
    pub gain: R,
    /// Whether magnitudes are summed.
    pub turbulent: bool,
}

/// Sums of octaves of [`gradient_noise`], not divided by the sum of their shares.
#[inline(always)]
pub fn fractal<E: Emit, const D: usize>(
    e: E,
    mut at: [E::Real; D],
    octaves: Octaves<E::Real>,
) -> [E::Real; 3] {
    let mut share = e.real(1.0);
    let mut sums = [e.real(0.0); 3];
    for octave in 0..octaves.count {
        if octave > 0 {
            share = share * octaves.gain;
            for coordinate in &mut at {
                *coordinate = *coordinate * octaves.lacunarity;
            }
        }
        let noise = gradient_noise(e, at);
        for channel in 0..3 {
            let noise = noise[channel];
            let noise = if octaves.turbulent { noise.absolute() } else { noise };
            sums[channel] = share.mul_add(noise, sums[channel]);
        }
    }
    sums
}
