//! Perlin's improved noise by the published permutation, in three dimensions.
//!
//! Source: Perlin 2002, Improving Noise.

use super::gradient_noise::{between, fade, signed};
use crate::emit::{Emit, Int, Mask, Real, Table, Vector};

/// The published permutation of the numbers below 256.
pub static PERMUTATION: [f32; 256] = [
    151.0, 160.0, 137.0, 91.0, 90.0, 15.0, 131.0, 13.0, 201.0, 95.0, 96.0, 53.0, 194.0, 233.0, 7.0,
    225.0, 140.0, 36.0, 103.0, 30.0, 69.0, 142.0, 8.0, 99.0, 37.0, 240.0, 21.0, 10.0, 23.0, 190.0,
    6.0, 148.0, 247.0, 120.0, 234.0, 75.0, 0.0, 26.0, 197.0, 62.0, 94.0, 252.0, 219.0, 203.0,
    117.0, 35.0, 11.0, 32.0, 57.0, 177.0, 33.0, 88.0, 237.0, 149.0, 56.0, 87.0, 174.0, 20.0, 125.0,
    136.0, 171.0, 168.0, 68.0, 175.0, 74.0, 165.0, 71.0, 134.0, 139.0, 48.0, 27.0, 166.0, 77.0,
    146.0, 158.0, 231.0, 83.0, 111.0, 229.0, 122.0, 60.0, 211.0, 133.0, 230.0, 220.0, 105.0, 92.0,
    41.0, 55.0, 46.0, 245.0, 40.0, 244.0, 102.0, 143.0, 54.0, 65.0, 25.0, 63.0, 161.0, 1.0, 216.0,
    80.0, 73.0, 209.0, 76.0, 132.0, 187.0, 208.0, 89.0, 18.0, 169.0, 200.0, 196.0, 135.0, 130.0,
    116.0, 188.0, 159.0, 86.0, 164.0, 100.0, 109.0, 198.0, 173.0, 186.0, 3.0, 64.0, 52.0, 217.0,
    226.0, 250.0, 124.0, 123.0, 5.0, 202.0, 38.0, 147.0, 118.0, 126.0, 255.0, 82.0, 85.0, 212.0,
    207.0, 206.0, 59.0, 227.0, 47.0, 16.0, 58.0, 17.0, 182.0, 189.0, 28.0, 42.0, 223.0, 183.0,
    170.0, 213.0, 119.0, 248.0, 152.0, 2.0, 44.0, 154.0, 163.0, 70.0, 221.0, 153.0, 101.0, 155.0,
    167.0, 43.0, 172.0, 9.0, 129.0, 22.0, 39.0, 253.0, 19.0, 98.0, 108.0, 110.0, 79.0, 113.0,
    224.0, 232.0, 178.0, 185.0, 112.0, 104.0, 218.0, 246.0, 97.0, 228.0, 251.0, 34.0, 242.0, 193.0,
    238.0, 210.0, 144.0, 12.0, 191.0, 179.0, 162.0, 241.0, 81.0, 51.0, 145.0, 235.0, 249.0, 14.0,
    239.0, 107.0, 49.0, 192.0, 214.0, 31.0, 181.0, 199.0, 106.0, 157.0, 184.0, 84.0, 204.0, 176.0,
    115.0, 121.0, 50.0, 45.0, 127.0, 4.0, 150.0, 254.0, 138.0, 236.0, 205.0, 93.0, 222.0, 114.0,
    67.0, 29.0, 24.0, 72.0, 243.0, 141.0, 128.0, 195.0, 78.0, 66.0, 215.0, 61.0, 156.0, 180.0,
];

/// What stands at a position of the permutation, which goes round.
#[inline(always)]
fn permuted<E: Emit>(e: E, at: E::Int) -> E::Int {
    e.table(const { Table::new(&PERMUTATION) }, at & e.int(255)).to_int()
}

/// One octave: 0 where all coordinates are whole, between -1.04 and 1.04.
#[inline(always)]
pub fn permutation_noise<E: Emit>(e: E, position: Vector<E::Real>) -> E::Real {
    let whole = Vector { x: position.x.floor(), y: position.y.floor(), z: position.z.floor() };
    let near = position - whole;
    let (one, next) = (e.real(1.0), e.int(1));
    let far = Vector { x: near.x - one, y: near.y - one, z: near.z - one };
    let (x, y, z) = (whole.x.to_int(), whole.y.to_int(), whole.z.to_int());
    let (a, b) = (permuted(e, x) + y, permuted(e, x + next) + y);
    let (aa, ab) = (permuted(e, a) + z, permuted(e, a + next) + z);
    let (ba, bb) = (permuted(e, b) + z, permuted(e, b + next) + z);
    let (u, v, w) = (fade(near.x), fade(near.y), fade(near.z));
    let front = between(
        v,
        between(
            u,
            slope(e, permuted(e, aa), near.x, near.y, near.z),
            slope(e, permuted(e, ba), far.x, near.y, near.z),
        ),
        between(
            u,
            slope(e, permuted(e, ab), near.x, far.y, near.z),
            slope(e, permuted(e, bb), far.x, far.y, near.z),
        ),
    );
    let back = between(
        v,
        between(
            u,
            slope(e, permuted(e, aa + next), near.x, near.y, far.z),
            slope(e, permuted(e, ba + next), far.x, near.y, far.z),
        ),
        between(
            u,
            slope(e, permuted(e, ab + next), near.x, far.y, far.z),
            slope(e, permuted(e, bb + next), far.x, far.y, far.z),
        ),
    );
    between(w, front, back)
}

/// The product of (x, y, z) with the gradient of this number: one of the twelve from the middle of a cube
/// to its edges, four of them twice.
#[inline(always)]
fn slope<E: Emit>(e: E, number: E::Int, x: E::Real, y: E::Real, z: E::Real) -> E::Real {
    let number = number & e.int(15);
    let first = number.less(e.int(8)).select(x, y);
    let like_x = number.equal(e.int(12)) | number.equal(e.int(14));
    let second = number.less(e.int(4)).select(y, like_x.select(x, z));
    signed(number, 1, first) + signed(number, 2, second)
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_permutation_is_one() {
        let mut numbers = super::PERMUTATION.map(|number| number as usize);
        numbers.sort_unstable();
        assert_eq!(numbers, std::array::from_fn(|at| at));
    }
}
