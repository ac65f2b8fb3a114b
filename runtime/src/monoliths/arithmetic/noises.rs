use glam::Vec3;
use phenomenon_compiler::emit::functions::permutation_noise::{PERMUTATION, permutation_noise};
use phenomenon_compiler::emit::scalar::Scalar;

use super::kinds::{SameBits, Std, vector};

/// Noises.
pub trait Noises {
    /// Perlin's improved noise: 0 where all coordinates are whole, between -1.04 and 1.04.
    fn perlin(position: Vec3) -> f32;
    /// `sum + share value`.
    fn added(sum: f32, share: f32, value: f32) -> f32;

    /// Octaves of noise, each twice as fine as the one before and `gain` times as strong.
    #[inline(always)]
    fn perlin_octaves(mut position: Vec3, octaves: usize, gain: f32) -> f32 {
        let (mut sum, mut share) = (0.0, 1.0);
        for _ in 0..octaves {
            sum = Self::added(sum, share, Self::perlin(position));
            position *= 2.0;
            share *= gain;
        }
        sum
    }
}

impl Noises for Std {
    fn perlin(position: Vec3) -> f32 {
        let whole = position.floor();
        let near = position - whole;
        let far = near - 1.0;
        let [x, y, z] = whole.to_array().map(|corner| corner as i32 as usize & 255);
        let (left, right) = (permuted(x) + y, permuted(x + 1) + y);
        let columns = [left, right, left + 1, right + 1].map(|at| permuted(at) + z);
        let fade = near * near * near * (near * (near * 6.0 - 15.0) + 10.0);
        let layer = |depth: usize, z: f32| {
            let [low_left, low_right, high_left, high_right] =
                columns.map(|column| permuted(column + depth));
            let low = between(
                gradient(low_left, near.x, near.y, z),
                gradient(low_right, far.x, near.y, z),
                fade.x,
            );
            let high = between(
                gradient(high_left, near.x, far.y, z),
                gradient(high_right, far.x, far.y, z),
                fade.x,
            );
            between(low, high, fade.y)
        };
        between(layer(0, near.z), layer(1, far.z), fade.z)
    }

    #[inline]
    fn added(sum: f32, share: f32, value: f32) -> f32 {
        sum + share * value
    }
}

impl Noises for SameBits {
    #[inline(always)]
    fn perlin(position: Vec3) -> f32 {
        permutation_noise(Scalar, vector(position)).0
    }

    #[inline(always)]
    fn added(sum: f32, share: f32, value: f32) -> f32 {
        share.mul_add(value, sum)
    }
}

/// The permutation twice over, so that no sum of two of its numbers leaves it.
static TWICE: [u8; 512] = {
    let mut twice = [0; 512];
    let mut at = 0;
    while at < 512 {
        twice[at] = PERMUTATION[at & 255] as u8;
        at += 1;
    }
    twice
};

fn permuted(at: usize) -> usize {
    usize::from(TWICE[at])
}

fn between(a: f32, b: f32, share: f32) -> f32 {
    a + share * (b - a)
}

/// The product of a place in the cube with one of the twelve ways from its middle to its edges.
fn gradient(number: usize, x: f32, y: f32, z: f32) -> f32 {
    let first = if number & 15 < 8 { x } else { y };
    let second = match number & 15 {
        0..4 => y,
        12 | 14 => x,
        _ => z,
    };
    let first = if number & 1 == 0 { first } else { -first };
    if number & 2 == 0 { first + second } else { first - second }
}

#[cfg(test)]
mod tests {
    use phenomenon_compiler::testing::random::Random;

    use super::*;

    #[test]
    fn both_kinds_have_the_same_noise() {
        // Each is known to 9e-6: the mixes of corners cancel.
        let mut random = Random::new(11);
        let mut coordinate = |reach: f32| (random.unit() * 2.0 - 1.0) * reach;
        for reach in [0.5, 3.0, 300.0, 70_000.0] {
            for _ in 0..2000 {
                let at = Vec3::new(coordinate(reach), coordinate(reach), coordinate(reach));
                for at in [at, at.floor(), at.with_y(at.y.floor())] {
                    let (by_std, same) = (Std::perlin(at), SameBits::perlin(at));
                    assert!((by_std - same).abs() < 1e-5, "{by_std} {same} at {at}");
                }
                let [by_std, same] =
                    [Std::perlin_octaves(at, 3, 0.6), SameBits::perlin_octaves(at, 3, 0.6)];
                assert!((by_std - same).abs() < 2e-5, "{by_std} {same} at {at}");
            }
        }
    }
}
