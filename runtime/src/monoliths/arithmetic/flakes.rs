use std::f32::consts::TAU;

use glam::{IVec3, Vec3};
use phenomenon_compiler::emit::Real;
use phenomenon_compiler::emit::functions::conventions::{clamp_finite, log2_or_zero};
use phenomenon_compiler::emit::functions::flakes::{completed, flake_at, tilted};
use phenomenon_compiler::emit::scalar::{F32, Scalar};

use super::frames::Frames;
use super::kinds::{SameBits, Std, vec3, vector};

/// Flakes scattered in space: little tilted squares, one at most in each cell of the lattice of whole
/// numbers.
///
/// Which cells have one and how it is tilted follows from integers, so both kinds of arithmetic see the same
/// flakes, and the one on top is the same. Only where the rim of a flake runs is a matter of rounding: a few
/// points of a million fall to the other side of it.
pub trait Flakes {
    /// The unit normal of the flake that shows at a place, tilted from the surface's, which is of unit length;
    /// none where there is no flake. They cover about the share `coverage` of the surface.
    fn flake(place: Vec3, coverage: f32, roughness: f32, normal: Vec3) -> Option<Vec3>;
    /// The least whole power of two that is not below a number, from 1 on.
    fn doubled(least: f32) -> f32;
}

impl Flakes for Std {
    fn flake(place: Vec3, coverage: f32, roughness: f32, normal: Vec3) -> Option<Vec3> {
        let cell = topmost(place, coverage)?;
        // The slopes of facets of a GGX surface.
        let round = random([cell.x, cell.y, cell.z, 2, 0]) * TAU;
        let drawn = random([cell.x, cell.y, cell.z, 2, 1]);
        let sine = roughness * roughness * drawn.sqrt();
        let tangent = Self::any_tangent(normal);
        let across = tangent * round.cos() + normal.cross(tangent) * round.sin();
        Some((across * sine + normal * (1.0 - drawn).sqrt()).normalize_or_zero())
    }

    #[inline]
    fn doubled(least: f32) -> f32 {
        least.max(1.0).log2().ceil().exp2()
    }
}

impl Flakes for SameBits {
    #[inline(always)]
    fn flake(place: Vec3, coverage: f32, roughness: f32, normal: Vec3) -> Option<Vec3> {
        let flake = flake_at(Scalar, place.to_array().map(F32), F32(coverage));
        if flake.presence.0 > 0.0 {
            let none = vector(Vec3::ZERO);
            let frame = completed(vector(normal), none, none);
            return Some(vec3(tilted(flake.cell, F32(roughness), frame).normal));
        }
        None
    }

    #[inline(always)]
    fn doubled(least: f32) -> f32 {
        clamp_finite(log2_or_zero(F32(least).maximum(F32(1.0))).ceil().exp2()).0
    }
}

/// Half of a flake's edge, of the edge of its cell.
const REACH: f32 = 1.5 / 1.732_050_8;

/// A square above that of half a flake's diagonal: none reaches as far.
const OUT_OF_REACH: f32 = 2.2501;

/// The cell whose flake shows at a place, of its own and those beside it: that of the greatest height.
fn topmost(place: Vec3, coverage: f32) -> Option<IVec3> {
    let often = frequency(coverage);
    let whole = place.floor();
    let (own, near) = (whole.as_ivec3(), (place - whole).clamp(Vec3::ZERO, Vec3::ONE));
    let (mut greatest, mut shown) = (0.0, None);
    for number in 0..27 {
        let step = IVec3::new(number / 9 - 1, number / 3 % 3 - 1, number % 3 - 1);
        let (cell, from) = (own.wrapping_add(step), near - (step.as_vec3() + 0.5));
        if from.length_squared() > OUT_OF_REACH || random(cell.to_array()) > often {
            continue;
        }
        let height = random([cell.x, cell.y, cell.z, 3]);
        if height >= greatest && covers(cell, from) {
            (greatest, shown) = (height, Some(cell));
        }
    }
    // One at no height at all counts as none.
    shown.filter(|_| greatest > 0.0)
}

/// How many of the cells have a flake, for a share of the surface to be covered (MaterialX 1.39).
fn frequency(coverage: f32) -> f32 {
    let x = coverage.clamp(0.0, 1.0);
    let above = (x * -26.197_718 + 26.396_639) * x;
    let below = ((x * 85.538_57 - 102.350_69) * x - 101.426_35) * x + 118.450_82;
    above / below
}

/// Whether the flake of a cell covers a place, given from the middle of the cell. It is turned about z, and
/// mirrored so that z may point anywhere (Arvo 1992).
fn covers(cell: IVec3, from: Vec3) -> bool {
    let numbered = |number| random([cell.x, cell.y, cell.z, number]);
    let (sine, cosine) = (numbered(0) * TAU).sin_cos();
    let (round_sine, round_cosine) = (numbered(1) * TAU).sin_cos();
    let up = numbered(2) * 2.0;
    let out = up.sqrt();
    let mirror = Vec3::new(round_sine * out, round_cosine * out, (2.0 - up).sqrt());
    let along = mirror.x * cosine - mirror.y * sine;
    let across = mirror.x * sine + mirror.y * cosine;
    let axes = [
        mirror * along - Vec3::new(cosine, -sine, 0.0),
        mirror * across - Vec3::new(sine, cosine, 0.0),
        Vec3::new(mirror.x * mirror.z, mirror.y * mirror.z, 1.0 - up),
    ];
    axes.iter().all(|axis| axis.dot(from).abs() <= REACH)
}

/// A random number of integers, 0 to 1.
fn random<const N: usize>(numbers: [i32; N]) -> f32 {
    hash(numbers) as f32 / 4_294_967_296.0
}

/// 32 bits of three to five integers (Jenkins 2006, lookup3).
fn hash<const N: usize>(numbers: [i32; N]) -> u32 {
    let seed = 0xdead_beef_u32.wrapping_add(4 * N as u32 + 13);
    let [mut a, mut b, mut c] = [0, 1, 2].map(|at| seed.wrapping_add(numbers[at] as u32));
    if N > 3 {
        let stir = |x: &mut u32, y: u32, z: &mut u32, by: u32| {
            *x = x.wrapping_sub(*z) ^ z.rotate_left(by);
            *z = z.wrapping_add(y);
        };
        stir(&mut a, b, &mut c, 4);
        stir(&mut b, c, &mut a, 6);
        stir(&mut c, a, &mut b, 8);
        stir(&mut a, b, &mut c, 16);
        stir(&mut b, c, &mut a, 19);
        stir(&mut c, a, &mut b, 4);
        a = a.wrapping_add(numbers[3] as u32);
        b = b.wrapping_add(numbers.get(4).map_or(0, |fifth| *fifth as u32));
    }
    let finish = |x: &mut u32, y: u32, by: u32| *x = (*x ^ y).wrapping_sub(y.rotate_left(by));
    finish(&mut c, b, 14);
    finish(&mut a, c, 11);
    finish(&mut b, a, 25);
    finish(&mut c, b, 16);
    finish(&mut a, c, 4);
    finish(&mut b, a, 14);
    finish(&mut c, b, 24);
    c
}

#[cfg(test)]
mod tests {
    use phenomenon_compiler::testing::random::Random;

    use super::*;

    #[test]
    fn both_kinds_see_the_same_flakes() {
        let mut random = Random::new(5);
        let normal = Vec3::new(0.48, -0.6, 0.64);
        let (mut seen, mut apart) = (0, 0);
        for number in 0..8_000 {
            let reach = if number % 2 == 0 { 20.0 } else { 3000.0 };
            let at = Vec3::from_array([0; 3].map(|_| (random.unit() * 2.0 - 1.0) * reach));
            let coverage = random.unit();
            let roughness = random.unit();
            let by_std = Std::flake(at, coverage, roughness, normal);
            let same = SameBits::flake(at, coverage, roughness, normal);
            seen += usize::from(same.is_some());
            let agree = match (by_std, same) {
                (Some(by_std), Some(same)) => by_std.abs_diff_eq(same, 1e-5),
                (by_std, same) => by_std == same,
            };
            apart += usize::from(!agree);
        }
        assert!((3_200..4_800).contains(&seen), "{seen}");
        // At the rim of a flake.
        assert!(apart <= 3, "{apart}");
    }

    #[test]
    fn sizes_double_in_whole_steps() {
        for (least, expected) in
            [(0.0, 1.0), (1.0, 1.0), (1.01, 2.0), (2.0, 2.0), (2.5, 4.0), (700.0, 1024.0)]
        {
            assert_eq!([Std::doubled(least), SameBits::doubled(least)], [expected; 2]);
        }
    }
}
